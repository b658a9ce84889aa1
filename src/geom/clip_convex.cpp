#include <array>

#include "geom/clip.h"
#include "geom/clip_range.h"
#include "geom/polygon.h"
#include "geom/sides.h"

namespace flatray {
namespace {

using Vertices = std::span<const Vec2>;

// A ray against what moves with a velocity.
struct Flight {
  Ray ray;
  Vec2 velocity{0, 0};
};
Flight along(const Segment& edge) { return {{edge.a, edge.b}, edge.a}; }

Sides look_along(const Flight& flight, Vertices vertices) {
  const Ray& ray = flight.ray;
  return sides_of(
      vertices.size(),
      [&](std::size_t k) {
        return cross_sign(flight.velocity, ray.direction, ray.origin, vertices[k]);
      },
      [&](std::size_t k) { return vertices[k] != edge_end(vertices, k); });
}

// Sense of a convex polygon from two of its edges, the first crossed down a line and the second up,
// or the other way round; zero without area.
Sign sense(Vertices vertices, int down, int up) {
  const auto i = static_cast<std::size_t>(down), k = static_cast<std::size_t>(up);
  const Vec2 &a = vertices[i], &b = edge_end(vertices, i);
  const Sign turn = orientation(a, b, vertices[k]);
  return turn != Sign::zero ? turn : orientation(a, b, edge_end(vertices, k));
}

HitTime time_on_edge(const Flight& flight, Vertices vertices, int edge) {
  const auto i = static_cast<std::size_t>(edge);
  return HitTime::on_moving_line(flight.ray, vertices[i], vertices[i], edge_end(vertices, i),
                                 flight.velocity);
}

// All vertices lie on the line: the polygon is a segment or a point. An end belongs to the lowest
// edge that has it.
LineHit hit_along(const Flight& flight, Vertices vertices) {
  const auto& [ray, velocity] = flight;
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
    return HitTime::on_moving_line(flight.ray, vertices[i], Vec2(0, 0), across, flight.velocity);
  };
  const bool point = vertices[first] == vertices[last];
  return {time(first), time(last), edge_of(first), edge_of(last),
          point ? HitClass::touch : HitClass::along};
}

// What the line has in common with a closed convex polygon whose sides are known.
LineHit hit_line(const Flight& flight, Vertices vertices, const Sides& sides) {
  if (!sides.left && !sides.right) return hit_along(flight, vertices);
  if (sides.down == kNoEdge) return {};
  const Sign turn = sense(vertices, sides.down, sides.up);
  const bool clockwise = turn == Sign::negative;
  const int enter = clockwise ? sides.up : sides.down, exit = clockwise ? sides.down : sides.up;
  return {time_on_edge(flight, vertices, enter), time_on_edge(flight, vertices, exit), enter, exit,
          sides.kind(turn != Sign::zero)};
}

HitInterval clip(const Flight& flight, Vertices vertices, Range within) {
  const auto& [ray, velocity] = flight;
  if (vertices.empty()) return {};
  if (ray.direction == velocity) return point_test(place_in_convex(ray.origin, vertices), within);
  return clip_to_range(hit_line(flight, vertices, look_along(flight, vertices)), within);
}

HitInterval clip(const Flight& flight, const Segment& segment, Range within) {
  HitInterval hit = clip(flight, std::array{segment.a, segment.b}, within);
  // There and back again are the one edge of a segment.
  hit.edge_enter = std::min(hit.edge_enter, 0);
  hit.edge_exit = std::min(hit.edge_exit, 0);
  return hit;
}

}  // namespace

HitInterval clip_convex(const Ray& ray, Vertices vertices, Range within) {
  return clip({ray}, vertices, within);
}

HitInterval clip_edge(const Segment& edge, Vertices vertices, Range within) {
  return clip(along(edge), vertices, within);
}

HitInterval clip_segment(const Ray& ray, const Segment& segment, Range within) {
  return clip({ray}, segment, within);
}

HitInterval clip_edge(const Segment& edge, const Segment& segment, Range within) {
  return clip(along(edge), segment, within);
}

}  // namespace flatray
