#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "collide/meetings.h"
#include "collide/simulate.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

double area(const std::vector<ShapePart>& parts) {
  double sum = 0;
  for (const ShapePart& part : parts)
    sum += ring_area(part.ring) + std::numbers::pi * part.radius * part.radius;
  return sum;
}

}  // namespace

Result<std::vector<SimulatedBody>> bodies_of(const Timeline& timeline,
                                             std::span<const std::string> fixed) {
  const Scene& scene = timeline.scene();
  const std::vector<EntityState> states = entity_states(timeline, 1);
  std::vector<SimulatedBody> bodies;
  Diagnostics problems;
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    const Entity& entity = scene.entities[i];
    const Shape& shape = scene.shapes[states[i].shape];
    const auto refuse = [&](const char* what) {
      problems.push_back({entity.where, fmt::format("entity '{}' {}", entity.name, what),
                          "responses are for entities that keep one velocity until they meet",
                          Trouble::invalid});
    };
    if (!keeps_velocity(scene, i))
      refuse("turns, follows curves or states, or is in a group that moves");
    if (has_parts_left_out(shape))
      refuse("has curves or crossing outlines, which nothing can meet");
    SimulatedBody body{parts_of(shape, pose({0, 0}, states[i].angle, states[i].scale)),
                       states[i].at, entity.velocity, 1};
    body.mass = area(body.parts);
    if (std::find(fixed.begin(), fixed.end(), entity.name) != fixed.end() || !(body.mass > 0))
      body.mass = kInfinity;
    bodies.push_back(std::move(body));
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return bodies;
}

}  // namespace flatray
