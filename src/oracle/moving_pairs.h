#pragma once
#include <vector>

#include "oracle/families.h"
#include "oracle/round_contact.h"

namespace flatray::oracle {

/// Two convex polygons, segments or points in straight motion.
struct StraightPair {
  std::vector<Vec2> ring_a, ring_b;
  Vec2 velocity_a, velocity_b;
};

/// At least one of them with a radius.
struct RoundPair : StraightPair {
  double radius_a = 0, radius_b = 0;

  RoundCore a() const { return {ring_a, velocity_a, radius_a}; }
  RoundCore b() const { return {ring_b, velocity_b, radius_b}; }
};

/// What is hard about a pair: see goal R1. Numbers of pairs of one kind are from 1000 (turning),
/// 2000 (straight) or 3000 (round), beyond the families of rays.
template <class Pair>
struct FamilyOf {
  const char* name;
  Pair (*make)(Draw& draw);
};
using StraightFamily = FamilyOf<StraightPair>;
using RoundPairFamily = FamilyOf<RoundPair>;
std::span<const StraightFamily> straight_families();
std::span<const RoundPairFamily> round_pair_families();

/// The pair of a number, the same for ever; its rings are convex.
StraightPair make_pair(const StraightFamily& family, std::uint64_t seed, std::uint64_t item);
RoundPair make_pair(const RoundPairFamily& family, std::uint64_t seed, std::uint64_t item);

}  // namespace flatray::oracle
