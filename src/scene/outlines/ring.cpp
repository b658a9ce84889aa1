#include "scene/outlines/ring.h"

namespace flatray {
namespace {

bool between(double a, double b, double c) { return (a <= b && b <= c) || (a >= b && b >= c); }

// Whether b lies on the segment from a to c: passing over it changes nothing. Exact.
bool is_passed_over(const Vec2& a, const Vec2& b, const Vec2& c) {
  return between(a.x(), b.x(), c.x()) && between(a.y(), b.y(), c.y()) &&
         orientation(a, b, c) == Sign::zero;
}

// A stretch of straight boundary ends where the last vertex is dropped: its edges become one.
void drop_last(CleanRing& ring) {
  ring.vertices.pop_back();
  const std::int32_t dropped = ring.edges.back();
  ring.edges.pop_back();
  ring.edges.back() = std::min(ring.edges.back(), dropped);
}

// The first vertex may lie in the middle of a run that goes on at the end of the list.
void drop_first(CleanRing& ring) {
  ring.edges.back() = std::min(ring.edges.back(), ring.edges.front());
  ring.vertices.erase(ring.vertices.begin());
  ring.edges.erase(ring.edges.begin());
}

// Whose vertices are there.
void end_piece(Shape& shape, bool clockwise) {
  shape.begin.push_back(static_cast<std::uint32_t>(shape.vertices.size()));
  if (!clockwise) return;
  shape.clockwise.resize(shape.piece_count());
  shape.clockwise.back() = true;
}

}  // namespace

bool is_flat(std::span<const Vec2> points) {
  const Vec2* other = nullptr;
  for (const Vec2& point : points) {
    if (point == points.front()) continue;
    if (other == nullptr) other = &point;
    if (orientation(points.front(), *other, point) != Sign::zero) return false;
  }
  return true;
}

CleanRing clean_ring(std::span<const Vec2> ring) {
  CleanRing clean;
  auto& kept = clean.vertices;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] == ring[(i + 1) % ring.size()]) continue;  // an edge of no length has no number
    while (kept.size() >= 2 && is_passed_over(kept[kept.size() - 2], kept.back(), ring[i]))
      drop_last(clean);
    kept.push_back(ring[i]);
    clean.edges.push_back(static_cast<std::int32_t>(i));
  }
  while (kept.size() > 2 && is_passed_over(kept[kept.size() - 2], kept.back(), kept.front()))
    drop_last(clean);
  while (kept.size() > 2 && is_passed_over(kept.back(), kept.front(), kept[1])) drop_first(clean);
  return clean;
}

void add_ring(Shape& shape, std::span<const Vec2> ring, std::int32_t first_edge) {
  const CleanRing clean = clean_ring(ring);
  const ConvexPieces pieces = convex_pieces(clean.vertices);
  const auto vertex = [&](std::size_t i) { return pieces.vertices.begin() + pieces.begin[i]; };
  for (std::size_t i = 0; i + 1 < pieces.begin.size(); ++i) {
    shape.vertices.insert(shape.vertices.end(), vertex(i), vertex(i + 1));
    end_piece(shape, pieces.clockwise);
  }
  for (const std::int32_t edge : pieces.edges)
    shape.edges.push_back(edge < 0 ? -1 : first_edge + clean.edges[static_cast<std::size_t>(edge)]);
}

void add_triangle(Shape& shape, std::span<const Vec2, 3> corners, bool clockwise,
                  std::int32_t first_edge) {
  shape.vertices.push_back(corners[0]);
  shape.vertices.push_back(corners[clockwise ? 2 : 1]);
  shape.vertices.push_back(corners[clockwise ? 1 : 2]);
  end_piece(shape, clockwise);
  for (const std::int32_t edge : {clockwise ? 2 : 0, 1, clockwise ? 0 : 2})
    shape.edges.push_back(first_edge + edge);
}

Shape ring_shape(std::span<const Vec2> ring) {
  Shape shape;
  add_ring(shape, ring);
  return shape;
}

Shape flat_shape(std::span<const Vec2> points) {
  if (points.empty()) return {};
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), is_before);
  if (*low == *high) return {.circles = {{*low, 0}}};
  return {.segments = {{*low, *high}}};
}

}  // namespace flatray
