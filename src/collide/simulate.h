#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "collide/outline_contact.h"

namespace flatray {

/// What two bodies do that meet.
enum class Response : std::uint8_t {
  mark,   ///< go on; of each pair the first meeting is told
  stop,   ///< stand still from then on, or go with the one that nothing moves
  bounce  ///< elastically, without friction and turning
};

struct SimulatedBody {
  std::vector<ShapePart> parts;  ///< as seen from its origin
  Vec2 at{0, 0}, velocity{0, 0};
  double mass = 1;  ///< infinite: nothing moves it or changes its velocity
};

struct CollisionEvent {
  double time;
  std::uint32_t a, b;           ///< a < b
  Vec2 point, normal;           ///< of contact; unit, out of a
  Vec2 velocity_a, velocity_b;  ///< from then on
};

/// How a body moves from one event to the next.
struct Stage {
  double from;  ///< time
  Vec2 at, velocity;
};

struct Simulation {
  std::vector<CollisionEvent> events;      ///< by time, then by bodies
  std::vector<std::vector<Stage>> stages;  ///< by body, the first from 0
  bool complete = true;                    ///< false: as many events as were allowed came first, or
  bool jammed = false;    ///< the last of them again and again, and time stood still
  bool overlaps = false;  ///< some lie in each other at time 0
};

/// Events at one time after which bodies count as jammed, for each body.
inline constexpr std::size_t kJamEvents = 1024;

/// Bodies in straight motion from time 0 to `end`, and what they do where they meet.
///
/// Needs   finite places and velocities, masses > 0.
/// Gives   no event of two whose mass is infinite, nor where two only touch and part or slide. Bodies
///         that overlap at time 0 are left alone until one of them changes its way after they have
///         parted; all others pass through nothing, however fast.
/// Error   each meeting exact for the doubles at the last event of either; bodies are then placed
///         by at + velocity * time, rounded. A pair that rounding has laid into each other by that
///         meets at once if the way out is back, not forward. Momentum and energy to rounding.
/// Cost    n comparisons of discs for an event, a contact for each that is near.
Simulation simulate(std::span<const SimulatedBody> bodies, Response response, double end,
                    std::size_t most_events = 1'000'000);

/// The entities of a scene as bodies: mass by area, of density 1; those named in `fixed`, and
/// what has no area, are not moved by others.
/// Error   an entity that does not keep its velocity, or has parts that meetings leave out.
Result<std::vector<SimulatedBody>> bodies_of(const Timeline& timeline,
                                             std::span<const std::string> fixed);

/// Where a body is at a time.
Vec2 place_at(std::span<const Stage> stages, double time);

}  // namespace flatray
