#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace flatray {

/// Edges left when every pair a -> b, b -> a of bit-equal ends has cancelled: the outline of a
/// mesh. Edge i runs from points[i] to points[to[i]]. Of n edges one way and m < n the other way
/// n - m stay; edges without length are dropped.
///
/// Gives   the numbers of those left, ascending.
/// Cost    O(n log n); 48 bytes an edge.
std::vector<std::uint32_t> outline_edges(std::span<const Vec2> points,
                                         std::span<const std::uint32_t> to);

}  // namespace flatray
