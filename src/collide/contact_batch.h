#pragma once
#include <cstdint>
#include <span>

#include "base/isa.h"
#include "collide/contact.h"
#include "collide/polygon_set.h"

namespace flatray {

/// Two shapes of a set, and how they move.
struct MovingPair {
  std::uint32_t a, b;
  Vec2 velocity_a, velocity_b;
};

/// What contact() gives for each pair, bit for bit, whatever the tier.
///
/// Needs   as many `contacts` as pairs.
/// Cost    some 30 ns a pair for polygons with area of up to eight vertices and a range that
///         begins at 0; others as contact() does.
void contacts(const PolygonSet& shapes, std::span<const MovingPair> pairs, Range within,
              std::span<Contact> contacts, Isa isa = active_isa());

}  // namespace flatray
