#include <array>

#include "geom/clip.h"
#include "geom/clip_range.h"
#include "geom/polygon.h"
#include "geom/sides.h"

namespace flatray {
namespace {

using Vertices = std::span<const Vec2>;

// Sense of a convex polygon from two of its edges, the first crossed down a line and the second up,
// or the other way round; zero without area.
Sign sense(Vertices vertices, int down, int up) {
  const auto i = static_cast<std::size_t>(down), k = static_cast<std::size_t>(up);
  const Vec2 &a = vertices[i], &b = edge_end(vertices, i);
  const Sign turn = orientation(a, b, vertices[k]);
  return turn != Sign::zero ? turn : orientation(a, b, edge_end(vertices, k));
}

HitTime time_on_edge(const Ray& ray, const Vec2& velocity, Vertices vertices, int edge) {
  const auto i = static_cast<std::size_t>(edge);
  return HitTime::on_line(ray, vertices[i], vertices[i], edge_end(vertices, i), velocity);
}

// All vertices lie on the line: the polygon is a segment or a point. An end belongs to the lowest
// edge that has it.
LineHit hit_along(const Ray& ray, const Vec2& velocity, Vertices vertices) {
  const int axis = ray.direction.x() != velocity.x() ? 0 : 1;
  const Vec2 across = axis == 0 ? Vec2(0, 1) : Vec2(1, 0);
  const bool forward = ray.direction[axis] > velocity[axis];
  const auto before = [&](const Vec2& a, const Vec2& b) {
    return forward ? a[axis] < b[axis] : b[axis] < a[axis];
  };
  std::size_t first = 0, last = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (before(vertices[i], vertices[first])) first = i;
    if (before(vertices[last], vertices[i])) last = i;
  }
  const auto edge_of = [](std::size_t i) { return i == 0 ? 0 : static_cast<int>(i) - 1; };
  const auto time = [&](std::size_t i) {
    return HitTime::on_line(ray, vertices[i], Vec2(0, 0), across, velocity);
  };
  const bool point = vertices[first] == vertices[last];
  return {time(first), time(last), edge_of(first), edge_of(last),
          point ? HitClass::touch : HitClass::along};
}

// What the line has in common with a closed convex polygon.
LineHit hit_line(const Ray& ray, const Vec2& velocity, Vertices vertices) {
  const Sides sides = sides_of(
      vertices.size(),
      [&](std::size_t k) { return cross_sign(velocity, ray.direction, ray.origin, vertices[k]); },
      [&](std::size_t k) { return vertices[k] != edge_end(vertices, k); });
  if (!sides.left && !sides.right) return hit_along(ray, velocity, vertices);
  if (sides.down == kNoEdge) return {};
  const Sign turn = sense(vertices, sides.down, sides.up);
  const bool clockwise = turn == Sign::negative;
  const int enter = clockwise ? sides.up : sides.down, exit = clockwise ? sides.down : sides.up;
  return {time_on_edge(ray, velocity, vertices, enter), time_on_edge(ray, velocity, vertices, exit),
          enter, exit, sides.kind(turn != Sign::zero)};
}

}  // namespace

HitInterval clip_convex(const Ray& ray, Vertices vertices, Range within, const Vec2& velocity) {
  if (vertices.empty()) return {};
  if (ray.direction == velocity) return point_test(place_in_convex(ray.origin, vertices), within);
  return clip_to_range(hit_line(ray, velocity, vertices), within);
}

HitInterval clip_segment(const Ray& ray, const Segment& segment, Range within,
                         const Vec2& velocity) {
  HitInterval hit = clip_convex(ray, std::array{segment.a, segment.b}, within, velocity);
  // There and back again are the one edge of a segment.
  hit.edge_enter = std::min(hit.edge_enter, 0);
  hit.edge_exit = std::min(hit.edge_exit, 0);
  return hit;
}

HitInterval clip_ellipse(const Ray& ray, const Ellipse& ellipse, Range within,
                         const Vec2& velocity) {
  if (ray.direction == velocity)
    return point_test(start_place(-curve_side(ray.origin, ellipse)), within);
  const auto line = hit_curve(ray, ellipse, velocity);
  if (!line) return {};
  // There is no straight boundary to run along.
  const HitClass kind = line->tangent ? HitClass::touch : HitClass::through;
  return clip_to_range(LineHit{line->first, line->second, kNoEdge, kNoEdge, kind}, within);
}

}  // namespace flatray
