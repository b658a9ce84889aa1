#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/frames/frames.h"
#include "base/json.h"
#include "render/light/light_run.h"

namespace flatray {

/// What became of the light of a frame, as parts of what was emitted, which they add up to.
struct LightRecord {
  std::uint64_t rays = 0, legs = 0, rounds = 0;  ///< legs: straight parts of paths
  double absorbed = 0, escaped = 0;
  double corners = 0;             ///< lost: at corners
  double cut_off = 0;             ///< lost: after the last bounce allowed
  double gambled = 0;             ///< by faint rays; some win
  std::optional<double> error{};  ///< relative standard error, where scrambles tell it
  bool operator==(const LightRecord&) const = default;
};
LightRecord record_of(const LightReport& report);
JsonValue as_value(const LightRecord& light);

/// One frame written: a line of `manifest.jsonl`. Nothing in it depends on when, where or by how
/// many threads.
struct FrameRecord {
  unsigned frame = 0;
  std::string file;  ///< name beside the manifest
  int width = 0, height = 0;
  std::string pixels;  ///< hash of the pixels: equal for every compiler and compressor
  std::string bytes;   ///< hash of the file
  std::string scene;   ///< hash of the scene and every option a pixel depends on
  std::uint64_t seed = 0;
  std::string backend = "software";    ///< what drew it, with all its pixels depend on
  std::optional<LightRecord> light{};  ///< of scenes with lamps
  std::string error_image{};           ///< hash of its file, where one was asked for
  std::string error_file{};            ///< name of that, where it is beside the manifest
  bool operator==(const FrameRecord&) const = default;
};

JsonValue as_value(const FrameRecord& record);
std::string manifest_line(const FrameRecord& record);
/// nullopt for a torn line, and for anything else that is not a record.
std::optional<FrameRecord> parse_manifest_line(std::string_view line);

/// manifest.jsonl, or manifest.I-of-N.jsonl for a shard; timings.jsonl likewise.
std::filesystem::path manifest_path(const std::filesystem::path& folder, const Shard& shard);
std::filesystem::path timings_path(const std::filesystem::path& folder, const Shard& shard);

/// Manifests in a folder, of all shards and of the whole, by name.
std::vector<std::filesystem::path> manifests_in(const std::filesystem::path& folder);

/// Records by file name, the last line of each.
using Records = std::map<std::string, FrameRecord>;
Records records_of(std::string_view text);

/// Whether the file a record speaks of is there, whole, and what the record says: its bytes hash
/// alike, and a PNG decodes to its pixels.
bool is_whole(const FrameRecord& record, const std::filesystem::path& folder);
/// Whether the picture of its error is at a path, whole.
bool is_error_image(const FrameRecord& record, const std::filesystem::path& path);

}  // namespace flatray
