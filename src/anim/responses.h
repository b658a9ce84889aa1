#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace flatray {

/// How a body moves from one event to the next.
struct Stage {
  double from;  ///< time
  Vec2 at, velocity;
  bool gone = false;  ///< it has been removed, and its velocity is 0
};

/// Two bodies met.
struct CollisionEvent {
  double time;
  std::uint32_t a, b;           ///< a < b
  Vec2 point, normal;           ///< of contact; unit, out of a
  Vec2 velocity_a, velocity_b;  ///< from then on
};

/// What contact makes of the motion of a scene.
struct Responses {
  std::vector<CollisionEvent> events;      ///< by time, then by entities
  std::vector<std::vector<Stage>> stages;  ///< by entity, in the world; empty: it does not respond
};

/// The stage a body is in at a time, from `from` on; before the first one that.
const Stage& stage_at(std::span<const Stage> stages, double time);

/// Where a body is at a time.
Vec2 place_at(std::span<const Stage> stages, double time);
/// The sizes of what a place on a stage adds up: rounding moves the place by at most 2^-51 of them.
Vec2 sizes_of_place(const Stage& stage, double time);

}  // namespace flatray
