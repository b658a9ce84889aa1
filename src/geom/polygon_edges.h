#pragma once
#include <span>
#include <vector>

#include "geom/hit_interval.h"
#include "geom/vec.h"

namespace flatray {

/// Where edge i of a ring ends: at vertex i + 1, the last at vertex 0.
inline const Vec2& edge_end(std::span<const Vec2> ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

/// The edges of positive length, in order: each ends where the next begins.
std::vector<std::size_t> proper_edges(std::span<const Vec2> ring);

/// Where a point lies in a closed convex polygon of either sense, with or without area. Exact.
StartPlace place_in_convex(const Vec2& point, std::span<const Vec2> ring);

}  // namespace flatray
