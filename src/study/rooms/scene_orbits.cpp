#include "study/rooms/scene_orbits.h"

#include <fmt/core.h>

#include "anim/rays.h"
#include "scene/names.h"
#include "study/rooms/starts.h"

namespace flatray {

Result<NamedOrbits> orbits_to_watch(const ExperimentContext& context, const Room& room,
                                    std::uint64_t random_orbits) {
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  NamedOrbits orbits;
  Diagnostics outside;
  for (const RayState& state : ray_states(context.scene, room.state())) {
    const RayPath& ray = context.scene.rays[state.ray];
    if (!room.has_start(state.start.origin))
      outside.push_back({ray.where, called("ray", ray.name, ray.where) + " starts outside the room",
                         "let it start in the chamber, and in none of its pillars",
                         Trouble::invalid});
    orbits.names.push_back(ray_name(context.scene, state.ray));
    orbits.starts.push_back({state.start, {}, chance_of_orbit(context.seed, state.ray)});
  }
  if (!outside.empty()) return tl::unexpected(std::move(outside));
  if (!orbits.starts.empty() && context.starts != Starts::random)
    return fail(context.scene.rays.front().where,
                "orbits are those of the scene's rays, none are drawn",
                "leave --starts out, or the rays");
  if (!orbits.starts.empty()) return orbits;
  orbits.random = true;
  for (std::uint64_t i = 0; i < random_orbits; ++i) {
    const bool even = context.starts == Starts::quasi;
    orbits.names.push_back(fmt::format("{} {}", even ? "quasi" : "random", i + 1));
    orbits.starts.push_back(room.draw_start(context.seed, even ? i * kShifts : i, context.starts));
  }
  return orbits;
}

}  // namespace flatray
