#include "geom/polygon_edges.h"
#include "geom/ring_sweep.h"

namespace flatray {

std::optional<CrossingEdges> crossing_edges(std::span<const Vec2> ring) {
  const std::vector<std::size_t> edges = proper_edges(ring);
  std::vector<Vec2> points;
  points.reserve(edges.size());
  for (const std::size_t edge : edges) points.push_back(ring[edge]);
  RingSweep sweep(points);
  while (sweep.next()) {
  }
  if (!sweep.crossing()) return std::nullopt;
  return CrossingEdges{edges[sweep.crossing()->first], edges[sweep.crossing()->second]};
}

}  // namespace flatray
