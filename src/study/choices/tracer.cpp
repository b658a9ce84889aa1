#include "trace/tracer.h"

#include <fmt/core.h>

#include <memory>

#include "anim/world.h"
#include "base/counted.h"
#include "base/processor_time.h"
#include "oracle/long_orbit.h"
#include "oracle/nearest.h"
#include "study/accuracy/accuracy.h"
#include "study/rooms/starts.h"

namespace flatray::tracer_choice {
namespace {

constexpr std::uint64_t kRays = 20'000, kFewRays = 20;
constexpr unsigned kBits = 512;

// The walls of the first frame, and rays from anywhere in the window in any direction.
struct Shots {
  World world;
  RayBatch rays;
  std::vector<std::int64_t> truth;  // the first wall; -1 for none
  std::vector<NearestHit> found;
};

// By arithmetic the tracers have no part in.
std::int64_t first_wall(const Surfaces& walls, const Ray& ray) {
  if (walls.curve_numbers.empty()) return oracle::nearest_wall(ray, walls.segments).wall;
  const oracle::LongOrbit orbit = oracle::long_orbit(walls, ray, 1, kBits);
  return orbit.bounces.empty() ? -1 : static_cast<std::int64_t>(orbit.bounces.front().surface);
}

std::shared_ptr<Shots> shots(const AccuracyContext& context) {
  auto made = std::make_shared<Shots>();
  const FrameState state = at(Timeline(context.scene, context.seed, 1), 1);
  made->world = build_world(context.scene, state, WorldOf::everything);
  const double start = processor_seconds();
  std::uint64_t count = kRays;
  for (std::uint64_t ray = 0; ray < count; ++ray) {
    const Ray shot = random_ray(state.window, context.seed, ray);
    made->rays.add(shot);
    made->truth.push_back(first_wall(made->world.surfaces, shot));
    if (ray + 1 < kFewRays) continue;
    const double each = (processor_seconds() - start) / static_cast<double>(ray + 1);
    if (each * static_cast<double>(ray + 2) > reference_budget(context)) count = ray + 1;
  }
  made->found.resize(count);
  return made;
}

double wrong(const Shots& shots) {
  double count = 0;
  for (std::size_t i = 0; i < shots.truth.size(); ++i)
    if ((shots.found[i] ? std::int64_t{shots.found[i].surface} : -1) != shots.truth[i]) ++count;
  return count;
}

// What is wrong is rounded; how well so many rays tell its share is a matter of samples.
Outcome judge(const Shots& shots) {
  const auto [share, half] = share_of(wrong(shots), static_cast<double>(shots.truth.size()));
  return {share, half, {}, {half, std::nullopt, std::nullopt, share}};
}

std::string left_out(const Scene& scene) {
  if (scene.field() != 0) return kRaysAreBent;
  const FrameState state = at(Timeline(scene, scene.seed, 1), 1);
  return build_world(scene, state, WorldOf::everything).surfaces.size() == 0
             ? "the scene has no outline a ray could meet"
             : "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const std::shared_ptr<Shots> made = shots(context);
  ChoiceSettings all;
  all.unit = "share of rays told the wrong wall";
  all.reference = fmt::format(
      "{} among {} by {}", counted(made->truth.size(), "random ray"),
      counted(made->world.surfaces.size(), "wall"),
      made->world.surfaces.curve_numbers.empty()
          ? "rationals (oracle/nearest)"
          : fmt::format("Cramer's rule and the quadratic formula in {} bits (oracle/long_orbit)",
                        kBits));
  if (made->truth.size() < kRays)
    all.cut =
        fmt::format("reference for {} instead of {}", counted(made->truth.size(), "ray"), kRays);
  all.laws = {};
  for (const Tracer* tracer : tracers()) {
    const std::string why = tracer->missing == nullptr ? "" : tracer->missing();
    if (!why.empty()) {
      all.missing.push_back({fmt::format("--tracer {}", tracer->name), why});
      continue;
    }
    const std::shared_ptr<Accelerator> walls = tracer->build(made->world.surfaces);
    all.settings.push_back({fmt::format("--tracer {}", tracer->name), 0,
                            [made, walls] { walls->nearest(made->rays, made->found); },
                            [made] { return judge(*made); }});
  }
  return all;
}

}  // namespace

extern const Choice entry = {"tracer", "What does it cost to find the right wall?",
                             ErrorKind::rounding, &left_out, &settings};

}  // namespace flatray::tracer_choice
