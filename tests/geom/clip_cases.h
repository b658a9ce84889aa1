#pragma once
#include <vector>

#include "geom/polygon.h"
#include "oracle/families.h"

// Seeded clip cases for the tests of geom.
namespace flatray {

inline constexpr std::uint64_t kSeed = 20181123;
using oracle::Draw;
using oracle::nudge;

inline Draw draw_of(int family, int item) {
  return {kSeed, static_cast<std::uint64_t>(family), static_cast<std::uint64_t>(item)};
}

struct Case {
  std::vector<Vec2> polygon;
  Ray ray;
};

// A convex polygon on the integer grid [0, 8)^2, of either orientation, any first vertex; sometimes
// with repeated or collinear vertices, sometimes without area.
inline std::vector<Vec2> grid_polygon(Draw& draw) {
  for (;;) {
    std::vector<Vec2> ring;
    const int n = 3 + static_cast<int>(draw.below(4));
    for (int i = 0; i < n; ++i) ring.push_back({draw.below(8), draw.below(8)});
    if (!non_convex_vertex(ring)) return ring;
  }
}

inline Case grid_case(Draw& draw) {
  return {grid_polygon(draw),
          {{draw.below(12) - 2, draw.below(12) - 2}, {draw.below(9) - 4, draw.below(9) - 4}}};
}

inline Vec2 vertex_of(const Case& c, Draw& draw) {
  return c.polygon[static_cast<std::size_t>(draw.below(static_cast<int>(c.polygon.size())))];
}

inline Case map(Case c, const auto& f, double direction_scale = 1) {
  for (Vec2& v : c.polygon) v = f(v);
  const Vec2 tip = c.ray.origin + c.ray.direction;
  const Vec2 from = f(c.ray.origin);
  c.ray = {from, direction_scale * (f(tip) - from)};
  return c;
}

inline Case random_case(Draw& draw) {
  std::vector<Vec2> triangle;
  for (int i = 0; i < 3; ++i) triangle.push_back({draw.unit(), draw.unit()});
  return {triangle,
          {{2 * draw.unit() - 0.5, 2 * draw.unit() - 0.5}, {draw.unit() - 0.5, draw.unit() - 0.5}}};
}

}  // namespace flatray
