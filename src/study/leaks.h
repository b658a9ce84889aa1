#pragma once
#include <cstdint>
#include <span>

#include "trace/tracer.h"

namespace flatray {

/// Where a sealed room stands: each of its points times `scale`, and moved.
struct RoomPlace {
  const char* name;
  double scale;
  double x, y;         ///< how far
  bool round = false;  ///< of circles alone
};
/// At the origin, a million away, and at scales of 1e-5 and 1e15; straight, then round.
std::span<const RoomPlace> room_places();

/// What became of rays aimed at the vertices of a sealed room.
struct LeakTally {
  std::uint64_t rays = 0;
  std::uint64_t bounces = 0;
  std::uint64_t leaks = 0;  ///< rays that met nothing, or ended outside the room, or through a disc
  std::uint64_t corners = 0;  ///< ended in a corner, or along the wall they met
  std::uint64_t wrong = 0;    ///< first walls other than the exact ones
  std::uint64_t wrong_t = 0;  ///< first t more than an ulp off, of the right walls

  void add(const LeakTally& other);
};

inline constexpr std::uint64_t kRaysALeakBlock = 1024;
inline constexpr int kLeakBounces = 200;

/// Block `block` of rays in a convex room of 300 walls, or a circle, with 60 pillars, all mirrors:
/// each starts inside, exactly towards a vertex or along a tangent of a circle as far as doubles
/// have the direction, and is reflected kLeakBounces times. Rays of a block are the same for ever.
///
/// Cost    some 2 us a bounce.
LeakTally count_leaks(const Tracer& tracer, const RoomPlace& place, std::uint64_t seed,
                      std::uint64_t block);

}  // namespace flatray
