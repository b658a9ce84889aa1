#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "geom/bounds.h"

namespace flatray {

/// Calls `take(a, b)`, a < b, once for every pair of boxes that have a point in common, in any order,
/// until it says false: not for two that are both left out.
///
/// Gives   none with an empty box.
/// Cost    O(n log n + pairs), whatever the boxes; memory O(n), and only the first is spent on those left
///         out.
/// Source  Zomorodian and Edelsbrunner 2000: boxes by segment trees that are not kept.
void each_overlap(std::span<const Bounds> boxes, const std::vector<bool>& left_out,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& take);

/// All of them, ascending.
std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(
    std::span<const Bounds> boxes);

/// A box around all places of `box` while it moves by velocity * t, t in [0, length]; outward by
/// more than rounding can lose.
Bounds swept(const Bounds& box, const Vec2& velocity, double length);

}  // namespace flatray
