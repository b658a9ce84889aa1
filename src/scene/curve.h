#pragma once
#include <cmath>

#include "geom/cubic.h"
#include "scene/scene.h"

namespace flatray {

/// Value of a curve at `time`: that of its first key before it, of its last key after it.
///
/// Gives   at a key exactly its value, never more than the keys around or less. Linear: in
///         proportion to time. Step: the value of the last key so far. Smooth: the cubic between two keys with their
///         values and slopes. The slope is 0 at the first and the last key and where the values turn; at others,
///         between slopes d, e of the straight lines over times h before and k after it,
///         3 (h + k) / ((h + 2 k) / d + (2 h + k) / e).
/// Source  Fritsch and Butland 1984, "A method for constructing local monotone piecewise cubic
///         interpolants".
double value_at(const Curve& curve, double time);

/// The same while time goes from one moment to another, as a cubic of the part of it gone by.
///
/// Needs   no key strictly between them.
/// Error   some ulps of the values and rises at the keys around.
Cubic<double> cubic_between(const Curve& curve, double from, double to);

/// Smallest and largest value of a curve.
double lowest(const Curve& curve);
double highest(const Curve& curve);

/// `value`, and the curve added to it if there is one.
inline double plus(const Scene& scene, double value, const std::optional<CurveId>& curve,
                   double time) {
  return curve ? value + value_at(scene.curves[*curve], time) : value;
}

/// The value of a number at `time`.
inline double plus(const Scene& scene, const Moving& number, double time) {
  return plus(scene, number.value, number.curve, time);
}

inline Vec2 plus(const Scene& scene, const MovingPoint& point, double time) {
  return {plus(scene, point.value.x(), point.x, time), plus(scene, point.value.y(), point.y, time)};
}

/// Point of a path after `length` from its beginning, and the direction it goes on in (an edge of
/// the path, of its length). An open path stands at its ends, a closed one goes round.
struct PathPoint {
  Vec2 at, direction;
};
PathPoint point_at(const Path& path, double length);

/// Lengths strictly between two at which `point_at` comes to a corner, or to the end of an open path:
/// calls take(length) for each.
template <class Take>
void corners_between(const Path& path, double from, double to, const Take& take) {
  const double whole = path.lengths.back();
  double round = path.closed ? std::floor(from / whole) : 0;
  for (; round * whole < to; ++round) {
    for (const double length : path.lengths)
      if (const double there = round * whole + length; there > from && there < to) take(there);
    if (!path.closed) break;
  }
}

}  // namespace flatray
