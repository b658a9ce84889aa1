#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/bounds.h"

namespace flatray {

/// Pairs of boxes that have a point in common, each with its lower number first, ascending.
///
/// Gives   none with an empty box.
/// Cost    O(n log n), and one comparison for each pair that overlaps along x.
std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(
    std::span<const Bounds> boxes);

/// A box around all places of `box` while it moves by velocity * t, t in [0, length]; outward by
/// more than rounding can lose.
Bounds swept(const Bounds& box, const Vec2& velocity, double length);

}  // namespace flatray
