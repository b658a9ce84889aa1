#pragma once
#include <functional>

#include "geom/bounds.h"
#include "render/light/light_error.h"
#include "render/pass.h"
#include "transport/light/backward.h"

namespace flatray {

/// Which rounds of a frame's light are traced: of those that the scene asks for every `shards`-th
/// from the `shard`-th on, until one of the aims is reached.
struct LightGoal {
  std::uint64_t shard = 0, shards = 1;
  double seconds = kInfinity;  ///< no round is begun later
  double error = 0;            ///< relative standard error of the picture: enough
  /// Told after each round that has been traced, by one thread; the error where it has been asked.
  std::function<void(const TracedLight&, std::optional<double> error)> told{};
};

/// What is to be said of a frame's light.
struct LightReport {
  LightCounts counts{};
  std::uint64_t rounds = 0;
  std::optional<double> error{};                       ///< relative standard error
  std::vector<std::vector<std::int64_t>> scrambles{};  ///< their sums, where there are several
  double film_unit = 0;
};
LightReport report_of(const TracedLight& light);

/// Light as it is shown, and what is to be said of it.
struct ShownLight {
  std::shared_ptr<const LightPicture> picture;
  LightReport report;
};
ShownLight show_light(const Timeline& timeline, const FrameState& state, const Tracer* tracer,
                      const LightRun& run);

/// The light of a frame, traced to the goal; `so_far` is of the same frame, seed and settings.
TracedLight trace_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                              std::uint64_t seed, unsigned threads, bool (*stop)(),
                              const LightGoal& goal = {}, TracedLight so_far = {});

/// The light of a frame, from its pixels.
/// Needs   why_not_backward() says nothing.
GatheredLight gather_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                 std::uint64_t seed, unsigned threads, bool (*stop)());

/// Whether a picture shows less than 1/2500 of `part` of a room.
bool shows_little(const Scene& scene, const FrameState& state, const Bounds& room, double part = 1);

/// Whether the light of a frame is followed from its pixels: asked for, or where the picture shows
/// less than 1/2500 of the box around all walls, and no light would be missed.
bool is_gathered(const Scene& scene, const FrameState& state);

/// The fluence of a frame as its scene wants it followed: row by row from the top, 3 a pixel.
std::vector<double> frame_fluence(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                  std::uint64_t seed, const LightRun& run);

}  // namespace flatray
