#pragma once
#include <optional>
#include <span>

#include "geom/polygon.h"
#include "scene/scene.h"

namespace flatray {

/// Whether all points lie on one line (or are one). Exact.
bool is_flat(std::span<const Vec2> points);

/// A ring without repeated vertices and without those in the middle of a straight run. `edges[i]`
/// is the lowest number of the input's edges that make up the edge from vertex i to the next.
struct CleanRing {
  std::vector<Vec2> vertices;
  std::vector<std::int32_t> edges;
};
CleanRing clean_ring(std::span<const Vec2> ring);

/// Adds a ring's convex pieces to a shape, counter-clockwise; edge i of the ring gets number
/// first_edge + i. Needs   a simple ring that is not flat, in either orientation.
void add_ring(Shape& shape, std::span<const Vec2> ring, std::int32_t first_edge = 0);

/// Adds a triangle that is not flat, as `add_ring` does, without looking for anything.
void add_triangle(Shape& shape, std::span<const Vec2, 3> corners, bool clockwise,
                  std::int32_t first_edge);

/// The shape of such a ring alone.
Shape ring_shape(std::span<const Vec2> ring);

/// Flat points as what they are: the segment they span, or a circle of radius 0.
Shape flat_shape(std::span<const Vec2> points);

}  // namespace flatray
