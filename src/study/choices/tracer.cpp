#include "trace/tracer.h"

#include <fmt/core.h>

#include <memory>

#include "anim/world.h"
#include "base/philox.h"
#include "study/accuracy.h"

namespace flatray {
namespace {

constexpr std::uint64_t kRays = 20'000;

// The walls of the first frame, and rays from anywhere in the window in any direction.
struct Shots {
  World world;
  RayBatch rays;
  std::vector<NearestHit> truth, found;
};

std::shared_ptr<Shots> shots(const AccuracyContext& context) {
  const auto made = std::make_shared<Shots>();
  const FrameState state = at(Timeline(context.scene, context.seed, 1), 1);
  made->world = build_world(context.scene, state, WorldOf::everything);
  for (std::uint64_t ray = 0; ray < kRays; ++ray) {
    const auto draw = [&](std::uint32_t number) {
      return unit_double(random_bits(context.seed, Stream::experiment, ray, number));
    };
    const Vec2 size = state.window.size();
    const Vec2 from(state.window.low.x() + draw(0) * size.x(),
                    state.window.low.y() + draw(1) * size.y());
    const Vec2 along(draw(2) - 0.5, draw(3) - 0.5);
    made->rays.add({from, along});
  }
  made->found.resize(kRays);
  return made;
}

double wrong_share(const Shots& shots) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < shots.truth.size(); ++i)
    if (shots.found[i].surface != shots.truth[i].surface) ++wrong;
  return static_cast<double>(wrong) / static_cast<double>(shots.truth.size());
}

std::string left_out(const Scene& scene) {
  if (find_tracer("exact") == nullptr) return "this build has no exact tracer to compare with";
  const FrameState state = at(Timeline(scene, scene.seed, 1), 1);
  return build_world(scene, state, WorldOf::everything).surfaces.size() == 0
             ? "the scene has no outline a ray could meet"
             : "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const std::shared_ptr<Shots> made = shots(context);
  made->truth.resize(kRays);
  find_tracer("exact")->build(made->world.surfaces)->nearest(made->rays, made->truth);
  ChoiceSettings all;
  all.unit = "share of rays told the wrong wall";
  all.reference = fmt::format("{} random rays among {} walls by exact comparisons alone", kRays,
                              made->world.surfaces.size());
  all.ordered = false;
  for (const Tracer* tracer : tracers()) {
    if (tracer->missing != nullptr && !tracer->missing().empty()) continue;
    const std::shared_ptr<Accelerator> walls = tracer->build(made->world.surfaces);
    all.settings.push_back({fmt::format("--tracer {}", tracer->name), 0,
                            [made, walls] { walls->nearest(made->rays, made->found); },
                            [made] { return Outcome{wrong_share(*made)}; }});
  }
  return all;
}

}  // namespace

namespace choice_entries {
extern const Choice tracer = {"tracer", "What does it cost to find the right wall?",
                              ErrorKind::rounding, &left_out, &settings};
}  // namespace choice_entries

}  // namespace flatray
