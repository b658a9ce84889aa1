#pragma once
#include "trace/all_tracers.h"

namespace flatray {

// Triangles and squares of all sizes, some thin, with duplicates, points and a room around them.
inline Surfaces crowd(Draws& draw, int shapes, double size) {
  Surfaces walls;
  const auto ring = [&](const std::vector<Vec2>& at) {
    for (std::size_t i = 0; i < at.size(); ++i) walls.add(Segment{at[i], at[(i + 1) % at.size()]});
  };
  ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (int i = 0; i < shapes; ++i) {
    const Vec2 at = draw.point();
    const double width = size * draw.unit() * draw.unit();
    ring({at, at + width * draw.point(), at - width * draw.point()});
    if (i % 16 == 0) walls.add(walls.segments[draw.bits() % walls.segments.size()]);
    if (i % 16 == 1) walls.add(Segment{at, at});
  }
  return walls;
}

inline Vec2 any_end(Draws& draw, const Surfaces& walls) {
  const Segment& s = walls.segments[draw.bits() % walls.segments.size()];
  return draw.bits() % 2 == 0 ? s.a : s.b;
}

}  // namespace flatray
