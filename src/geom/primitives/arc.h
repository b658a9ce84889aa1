#pragma once
#include "geom/bounds.h"
#include "geom/pair.h"
#include "geom/predicates.h"
#include "geom/quadratic.h"

namespace flatray {

/// An ellipse as a curve: the points centre + a u + b v with a^2 + b^2 = 1.
///
/// Needs   half-diameters u and v that are not parallel, unless it is a circle of radius 0. They may
///         be any two conjugate ones: rotated, scaled and sheared ellipses are of this kind too.
struct Ellipse {
  Vec2 centre{0, 0}, u{0, 0}, v{0, 0};

  Ellipse() = default;
  Ellipse(const Vec2& centre_, const Vec2& u_, const Vec2& v_) : centre(centre_), u(u_), v(v_) {}
  Ellipse(const Circle& circle) : centre(circle.centre), u(circle.radius, 0), v(0, circle.radius) {}

  /// Whether it is the circle of radius u.x(), as a Circle makes it.
  bool is_circle() const { return u.y() == 0 && v.x() == 0 && u.x() == v.y() && u.x() >= 0; }
};

/// A wall along an ellipse, or along the part of it in a closed cone at its centre.
struct Arc {
  enum class Extent : std::uint8_t {
    whole,
    half,    ///< the points X with (X - centre).from >= 0
    between  ///< counter-clockwise from the direction of point `from` to that of point `to`
  };
  Ellipse curve;
  Extent extent = Extent::whole;
  /// Needs   of `between`: neither is the centre, and they lie in different directions from it.
  ///         Where they are not on the curve they still end the arc: what lies on the line to the
  ///         centre between each and the curve is part of it, so that walls that share an end have
  ///         no gap.
  Vec2 from{0, 0}, to{0, 0};
  bool is_hollow = false;  ///< the body that it borders lies outside its curve
};

/// Where a point lies on a wall.
enum class PlaceOn : std::uint8_t { outside, inner, at_end };

/// A vector in the coordinates in which a curve is the circle |w| = form_size about its centre,
/// linear in it: twice the areas spanned with v and u; for a circle the vector itself.
template <class Make, class Number>
Pair<Number> curve_form(const Make& number, const Ellipse& curve, const Pair<Number>& w) {
  if (curve.is_circle()) return w;
  return {cross(w, pair_of(number, curve.v)), cross(pair_of(number, curve.u), w)};
}
template <class Make>
auto form_size(const Make& number, const Ellipse& curve) {
  if (curve.is_circle()) return number(curve.u.x());
  return cross(pair_of(number, curve.u), pair_of(number, curve.v));
}
/// The vector that has a form.
template <class Make, class Number>
Pair<Number> curve_vector(const Make& number, const Ellipse& curve, const Pair<Number>& form) {
  if (curve.is_circle()) return form;
  const auto u = pair_of(number, curve.u), v = pair_of(number, curve.v);
  const auto r = form_size(number, curve);
  return {(form.x * u.x + form.y * v.x) / r, (form.x * u.y + form.y * v.y) / r};
}
/// Positive outside the curve, zero on it, for a point as seen from the centre.
template <class Make, class Number>
Number curve_power(const Make& number, const Ellipse& curve, const Pair<Number>& w) {
  const Pair<Number> form = curve_form(number, curve, w);
  const auto size = form_size(number, curve);
  return dot(form, form) - size * size;
}
/// A normal of the curve at a point whose form is given, outward.
template <class Make, class Number>
Pair<Number> curve_normal(const Make& number, const Ellipse& curve, const Pair<Number>& form) {
  if (curve.is_circle()) return form;
  const auto u = pair_of(number, curve.u), v = pair_of(number, curve.v);
  return {form.x * v.y - form.y * u.y, form.y * u.x - form.x * v.x};
}

/// The same by the size of the form, which keeps it among the doubles.
template <class Make, class Number>
Pair<Number> sized_normal(const Make& number, const Ellipse& curve, const Pair<Number>& form) {
  if (curve.is_circle()) return form;
  const Pair<Number> normal = curve_normal(number, curve, form);
  auto size = form_size(number, curve);
  if (cross_sign(curve.u, curve.v) == Sign::negative) size = -size;
  return {normal.x / size, normal.y / size};
}

/// When a ray meets a curve, in the form in which it is a circle: t = (b +- sqrt(q)) / a.
template <class Number>
struct CurveTime {
  Number a, b, q;
  Number outside;  ///< of the origin: the product of the roots, times a

  /// By its second root (s > 0) or first. b and the root may cancel: then the other root and the
  /// product of both.
  Number root(int s) const {
    const Number length = s > 0 ? square_root(q) : -square_root(q);
    return (b.hi() > 0) == (s > 0) ? (b + length) / a : outside / (b - length);
  }
};
/// The same without error.
inline Quadratic root_of(const CurveTime<Rational>& time, int s) {
  return {time.b / time.a, Rational(s) / time.a, time.q};
}
template <class Number>
CurveTime<Number> chord_time(const Pair<Number>& d, const Pair<Number>& w, const Number& r) {
  const Number r2 = r * r, a = dot(d, d), k = cross(d, w);
  return {a, dot(w, d), r2 * a - k * k, dot(w, w) - r2};
}
template <class Make, class Number>
auto curve_time(const Make& number, const Vec2& origin, const Pair<Number>& direction,
                const Ellipse& curve) {
  const auto to = pair_of(number, curve.centre) - pair_of(number, origin);
  return chord_time(curve_form(number, curve, direction), curve_form(number, curve, to),
                    form_size(number, curve));
}
template <class Make>
auto curve_time(const Make& number, const Ray& ray, const Ellipse& curve) {
  return curve_time(number, ray.origin, pair_of(number, ray.direction), curve);
}

/// The point at which a ray crosses a curve, in the second root (s = 1) or the first (-1), as seen
/// from the centre, and its form. In the form in which the curve is a circle of radius r the foot of the
/// perpendicular from the centre is k d' / d.d with d' = (-d_y, d_x), k = d x w and w = o - c; from
/// there the point lies along the ray, by d / d.d times the root of r^2 d.d - k^2. A form (a, b) of a
/// vector says a u + b v = r times the vector.
template <class Number>
struct CurvePoint {
  Pair<Number> form, from_centre;
};
template <class Make>
auto curve_point(const Make& number, const Ray& ray, const Ellipse& curve, int s) {
  const auto d = curve_form(number, curve, pair_of(number, ray.direction));
  const auto w =
      curve_form(number, curve, pair_of(number, ray.origin) - pair_of(number, curve.centre));
  const auto r = form_size(number, curve), size = dot(d, d), k = cross(d, w);
  const auto along = square_root(r * r * size - k * k) * s;
  const Pair<decltype(number(0.0))> form{(d.x * along - k * d.y) / size,
                                         (d.y * along + k * d.x) / size};
  return CurvePoint<decltype(number(0.0))>{form, curve_vector(number, curve, form)};
}

/// Side of a curve `point` lies on: positive outside, zero on it, negative inside. Exact.
Sign curve_side(const Vec2& point, const Ellipse& curve);

/// Whether a point is on what joins an end of an arc to the curve, without the point on the curve. Exact.
bool is_on_joint(const Ellipse& curve, const Vec2& end, const Vec2& point);
/// Whether a point lies on what joins either end of an arc to it. Exact.
bool is_on_joints(const Arc& arc, const Vec2& point);

/// The place in the cone of an arc of a point given by where it lies: `turn(p, a, b)` is the sign of
/// (b - a) x (point - p).
template <class Turn>
PlaceOn place_in_cone(const Arc& arc, const Turn& turn) {
  const Vec2& centre = arc.curve.centre;
  if (arc.extent == Arc::Extent::whole) return PlaceOn::inner;
  if (arc.extent == Arc::Extent::half) {
    const Sign side = turn(centre, Vec2(0, 0), Vec2(arc.from.y(), -arc.from.x()));
    return side == Sign::positive ? PlaceOn::inner
           : side == Sign::zero   ? PlaceOn::at_end
                                  : PlaceOn::outside;
  }
  const Sign from = turn(centre, centre, arc.from), to = -turn(centre, centre, arc.to);
  const Sign cone = orientation(centre, arc.from, arc.to);  // of less or more than a half turn
  const bool past_from = from != Sign::negative, before_to = to != Sign::negative;
  if (cone == Sign::negative) {
    if (!past_from && !before_to) return PlaceOn::outside;
    // On the line of an end, but behind the centre, it is on the inner side of the other's.
    const bool at_end = (from == Sign::zero && !before_to) || (to == Sign::zero && !past_from);
    return at_end ? PlaceOn::at_end : PlaceOn::inner;
  }
  if (!past_from || (cone == Sign::positive && !before_to)) return PlaceOn::outside;
  return from == Sign::zero || to == Sign::zero ? PlaceOn::at_end : PlaceOn::inner;
}

inline PlaceOn place_in_cone(const Arc& arc, const Vec2& point) {
  return place_in_cone(
      arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) { return cross_sign(a, b, p, point); });
}

/// Whether two curves have the same points, whichever half-diameters they are given by. Exact.
bool is_same_curve(const Ellipse& a, const Ellipse& b);

/// The circle that an ellipse is.
inline Circle circle_of(const Ellipse& curve) { return {curve.centre, curve.u.x()}; }

/// At most the shorter half-axis, and at least the longer, but for rounding; of a circle its radius.
struct HalfAxes {
  double least, most;
};
HalfAxes half_axes(const Ellipse& curve);

/// Box around a whole curve, rounded outward.
Bounds curve_bounds(const Ellipse& curve);

}  // namespace flatray
