#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "anim/timeline.h"
#include "base/result.h"
#include "collide/outline_contact.h"

namespace flatray {

struct SimulatedBody {
  std::vector<ShapePart> parts;  ///< as seen from its origin
  Vec2 at{0, 0}, velocity{0, 0};
  double mass = 1;  ///< infinite: nothing moves it or changes its velocity
  Response response = Response::bounce;
};

/// Bodies in place of entities, each with its stages, the first from 0.
struct Simulation : Responses {
  bool complete = true;      ///< false: as many events as were allowed came first, or
  bool jammed = false;       ///< there was no way out, or time stood still
  bool too_often = false;    ///< so: more events at one time than kJamEvents for each body
  std::size_t crowd = 0;     ///< contacts at `jam` that were too many to find one; 0: few enough
  double until = kInfinity;  ///< time of the first event that is not told
  double jam = kInfinity;  ///< when there is no way out; later than `until`, about: hits accumulate
  IndexPair untold{0, 0};  ///< whose that is
  std::vector<IndexPair> overlaps;  ///< in each other at time 0
};

/// Events at one time after which bodies count as jammed, for each body.
inline constexpr std::size_t kJamEvents = 1024;
/// Whether the hits of a body accumulate, as between walls that close in, is asked when they are so many
/// and whenever they have doubled: they do where so many times in succession they took less time than the
/// time before, and left it half as fast again or more, the last time by nothing that can be moved and is not hit
/// ever faster itself. From the last two such times follows when it has no way out, unless it is past by then
/// one of the two it hit last, beside it.
inline constexpr std::size_t kJamFirst = 256, kJamDoublings = 4;

/// Which pairs are looked at: those whose boxes meet in a while of time, or all. The same events come
/// of both, to the last bit.
enum class PairSearch : std::uint8_t { near, all };

/// Bodies in straight motion from time 0 to `end`, and what they do where they meet.
///
/// Needs   finite places and velocities, masses > 0, of which only the ratio counts: one of more than
///         2^1022 is that of a wall.
/// Gives   no event of two whose mass is infinite, nor where two only touch and part or slide: of
///         points and parallel segments none at all. What
///         bounces off what stops bounces as off a wall, once that has stopped; a mark pushes nothing.
///         Hits at one instant are resolved together, and with them what rests on those hit, instant.h:
///         velocities do not depend on the order of bodies, but for the limits told in docs/adr/0020. A shorter time
///         gives the first of the same events. Bodies that overlap, from time 0 or by rounding, meet at once where
///         they come nearer along the shortest way out, marks of time 0 never; else they are left alone until one of
///         them changes its way. So are parts that meet at no more than kSlideLeaves of a speed, where that
///         changes no velocity or time stands still. All others pass through nothing, however fast.
/// Error   each meeting exact for the doubles at the last event of either; bodies are then placed
///         by at + velocity * time, rounded. Momentum and energy to rounding.
/// Cost    a contact for each pair that comes near; time is cut into whiles in which some of the bodies
///         meet, and boxes are made anew for each. Of all pairs: n comparisons of discs for an event.
Simulation simulate(std::span<const SimulatedBody> bodies, double end,
                    std::size_t most_events = 1'000'000, PairSearch search = PairSearch::near);

/// The entities of a scene as bodies, by number, of their masses or else by area, of density 1; those
/// named in `fixed`, and what has no area and no mass, are not moved by others.
///
/// Needs   a timeline without responses. `response`: of all, instead of the scene's.
/// Error   an entity that responds and has a hindrance, or whose area, by which it is to have its mass,
///         is beyond the doubles beside the masses given or the largest of the others; two of which one
///         can be moved and of which nothing would be seen, as points and parallel segments.
Result<std::vector<SimulatedBody>> bodies_of(const Timeline& timeline,
                                             std::optional<Response> response,
                                             std::span<const std::string> fixed);

}  // namespace flatray
