#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/files/journal.h"
#include "app/files/manifest.h"
#include "app/files/output_pattern.h"
#include "app/files/outputs.h"
#include "app/frames/frames.h"
#include "app/options/light_wish.h"
#include "render/backend.h"
#include "render/view.h"

namespace flatray {

/// Pictures to make of one scene.
struct RenderJob {
  Scene scene;
  std::string name;  ///< plain name of the scene, for {scene}
  OutputPattern output;
  std::vector<unsigned> frames;  ///< of this shard, sorted
  unsigned last_frame = 1;       ///< of all shards
  Shard shard;
  std::optional<PixelBox> crop;
  std::uint64_t seed = 0;
  bool keep_all = false;
  std::shared_ptr<const Renderer> renderer = nullptr;  ///< null: the software back end
  const Tracer* tracer = nullptr;                      ///< of its rays; null: the one of choice
  std::optional<ViewRequest> view = std::nullopt;      ///< drawn instead of the picture
  LightWish light{};

  std::filesystem::path path(unsigned frame) const { return output.path(name, frame); }
  std::filesystem::path folder() const { return folder_of(path(1)); }
  std::filesystem::path manifest() const { return manifest_path(folder(), shard); }
  /// Whether a record is of this pattern, and of one of these frames.
  bool names(const FrameRecord& record) const {
    return record.file == path(record.frame).filename();
  }
  bool makes(const FrameRecord& record) const;
  /// Size of the pictures.
  PixelBox picture() const {
    return crop.value_or(PixelBox{0, 0, scene.film.width, scene.film.height});
  }
  /// Whether lamps light it: views show none.
  bool has_light() const { return !scene.lamps.empty() && !view; }
  /// Name of the back end, with all that its pixels depend on.
  std::string backend() const { return renderer ? renderer->description() : "software"; }
  /// Everything a byte of the pictures depends on but the frame, and a hash of it.
  Fields setting() const;
  std::string fingerprint() const;
  /// Everything a film depends on but its rounds.
  Fields film_setting(unsigned frame) const;
};

/// How frames are spread over threads: many small ones side by side, large ones one after another
/// by tiles.
struct Spread {
  unsigned frames_at_once, threads_each;
};
Spread spread(const RenderJob& job, std::size_t frame_count, unsigned threads);

/// Bytes the pictures of a render take at its peak, with what lies still in them, as announced by
/// --dry-run and explain. The scene and its outlines come on top: `flatray help limits`.
std::uint64_t picture_bytes_at_once(const RenderJob& job, std::size_t frame_count,
                                    unsigned threads);

/// What is to be done of a job.
struct Work {
  const RenderJob* job;
  Records kept;                  ///< with --resume: of frames that are whole, from this very job
  std::vector<unsigned> frames;  ///< still to make
  /// Lines of manifests as it was planned. Those that runs of the same setting add since are true.
  std::set<std::string> planned_on{};
  Records recorded{};  ///< the same, as records
};
/// Reads records and pictures, and writes nothing.
Result<Work> plan_work(const RenderJob& job, bool resume, unsigned threads);

/// Refuses what would go wrong where the files of a job are to be; writes nothing. `warnings` tells of
/// records in the same pattern that stay and are from another scene or setting.
/// Error   Trouble::output: what stands in its way is not its own; that of expect_films.
Result<void> expect_place(const Work& work, const Outputs& outputs, Diagnostics& warnings);

/// What a run of a sequence holds until it ends.
struct Hold {
  Claim claim;             ///< to the pattern
  const Outputs* outputs;  ///< says what lists may be replaced
};
/// Error   Trouble::output: another run is at work on the pattern.
Result<Hold> hold_pattern(const RenderJob& job, const Outputs& outputs);

struct JobResult {
  std::vector<FrameRecord> written;  ///< by frame
  std::vector<double> seconds;       ///< each took
  Diagnostics problems;              ///< why writing stopped
  bool ends = false;                 ///< the scene has no frames beyond
  DrawCounts drawn{};                ///< by the software back end
  std::size_t encoded = 0;           ///< pictures; the others have the bytes of one before
  Diagnostics warnings{};            ///< of light that was lost

  /// The frames that follow. Of problems the first is kept: all threads meet the same full disk.
  void add(JobResult&& more);
};
/// Draws and writes the frames of `work`, each with its line of the manifest once it is whole. Stops
/// early, whole frames kept, when interrupted, when a file cannot be written or the claim is lost.
/// `done` is told of every frame, and `told` how far the light of one has come, by any thread.
/// Before the first file has its name the records are made true for what comes, those of frames to be
/// made gone, so that a stop at any moment leaves them so. Others' stay.
using Told = std::function<void(const std::string&)>;
JobResult run_job(const Work& work, unsigned threads, const std::function<void()>& done,
                  const Hold* hold = nullptr, const Told& told = {});

/// One picture as the bytes of its file. Error   what the job's back end cannot draw.
Result<std::vector<std::byte>> picture_bytes(const RenderJob& job, unsigned frame,
                                             unsigned threads);

}  // namespace flatray
