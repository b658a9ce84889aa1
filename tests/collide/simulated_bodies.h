#pragma once
#include "collide/simulate.h"

namespace flatray::testing {

inline SimulatedBody disc(const Vec2& at, double radius, const Vec2& velocity, double mass = 1) {
  return {{{{{0, 0}}, radius}}, at, velocity, mass};
}
inline SimulatedBody box(const Vec2& at, const Vec2& half, const Vec2& velocity, double mass) {
  return {{{{-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}}, 0}}, at, velocity, mass};
}

/// All respond alike.
inline Simulation simulate(std::span<const SimulatedBody> bodies, Response response, double end,
                           std::size_t most_events = 1'000'000) {
  std::vector<SimulatedBody> all(bodies.begin(), bodies.end());
  for (SimulatedBody& body : all) body.response = response;
  return flatray::simulate(all, end, most_events);
}

}  // namespace flatray::testing
