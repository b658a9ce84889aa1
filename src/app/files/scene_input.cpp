#include "app/files/scene_input.h"

#include "app/frames/frames.h"
#include "app/options/option_values.h"
#include "app/report/report.h"
#include "base/parallel.h"
#include "collide/pillars.h"
#include "collide/scene_timeline.h"

namespace flatray {
namespace {

constexpr std::uint64_t kMostEntities = std::uint64_t{1}
                                        << 24;  // what the order of drawing tells apart
constexpr std::uint64_t kMostCorners = std::uint64_t{1} << 31;  // what numbers of edges tell apart
constexpr std::uint64_t kMostDepth = 1000;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 36;
constexpr std::uint64_t kMostSeed = ~std::uint64_t{0} >> 1;  // what a TOML integer holds

}  // namespace

Result<std::uint64_t> max_pixels(const Arguments& arguments) {
  return arguments.whole("max-pixels", LoadLimits{}.max_pixels, 1, kMostPixels);
}

Result<std::uint64_t> seed(const Arguments& arguments, const Scene& scene) {
  return arguments.whole("seed", scene.seed, 0, kMostSeed);
}

Result<unsigned> threads(const Arguments& arguments) {
  constexpr std::uint64_t kMostThreads = 1024;
  const auto count = arguments.whole("jobs", hardware_threads(), 1, kMostThreads);
  if (!count) return tl::unexpected(count.error());
  return static_cast<unsigned>(*count);
}

namespace {

Result<LoadLimits> limits_of(const Arguments& arguments) {
  LoadLimits limits;
  const auto pixels = max_pixels(arguments);
  if (!pixels) return tl::unexpected(pixels.error());
  limits.max_pixels = *pixels;
  const auto entities = arguments.whole("max-entities", limits.max_entities, 1, kMostEntities);
  if (!entities) return tl::unexpected(entities.error());
  limits.max_entities = *entities;
  const auto corners = arguments.whole("max-corners", limits.max_corners, 1, kMostCorners);
  if (!corners) return tl::unexpected(corners.error());
  limits.max_corners = *corners;
  const auto depth = arguments.whole("max-depth", limits.max_depth, 0, kMostDepth);
  if (!depth) return tl::unexpected(depth.error());
  limits.max_depth = *depth;
  const auto bytes = arguments.whole("max-bytes", limits.max_bytes, 1, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  limits.max_bytes = *bytes;
  limits.root = arguments.text("root").value_or("");
  const auto count = threads(arguments);
  if (!count) return tl::unexpected(count.error());
  limits.threads = *count;
  return limits;
}

}  // namespace

Result<ReadScene> read_input(const Arguments& arguments, const std::string& path,
                             const std::vector<Override>& more) {
  auto overrides = parse_overrides(arguments.list("define"), arguments.where("define"));
  if (!overrides) return tl::unexpected(overrides.error());
  overrides->insert(overrides->end(), more.begin(), more.end());
  const auto limits = limits_of(arguments);
  if (!limits) return tl::unexpected(limits.error());
  std::optional<std::uint64_t> seeded;
  if (arguments.has("seed")) {
    const auto given = arguments.whole("seed", 0, 0, kMostSeed);
    if (!given) return tl::unexpected(given.error());
    seeded = *given;
  }
  Result<ReadScene> read = read_scene(path, *overrides, *limits, seeded);
  if (!read) return read;
  const Scene& scene = read->loaded.scene;
  // What leaves by a periodic wall in the middle of a pillar would come in where none is.
  if (!scene.chambers.empty() && scene.chambers.front().material == Material::periodic)
    if (auto inside = expect_pillars_inside(scene); !inside) return fail(std::move(inside));
  return read;
}

Result<LoadedScene> load_input(const Arguments& arguments, const std::string& path,
                               const std::vector<Override>& more) {
  Result<ReadScene> read = read_input(arguments, path, more);
  if (!read) return fail(std::move(read));
  return std::move(read->loaded);
}

Result<FrameState> frame_of(const Arguments& arguments, const Scene& scene) {
  const auto frame = arguments.whole("frame", 1, 1, kLastFrame);
  if (!frame) return tl::unexpected(frame.error());
  const auto seeded = seed(arguments, scene);
  if (!seeded) return tl::unexpected(seeded.error());
  const auto number = static_cast<unsigned>(*frame);
  const auto timeline = make_timeline(scene, *seeded, number);
  if (!timeline) return tl::unexpected(timeline.error());
  return at(*timeline, number);
}

Result<Scene> load_only_input(const Arguments& arguments) {
  Result<LoadedScene> loaded = load_input(arguments, arguments.operands().front());
  if (!loaded) return fail(std::move(loaded));
  report_warnings(loaded->warnings, arguments);
  return std::move(loaded->scene);
}

}  // namespace flatray
