#pragma once
#include <vector>

#include "oracle/families.h"

namespace flatray::oracle {

/// Two convex polygons, segments or points in straight motion.
struct StraightPair {
  std::vector<Vec2> ring_a, ring_b;
  Vec2 velocity_a, velocity_b;
};

/// What is hard about a pair: see goal R1.
struct StraightFamily {
  const char* name;
  StraightPair (*make)(Draw& draw);
};
std::span<const StraightFamily> straight_families();

/// The pair of a number, the same for ever; its rings are convex.
StraightPair make_pair(const StraightFamily& family, std::uint64_t seed, std::uint64_t item);

}  // namespace flatray::oracle
