#pragma once
#include <span>

#include "geom/predicates.h"
#include "scene/shape.h"

namespace flatray {

/// The curve of 3 or 4 control points.
inline Bezier bezier_of(std::span<const Vec2> p) {
  return p.size() == 3 ? Bezier(p[0], p[1], p[2]) : Bezier(p[0], p[1], p[2], p[3]);
}

/// Whether all control points lie on one line, as those of a wall must not. Exact.
inline bool is_on_one_line(const Bezier& curve) {
  const Vec2& start = curve.start();
  for (int i = 1; i < curve.degree; ++i)
    for (int k = i + 1; k <= curve.degree; ++k)
      if (orientation(start, curve.point(i), curve.point(k)) != Sign::zero) return false;
  return true;
}

/// Every control point put through `place`.
template <class Place>
Bezier mapped(Bezier curve, const Place& place) {
  for (int k = 0; k <= curve.degree; ++k) {
    Vec2& p = curve.points[static_cast<std::size_t>(k)];
    p = place(p);
  }
  return curve;
}

}  // namespace flatray
