#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/predicates.h"

namespace flatray {

/// A corner of the Minkowski difference A - B: vertex `a` of A minus vertex `b` of B, never
/// computed; and the edge that begins there.
struct DifferenceCorner {
  std::uint32_t a, b;
  bool edge_of_a;       ///< the edge is one of A, else one of B turned round
  std::uint32_t along;  ///< the vertex of A or B at the other end of that edge
  std::uint32_t edge;   ///< its number in A or B as given; 0 where that has no area
};

/// The outline of A - B, counter-clockwise, corners in a row perhaps on one line. Without area it
/// is a segment there and back, or one corner.
struct Difference {
  std::vector<DifferenceCorner> corners;
  bool has_area;
};

/// Vertices of a convex ring counter-clockwise, without those that repeat the one before; without
/// area (`sense` zero) its two ends, or one. Needs   sense as ring_orientation gives it.
std::vector<std::uint32_t> turned_ring(std::span<const Vec2> ring, Sign sense);

/// Needs   convex rings as clip_convex does, at least one vertex each.
/// Gives   exactly the outline: directions are compared, not computed.
/// Cost    linear.
/// Source  the edges of both sorted by angle.
Difference minkowski_difference(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace flatray
