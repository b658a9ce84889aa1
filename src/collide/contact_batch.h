#pragma once
#include <cstdint>
#include <span>

#include "base/isa.h"
#include "collide/body_set.h"
#include "collide/contact.h"

namespace flatray {

/// Two bodies of a set, and how they move.
struct MovingPair {
  std::uint32_t a, b;
  Vec2 velocity_a, velocity_b;
};

/// What contact() gives for each pair, bit for bit, whatever the tier.
///
/// Needs   as many `contacts` as pairs.
/// Cost    in a range that begins at 0 some 10 ns a pair that stays apart; some 30 ns for polygons with
///         area of up to eight vertices; others as contact() does.
void contacts(const BodySet& bodies, std::span<const MovingPair> pairs, Range within,
              std::span<Contact> contacts, Isa isa = active_isa());

}  // namespace flatray
