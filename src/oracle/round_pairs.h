#pragma once
#include <string_view>
#include <vector>

#include "oracle/families.h"
#include "oracle/round_contact.h"

namespace flatray::oracle {

/// Two bodies in straight motion, at least one with a radius.
struct RoundPair {
  std::vector<Vec2> ring_a, ring_b;
  Vec2 velocity_a, velocity_b;
  double radius_a = 0, radius_b = 0;

  RoundCore a() const { return {ring_a, velocity_a, radius_a}; }
  RoundCore b() const { return {ring_b, velocity_b, radius_b}; }
};

/// What is hard about a pair of round bodies.
struct RoundPairFamily {
  const char* name;
  RoundPair (*make)(Draw& draw);
};
std::span<const RoundPairFamily> round_pair_families();

/// The pair of a number, the same for ever.
RoundPair make_pair(const RoundPairFamily& family, std::uint64_t seed, std::uint64_t item);

}  // namespace flatray::oracle
