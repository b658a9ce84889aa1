#pragma once
#include <vector>

#include "base/portable_math.h"
#include "geom/decide.h"
#include "geom/pair.h"
#include "trace/surfaces.h"

namespace flatray {

/// Walls by the way along each: a segment from its first end, an arc counter-clockwise from its
/// beginning, a circle from its rightmost point, an ellipse from the end of its first
/// half-diameter.
///
/// Needs   `walls` to outlive it.
/// Error   a few ulps of the largest coordinate; of ellipses some 1e-13 of the length where one
///         axis is up to ten times the other.
/// Cost    1 us and under; lengths along ellipses and Bezier curves are summed up once.
class WallPlaces {
 public:
  explicit WallPlaces(const Surfaces& walls);
  double length(std::uint32_t surface) const { return lengths_[surface].back(); }
  Vec2 point(std::uint32_t surface, double position) const;
  /// Where on a wall a point lies that is near it.
  double position(std::uint32_t surface, const Vec2& point) const;

 private:
  const Surfaces& walls_;
  std::vector<std::vector<double>> lengths_;  // by surface: up to equal parts of it, or all of it
};

/// By how much one point is turned counter-clockwise from another as seen from `centre`, from -pi to pi.
/// Error   some ulps, also of small angles.
inline double turn_between(const Vec2& from, const Vec2& to, const Vec2& centre = Vec2(0, 0)) {
  const double turn = round_once([&](const auto& number) {
    const auto at = pair_of(number, centre);
    return cross(pair_of(number, from) - at, pair_of(number, to) - at);
  });
  return portable::atan2(turn, (from - centre).dot(to - centre));
}
/// A vector of length 1 along one.
inline Vec2 direction_of(const Vec2& v) { return v / size_of(v); }

/// Points along a wall, both ends among them, to draw it: the two of a segment, many of a curve.
std::vector<Vec2> wall_outline(const Surfaces& walls, std::uint32_t surface);

/// Unit normal to the left of a segment, or outward of a curve.
Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point);
/// Sine of the angle from a normal to a direction, positive to its left.
inline double sine_of(const Vec2& direction, const Vec2& normal) {
  return direction.dot(Vec2(-normal.y(), normal.x())) / direction.norm();
}
/// Of a wall as seen from the side `normal` points to: positive where rays that come from there are
/// parted.
double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal);

}  // namespace flatray
