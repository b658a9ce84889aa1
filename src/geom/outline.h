#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/ray.h"

namespace flatray {

/// Edges left when every pair a -> b, b -> a of bit-equal ends has cancelled: the outline of a
/// mesh. Of n edges one way and m < n the other way n - m stay; edges without length are dropped.
///
/// Gives   the numbers of those left, ascending.
/// Cost    O(n) expected; some 100 ns an edge.
std::vector<std::uint32_t> outline_edges(std::span<const Segment> edges);

}  // namespace flatray
