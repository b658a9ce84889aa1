#include "render/ray_walls.h"

#include <algorithm>
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
      glass_(scene, world_),
      orbits_(world_.surfaces, materials_, {CornerRule::stop, asked, scene.field(), &glass_}) {}

std::vector<RenderPlan::Choice> ray_wall_choices(const Scene& scene, const FrameState& state,
                                                 const Tracer* asked) {
  const Need need = need_of_ray_walls(scene);
  if (!need.needed)
    return {{"tracer", "left out", need.reason}, {"origins", "left out", need.reason}};
  const RayWalls walls(scene, state, asked);
  const OrbitTracer& orbits = walls.orbits();
  const RenderPlan::Choice origins{"origins", orbits.origin_cells().structure(),
                                   "walls near a bounce are looked at"};
  if (orbits.field() != 0)
    return {{"tracer", "left out", "a magnetic field bends flights: all walls are looked at"},
            origins};
  const TracerChoice& choice = orbits.choice();
  return {{"tracer", choice.tracer->name, choice.reason + "; " + orbits.walls().structure()},
          origins};
}

}  // namespace flatray
