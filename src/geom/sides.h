#pragma once
#include <span>

#include "geom/clip_range.h"
#include "geom/vec.h"

namespace flatray {

/// Sides of the vertices of a convex polygon, seen along a ray. The line crosses it where the side
/// changes: down an edge from left to right, where a counter-clockwise polygon is entered
/// (denominator n.d < 0), and up an edge from right to left. Each side is one exact predicate, and
/// no two t need to be compared.
struct Sides {
  int down = kNoEdge, up = kNoEdge;  ///< the lowest edge that does it
  bool left = false, right = false;  ///< some vertex is strictly there
  bool edge_on_line = false;         ///< one of positive length
};

/// What the line of `ray` has in common with a closed convex polygon whose sides are known.
LineHit hit_line(const Ray& ray, std::span<const Vec2> vertices, const Sides& sides);

}  // namespace flatray
