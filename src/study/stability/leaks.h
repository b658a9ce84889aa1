#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "trace/tracer.h"

namespace flatray {

/// Where a sealed room stands: each of its points times `scale`, and moved.
struct RoomPlace {
  const char* name;  ///< a word, as options say it
  double scale;
  double x, y;         ///< how far
  bool round = false;  ///< of circles alone
};
/// At the origin, a million away, and at scales of 1e-5 and 1e15; straight, then round.
std::span<const RoomPlace> room_places();

/// What became of rays aimed at the vertices of a sealed room.
///
/// A tracer that is not exact is also asked for the first walls of all rays of the exact orbits, in
/// straight rooms: `asked` and what comes after it, of answers that are not the exact ones.
struct LeakTally {
  std::uint64_t rays = 0;
  std::uint64_t bounces = 0;
  std::uint64_t leaks = 0;  ///< rays that met nothing, or ended outside the room, or through a disc
  std::uint64_t corners = 0;  ///< ended in a corner, or along the wall they met
  std::uint64_t wrong = 0;    ///< first walls other than the exact ones
  std::uint64_t wrong_t = 0;  ///< first t more than an ulp off, of the right walls
  std::uint64_t asked = 0;
  std::uint64_t beside = 0;   ///< the other wall of a vertex that floats cannot tell from the hit
  std::uint64_t nothing = 0;  ///< no wall: the ray gets out
  std::uint64_t through_end = 0;  ///< a later wall, where the first is met as near to its end
  std::uint64_t through = 0;      ///< a later wall, where the first is met farther from its ends
  std::uint64_t invented = 0;     ///< a wall that the exact ray does not meet, or has just left

  void add(const LeakTally& other);
};
/// All of them.
inline constexpr std::array kLeakCounts = {
    &LeakTally::rays,    &LeakTally::bounces,     &LeakTally::leaks,   &LeakTally::corners,
    &LeakTally::wrong,   &LeakTally::wrong_t,     &LeakTally::asked,   &LeakTally::beside,
    &LeakTally::nothing, &LeakTally::through_end, &LeakTally::through, &LeakTally::invented};

inline constexpr std::uint64_t kRaysALeakBlock = 1024;
inline constexpr int kLeakBounces = 200;

/// The first `count` of kRaysALeakBlock rays, block `block`, in a convex room of 300 walls, or a circle, with 60
/// pillars, all mirrors: each starts inside, exactly towards a vertex or along a tangent of a circle as far as doubles
/// have the direction, and is reflected kLeakBounces times. Rays of a block are the same for ever.
///
/// Cost    some 2 us a bounce; of `exact` some 60.
LeakTally count_leaks(const Tracer& tracer, const RoomPlace& place, std::uint64_t seed,
                      std::uint64_t block, std::uint64_t count = kRaysALeakBlock);

}  // namespace flatray
