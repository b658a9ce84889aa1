#include "app/files/scene_input.h"

#include <algorithm>

#include "app/options/option_values.h"
#include "app/report/report.h"
#include "collide/pillars.h"
#include "collide/scene_timeline.h"
#include "scene/keys/build_scene.h"
#include "scene/material.h"

namespace flatray {

void row_of_threads(OptionTable& row, unsigned& threads) {
  constexpr std::uint64_t kMostThreads = 1024;
  std::optional<unsigned> given;
  row("-j, --jobs N", "threads, instead of all of the machine", given, 1, kMostThreads);
  threads = given.value_or(hardware_threads());
}

void row_of_frame(OptionTable& row, unsigned& frame) {
  row("-f, --frame K", "frame whose positions are used", frame, 1, kLastFrame);
}

void SceneOptions::rows(OptionTable& row) {
  constexpr std::uint64_t kMostEntities = std::uint64_t{1}
                                          << 24;  // what the order of drawing tells apart
  constexpr std::uint64_t kMostCorners = std::uint64_t{1}
                                         << 31;  // what numbers of edges tell apart
  constexpr std::uint64_t kMostDepth = 1000;
  constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 36;
  row.each("-D, --define KEY=VALUE", "change a key of the scene, as -D film.size=[64,64]",
           overrides, &parse_override);
  row("--max-pixels N", "most pixels a picture may have", limits.max_pixels, 1, kMostPixels);
  row("--max-entities N", "most entities a scene may have, copies too", limits.max_entities, 1,
      kMostEntities);
  row("--max-corners N", "most corners a scene may have, copies too, and draw in a frame",
      limits.max_corners, 1, kMostCorners);
  row("--max-depth N", "most groups in groups, and files in files", limits.max_depth, 0,
      kMostDepth);
  row("--max-bytes N", "most bytes of a scene and all its files", limits.max_bytes, 1, kMostBytes);
  row(kQuietRow);
  row.read("root", limits.root, &as_text);
}

void SceneOptions::row_of_seed(OptionTable& row) {
  row("--seed N", "seed of all draws instead of the scene's", seed, 0, kMostSeed);
}

void SceneOptions::row_of_seed(OptionTable& row, std::uint64_t& all_draws, std::uint64_t most) {
  row("--seed N", "seed of all draws", all_draws, 0, most);
  if (row.has("seed")) seed = all_draws;
}

Result<ReadScene> read_input(const SceneOptions& options, const std::string& path,
                             const std::vector<Override>& more) {
  std::vector<Override> overrides = options.overrides;
  overrides.insert(overrides.end(), more.begin(), more.end());
  FLATRAY_TRY(read, read_scene(path, overrides, options.limits, options.seed));
  const Scene& scene = read->loaded.scene;
  // What leaves by a periodic wall in the middle of a pillar would come in where none is, or in a
  // copy.
  if (!scene.chambers.empty() && scene.chambers.front().material == Material::periodic) {
    if (auto inside = expect_pillars_inside(scene); !inside) return fail(std::move(inside));
    const auto& pillars = scene.chambers.front().pillars;
    if (std::ranges::any_of(pillars, [](const auto& one) { return one.across; }))
      if (auto apart = expect_pillars_apart(scene); !apart) return fail(std::move(apart));
  }
  return read;
}

Result<LoadedScene> load_input(const SceneOptions& options, const std::string& path,
                               const std::vector<Override>& more) {
  FLATRAY_TRY(read, read_input(options, path, more));
  return std::move(read->loaded);
}

Result<void> expect_no_field(const Scene& scene, const std::string& what) {
  if (scene.field() == 0) return {};
  return fail(scene.chambers.front().where,
              "the chamber is in a magnetic field, and " + what + " knows straight rays only",
              "say -D chamber.0.field=0 to leave the field out");
}

Result<void> expect_no_glass(const Scene& scene, const std::string& what) {
  const Place* where = place_of_glass(scene);
  if (where == nullptr) return {};
  return fail(*where, "is of glass, which splits orbits, and " + what + " knows mirrors only",
              "write material = \"mirror\" or \"absorb\"");
}

Result<void> expect_no_speed(const Scene& scene, const std::string& what) {
  const auto ray = std::ranges::find_if(scene.rays, [](const RayPath& one) { return !!one.speed; });
  if (ray == scene.rays.end()) return {};
  return fail(ray->where,
              "has a speed, with which it meets walls where they then are, and " + what +
                  " knows walls that stand still only",
              "leave out its speed to ask of the walls of the first frame");
}

Result<FrameState> frame_of(const SceneOptions& options, const Scene& scene, unsigned frame) {
  FLATRAY_TRY(timeline, make_timeline(scene, options.seed_of(scene), frame));
  return at(*timeline, frame);
}

Result<Scene> load_only_input(const Arguments& arguments, const SceneOptions& options) {
  FLATRAY_TRY(loaded, load_input(options, arguments.operands().front()));
  report_warnings(loaded->warnings, arguments);
  return std::move(loaded->scene);
}

}  // namespace flatray
