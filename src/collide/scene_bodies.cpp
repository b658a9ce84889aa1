#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "collide/meetings.h"
#include "collide/simulate.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

double extent(const std::vector<ShapePart>& parts) {
  double most = 0;
  for (const ShapePart& part : parts) {
    most = std::max(most, part.radius);
    for (const Vec2& p : part.ring) most = std::max(most, p.cwiseAbs().maxCoeff());
  }
  return most;
}

bool has_area(const std::vector<ShapePart>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const ShapePart& part) {
    return part.radius > 0 || ring_orientation(part.ring) != Sign::zero;
  });
}

// As large as the smallest normal number at least, where there is any area.
double area(const std::vector<ShapePart>& parts, double scale) {
  if (!has_area(parts)) return 0;
  double sum = 0;
  for (const ShapePart& part : parts) {
    const double radius = scale * part.radius;
    std::vector<Vec2> ring;
    for (const Vec2& p : part.ring) ring.emplace_back(scale * p);
    sum += ring_area(ring) + std::numbers::pi * radius * radius;
  }
  return std::max(sum, std::numeric_limits<double>::min());
}

// Only the proportions of masses count, so where the areas would overflow or be lost lengths are
// scaled by a power of two.
double scale_for(const std::vector<SimulatedBody>& bodies) {
  double most = 0;
  for (const SimulatedBody& body : bodies) most = std::max(most, extent(body.parts));
  constexpr int kUsual = 256, kMost = 1000;
  const int exponent = most > 0 ? std::ilogb(most) : 0;
  return std::abs(exponent) <= kUsual ? 1 : std::ldexp(1.0, -std::clamp(exponent, -kMost, kMost));
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
    const Shape& shape = shape_of(scene, states[i]);
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
    bodies.push_back(std::move(body));
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  const double scale = scale_for(bodies);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    const bool held = std::find(fixed.begin(), fixed.end(), scene.entities[i].name) != fixed.end();
    const double mass = area(bodies[i].parts, scale);
    bodies[i].mass = held || mass == 0 ? kInfinity : mass;
  }
  return bodies;
}

}  // namespace flatray
