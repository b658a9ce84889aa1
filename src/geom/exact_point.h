#pragma once
#include "geom/primitives/arc.h"
#include "geom/primitives/bezier.h"

namespace flatray {

/// What follows of a point without rounding from the signs that `Point` tells of it, which is derived from this:
/// `turn(p, a, b)`, that of (b - a) x (point - p), and `side_of(arc)`, positive outside its curve. Exact.
template <class Point>
class ExactPoint {
 public:
  /// Sign of (b - a) . (point - p).
  Sign ahead(const Vec2& p, const Vec2& a, const Vec2& b) const {
    const Vec2 quarter_a(-a.y(), a.x()), quarter_b(-b.y(), b.x());
    return -self().turn(p, quarter_a, quarter_b);  // (b - a)' x w = -(b - a) . w
  }
  /// Side of the line through a segment, positive to the left of a -> b.
  Sign side_of(const Segment& wall) const { return self().turn(wall.a, wall.a, wall.b); }

  /// Where between the ends of a segment it lies, on whose line it does.
  PlaceOn between_ends(const Segment& wall) const {
    const Sign from = ahead(wall.a, wall.a, wall.b), to = ahead(wall.b, wall.b, wall.a);
    if (from == Sign::negative || to == Sign::negative) return PlaceOn::outside;
    return from == Sign::zero || to == Sign::zero ? PlaceOn::at_end : PlaceOn::inner;
  }
  /// Its place in the cone of an arc: on the arc itself, where it is on its curve.
  PlaceOn place_in(const Arc& arc) const {
    return place_in_cone(
        arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) { return self().turn(p, a, b); });
  }
  PlaceOn place_in(const Segment&) const { return PlaceOn::at_end; }
  PlaceOn place_in(const Bezier&) const { return PlaceOn::at_end; }
  /// Whether it lies on what joins an end of an arc to its curve, on whose line and side it does.
  bool is_on_joint(const Arc& arc, Sign side, const Vec2& end) const {
    const Vec2& centre = arc.curve.centre;
    return curve_side(end, arc.curve) == side && ahead(centre, centre, end) == Sign::positive &&
           ahead(end, centre, end) != side;
  }

  /// Whether it lies on the wall, and where.
  PlaceOn place_on(const Segment& wall) const {
    return side_of(wall) == Sign::zero ? between_ends(wall) : PlaceOn::outside;
  }
  PlaceOn place_on(const Arc& arc) const {
    const Sign side = self().side_of(arc);
    if (side == Sign::zero) return place_in(arc);
    if (arc.extent != Arc::Extent::between) return PlaceOn::outside;
    const Vec2& centre = arc.curve.centre;
    const auto joins = [&](const Vec2& end) {
      return self().turn(centre, centre, end) == Sign::zero && is_on_joint(arc, side, end);
    };
    return joins(arc.from) || joins(arc.to) ? PlaceOn::at_end : PlaceOn::outside;
  }

 private:
  const Point& self() const { return static_cast<const Point&>(*this); }
};

}  // namespace flatray
