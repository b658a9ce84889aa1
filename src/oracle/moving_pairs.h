#pragma once
#include <vector>

#include "oracle/contact.h"
#include "oracle/families.h"

namespace flatray::oracle {

/// Two convex polygons, segments or points in straight motion, with all points within their radii.
struct StraightPair {
  std::vector<Vec2> ring_a, ring_b;
  Vec2 velocity_a, velocity_b;
  double radius_a = 0, radius_b = 0;

  MovingCore a() const { return {ring_a, velocity_a, radius_a}; }
  MovingCore b() const { return {ring_b, velocity_b, radius_b}; }
};

/// What is hard about a pair: see goal R1. Numbers are beyond those of the families of rays.
template <class Pair>
struct FamilyOf {
  const char* name;
  Pair (*make)(Draw& draw);
  std::uint64_t number;
};
using StraightFamily = FamilyOf<StraightPair>;
/// Rings are convex. Without radii; with one at least.
std::span<const StraightFamily> straight_families();
std::span<const StraightFamily> round_families();

/// The pair of a number, the same for ever.
template <class Pair>
Pair make_pair(const FamilyOf<Pair>& family, std::uint64_t seed, std::uint64_t item) {
  Draw draw(seed, family.number, item);
  return family.make(draw);
}
/// Where rounding has bent a ring, the next pair that is drawn.
StraightPair make_pair(const StraightFamily& family, std::uint64_t seed, std::uint64_t item);

}  // namespace flatray::oracle
