#pragma once
#include <span>

#include "geom/clip_range.h"
#include "geom/vec.h"

namespace flatray {

/// Sides of the corners of a convex outline, seen along a ray. The line crosses it where the side
/// changes: down an edge from left to right, where a counter-clockwise polygon is entered
/// (denominator n.d < 0), and up an edge from right to left. Each side is one exact predicate, and
/// no two t need to be compared.
struct Sides {
  int down = kNoEdge, up = kNoEdge;  ///< the lowest edge that does it
  bool left = false, right = false;  ///< some vertex is strictly there
  bool edge_on_line = false;         ///< one of positive length

  /// What the line has in common with the outline, if anything.
  HitClass kind(bool has_area) const {
    return left && right && has_area ? HitClass::through
           : edge_on_line            ? HitClass::along
                                     : HitClass::touch;
  }
};

/// Sides of at least one corner. `side(k)`: the side of corner k; `is_edge(k)`: whether the edge
/// that begins there has a length.
template <class SideOf, class IsEdge>
Sides sides_of(std::size_t corners, const SideOf& side, const IsEdge& is_edge) {
  Sides sides;
  const Sign first = side(std::size_t{0});
  Sign from = first;
  for (std::size_t k = 0; k < corners; ++k) {
    const Sign to = k + 1 == corners ? first : side(k + 1);
    if (from > to && sides.down == kNoEdge) sides.down = static_cast<int>(k);
    if (from < to && sides.up == kNoEdge) sides.up = static_cast<int>(k);
    sides.left |= from == Sign::positive;
    sides.right |= from == Sign::negative;
    sides.edge_on_line |= from == Sign::zero && to == Sign::zero && is_edge(k);
    from = to;
  }
  return sides;
}

}  // namespace flatray
