#include "geom/polygon_edges.h"

#include "geom/bounds.h"
#include "geom/predicates.h"

namespace flatray {

std::vector<std::size_t> proper_edges(std::span<const Vec2> ring) {
  std::vector<std::size_t> edges;
  edges.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] != edge_end(ring, i)) edges.push_back(i);
  return edges;
}

StartPlace place_in_convex(const Vec2& point, std::span<const Vec2> ring) {
  bool left = false, right = false, on_line = false;
  Bounds bounds;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = edge_end(ring, i);
    bounds.add(a);
    const Sign side = orientation(a, b, point);
    left |= side == Sign::positive;
    right |= side == Sign::negative;
    on_line |= side == Sign::zero && a != b;
  }
  if (left && right) return StartPlace::outside;
  if (left || right) return on_line ? StartPlace::boundary : StartPlace::inside;
  // On the line of every edge: the ring is a segment or a point, which its bounds describe.
  const bool within =
      (bounds.low.array() <= point.array()).all() && (point.array() <= bounds.high.array()).all();
  return within ? StartPlace::boundary : StartPlace::outside;
}

}  // namespace flatray
