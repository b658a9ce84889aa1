#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace flatray {

inline constexpr std::uint32_t kNoTwin = ~std::uint32_t{0};

/// One side of a triangle, 3 in a row, counter-clockwise.
struct HalfEdge {
  std::uint32_t from;  ///< index of a point
  std::uint32_t twin =
      kNoTwin;  ///< the same side seen from the next triangle; kNoTwin on the outline
};

/// Triangles of a simple polygon, by a sweep. Exact, from its own corners only.
///
/// Needs   a ring counter-clockwise, simple, without flat corners.
/// Gives   3 half-edges a triangle, points - 2 triangles, each of positive area.
/// Cost    O(n log n).
std::vector<HalfEdge> triangulate(std::span<const Vec2> points);

}  // namespace flatray
