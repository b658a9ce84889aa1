#pragma once
#include "render/coverage/chains.h"
#include "render/coverage/stroke.h"
#include "render/coverage_families.h"

namespace flatray {

constexpr int kStrokeSide = 20;  // of the picture in which lines are drawn

inline Steps stroke_steps(const FillPath& path) {
  return steps_of(path, {0, 0, kStrokeSide, kStrokeSide});
}

inline double area_of(const Chain& chain, const LineStyle& style) {
  FillPath path;
  add_line(chain, style, path.edges);
  return covered_area(stroke_steps(path));
}

inline Chain arc_chain(const Vec2& centre, double radius, double from, double sweep) {
  const EllipseArc arc{centre, {radius, 0}, {0, radius}, from, sweep};
  return chain_of({{arc}, false});
}

inline const Chain kCorner{{{4, 4}, {14, 4}, {14, 14}}};
inline const Chain kSquare{{{4, 4}, {14, 4}, {14, 14}, {4, 14}}, true};

}  // namespace flatray
