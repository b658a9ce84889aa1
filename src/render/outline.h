#pragma once
#include <vector>

#include "geom/ray.h"

namespace flatray {

/// Edges left when every pair a -> b, b -> a of bit-equal ends has cancelled: the outline of a
/// mesh. Of n edges one way and m < n the other way n - m stay; edges without length are dropped.
///
/// Gives   what is left in the order it came.
/// Cost    O(n) expected; some 100 ns an edge.
std::vector<Segment> cancel_edges(std::vector<Segment> edges);

}  // namespace flatray
