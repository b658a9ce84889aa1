#include "render/ray_walls.h"

#include <fmt/core.h>

#include <algorithm>

#include "trace/whole_nearest.h"

namespace flatray {

Need need_of_ray_walls(const Scene& scene) {
  if (scene.rays.empty()) return skip("no rays");
  const auto stands_still = [](const RayPath& ray) { return !ray.speed; };
  if (std::none_of(scene.rays.begin(), scene.rays.end(), stands_still))
    return skip("all rays have a speed: they meet walls as these move");
  return run("rays without a speed");
}

RayWalls::RayWalls(const Scene& scene, const FrameState& state, const Tracer* asked)
    : world_(build_world(scene, state)),
      materials_(world_.materials()),
      orbits_(world_.surfaces, materials_, {CornerRule::stop, asked}) {}

std::vector<RenderPlan::Choice> RayWalls::choices() const {
  const TracerChoice& choice = orbits_.choice();
  std::string reason = choice.reason + "; " + orbits_.walls().structure();
  if (const WholeWalls whole(world_.surfaces); whole.any())
    reason += fmt::format(
        "; walls on multiples of {}: for rays nearby that start and point in such multiples only t "
        "is rounded",
        whole.unit());
  return {{"tracer", choice.tracer->name, std::move(reason)},
          {"landing", orbits_.near_landings().structure(), "walls near a bounce are looked at"}};
}

std::vector<RenderPlan::Choice> ray_wall_choices(const Scene& scene, const FrameState& state,
                                                 const Tracer* asked) {
  const Need need = need_of_ray_walls(scene);
  if (need.needed) return RayWalls(scene, state, asked).choices();
  return {{"tracer", "left out", need.reason}, {"landing", "left out", need.reason}};
}

}  // namespace flatray
