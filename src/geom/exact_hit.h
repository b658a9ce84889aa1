#pragma once
#include "geom/exact_point.h"
#include "geom/hit_time.h"

namespace flatray {

/// The point at which a ray crosses the line through a segment. A wall parallel to an axis gives one
/// coordinate without error.
template <class Make>
auto line_point(const Make& number, const Ray& ray, const Segment& wall) {
  const auto edge = pair_of(number, wall.b) - pair_of(number, wall.a);
  const auto d = pair_of(number, ray.direction), o = pair_of(number, ray.origin);
  const auto t = cross(pair_of(number, wall.a) - o, edge) / cross(d, edge);
  const bool upright = wall.a.x() == wall.b.x(), level = wall.a.y() == wall.b.y();
  return Pair<decltype(number(0.0))>{upright ? number(wall.a.x() + 0.0) : o.x + d.x * t,
                                     level ? number(wall.a.y() + 0.0) : o.y + d.y * t};
}

/// The point at which a ray arrives at a wall, without rounding: origin + t * direction for the
/// exact t.
///
/// Cost    bounded double-doubles, well under 1 us; the rationals, some 20 us, where those leave a
///         doubt.
class ExactHit : public ExactPoint<ExactHit> {
 public:
  /// Needs   a ray that crosses the wall: not along a segment, nor tangent to a curve.
  ExactHit(const Ray& ray, const Segment& wall, Root = Root::none);
  ExactHit(const Ray& ray, const Ellipse& wall, Root root);
  ExactHit(const Ray& ray, const Arc& wall, Root root) : ExactHit(ray, wall.curve, root) {}
  ExactHit(const Ray& ray, const Bezier& wall, Root root);

  /// Nearest double of each coordinate.
  Vec2 nearest() const;
  /// A normal of the curve at the point, outward or to the left, nearest doubles: for a circle the
  /// point as seen from its centre. Needs a hit of a curve.
  Vec2 normal() const;

  /// Sign of (b - a) x (point - p). Exact.
  Sign turn(const Vec2& p, const Vec2& a, const Vec2& b) const;
  using ExactPoint::side_of;
  /// Positive outside the curve, zero on it. Exact.
  Sign side_of(const Arc& wall) const;
  /// Positive to the left of the curve, which must be near. Exact, unless the ray is about tangent to the
  /// curve within some 1e-30 of it; 0 where nothing tells.
  Sign side_of(const Bezier& wall) const;
  using ExactPoint::place_on;
  PlaceOn place_on(const Bezier& wall) const;
  /// The side on which the ray passes by a wall that it only touches, of an arc by its curve; none where it
  /// crosses it. Exact.
  std::optional<Sign> touched_side(const Arc& arc) const;
  std::optional<Sign> touched_side(const Segment&) const { return std::nullopt; }
  std::optional<Sign> touched_side(const Bezier& wall) const;

 private:
  // Of a polynomial of t.
  Sign sign(const Polynomial& of_time) const;
  double rounded(const Polynomial& of_time) const;

  Ray ray_;
  HitTime time_;
  Ellipse curve_;  // its centre 0 for a segment and a Bezier curve
  // Of the point, as curve_form has it; of a Bezier curve a vector along it there; 0 for a
  // segment.
  Pair<Bounded> form_;
  Pair<Bounded> from_;  // the point as seen from the centre
  std::optional<Bezier> bezier_;
  std::optional<BezierRoot> root_;
};

}  // namespace flatray
