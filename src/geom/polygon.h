#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/hit_interval.h"
#include "geom/predicates.h"
#include "geom/ray.h"

namespace flatray {

/// Where edge i of a ring ends: at vertex i + 1, the last at vertex 0.
inline const Vec2& edge_end(std::span<const Vec2> ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

/// All edges of a ring, in order.
inline std::vector<Segment> ring_edges(std::span<const Vec2> ring) {
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], edge_end(ring, i)});
  return edges;
}

/// The edges of positive length, in order: each ends where the next begins.
std::vector<std::size_t> proper_edges(std::span<const Vec2> ring);

/// Where a point lies in a closed convex polygon of either sense, with or without area. Exact.
StartPlace place_in_convex(const Vec2& point, std::span<const Vec2> ring);

/// Sign of the ring's area: positive where the ring runs counter-clockwise. Exact.
Sign ring_orientation(std::span<const Vec2> ring);

/// Area of a ring, positive where it runs counter-clockwise. Rounded.
double ring_area(std::span<const Vec2> ring);

/// First vertex at which a ring is not convex (turns the wrong way, or winds round twice), in
/// either orientation; repeated and collinear vertices are passed over. nullopt: convex. Exact.
/// Cost O(n).
std::optional<std::size_t> non_convex_vertex(std::span<const Vec2> ring);

/// Makes a ring convex again that was convex until its corners were rounded: each corner that has
/// come to lie inside moves onto the one before it. So the ring keeps its number of edges; where
/// several become one, it has the number of the last of them. A ring without area stays as it is.
/// Exact.
/// Cost    O(n).
void mend_convex(std::vector<Vec2>& ring);

/// Two edges of a ring that meet where they should not, or nullopt for a simple ring. Edge i runs
/// from vertex i to i + 1. Repeated vertices in a row are passed over. Exact. Cost O(n log n).
struct CrossingEdges {
  std::size_t first, second;
};
std::optional<CrossingEdges> crossing_edges(std::span<const Vec2> ring);

/// Convex pieces of a simple ring, counter-clockwise, from its own vertices only.
struct ConvexPieces {
  std::vector<Vec2> vertices;           ///< piece after piece
  std::vector<std::uint32_t> begin{0};  ///< piece i is [begin[i], begin[i + 1])
  std::vector<std::int32_t>
      edges;               ///< the ring's edge from vertex k of the list to the next; -1 a cut
  bool clockwise = false;  ///< the ring is, so that its edges run the other way
};
/// Needs   a simple ring of non-zero area. A convex ring is one piece. Cost O(n log n).
ConvexPieces convex_pieces(std::span<const Vec2> ring);

}  // namespace flatray
