#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/small_vector.h"
#include "geom/bounds.h"
#include "geom/enclosure.h"
#include "geom/hit_interval.h"
#include "geom/pair.h"
#include "geom/polynomial.h"
#include "geom/ray.h"

namespace flatray {

/// A wall along a Bezier curve: a cubic, or a quadratic whose middle point has a weight, which is an arc of a
/// conic: of an ellipse below 1, of a parabola at 1, of a hyperbola above.
///
/// Needs   control points that are not all on one line, a weight in its range. The curve is the one of these
///         doubles, by its parameter s from 0 at the first point to 1 at the last.
struct Bezier {
  std::array<Vec2, 4> points;
  int degree;         ///< 2 or 3; of 2 the last point plays no part
  double weight = 1;  ///< of the middle point; of 3 it is 1

  /// Least and greatest weight: beyond, doubles no longer tell places near an end by s.
  static constexpr double kLeastWeight = 0x1p-40, kMostWeight = 0x1p40;

  Bezier(const Vec2& a, const Vec2& b, const Vec2& c, double of_middle = 1)
      : points{a, b, c, Vec2(0, 0)}, degree(2), weight(of_middle) {}
  Bezier(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
      : points{a, b, c, d}, degree(3) {}
  /// Of 3 or 4 control points.
  explicit Bezier(std::span<const Vec2> p)
      : points{p[0], p[1], p[2], p.back()}, degree(static_cast<int>(p.size()) - 1) {}

  const Vec2& point(int k) const { return points[static_cast<std::size_t>(k)]; }
  const Vec2& start() const { return points[0]; }
  const Vec2& end() const { return point(degree); }
  bool is_weighted() const { return weight != 1; }
  static constexpr bool is_in_range(double w) { return w >= kLeastWeight && w <= kMostWeight; }
};

/// Whether all control points lie on one line, as those of a wall must not. Exact.
bool is_on_one_line(const Bezier& curve);

/// Every control point put through `place`.
template <class Place>
Bezier mapped(Bezier curve, const Place& place) {
  for (int k = 0; k <= curve.degree; ++k) {
    Vec2& p = curve.points[static_cast<std::size_t>(k)];
    p = place(p);
  }
  return curve;
}

/// A polynomial over [0, 1] by its Bernstein coefficients: what a linear form of the points of a Bezier
/// curve is of the control points.
template <class Number>
using Bernstein = SmallVector<Number, 4>;

/// The values of a form, a function of points that is linear but for a constant, at the control points, times
/// their weights: its Bernstein coefficients along the curve, times those of the weights.
template <class Make, class Form>
auto bernstein_of(const Make& number, const Bezier& curve, const Form& form) {
  Bernstein<decltype(form(curve.start()))> values;
  for (int k = 0; k <= curve.degree; ++k) values.push_back(form(curve.point(k)));
  if (curve.is_weighted()) values[1] = number(curve.weight) * values[1];
  return values;
}

/// What lies beside a ray, to its left, times the length of its direction; and ahead of its origin.
template <class Make>
auto beside_ray(const Make& number, const Bezier& curve, const Ray& ray) {
  return bernstein_of(number, curve, [&](const Vec2& p) {
    return cross(pair_of(number, ray.direction), pair_of(number, p) - pair_of(number, ray.origin));
  });
}
template <class Make>
auto ahead_of_ray(const Make& number, const Bezier& curve, const Ray& ray) {
  return bernstein_of(number, curve, [&](const Vec2& p) {
    return dot(pair_of(number, ray.direction), pair_of(number, p) - pair_of(number, ray.origin));
  });
}
/// One coordinate.
template <class Make>
auto coordinates_of(const Make& number, const Bezier& curve, int axis) {
  return bernstein_of(number, curve, [&](const Vec2& p) { return number(p[axis]); });
}

/// The value at s, by the algorithm of de Casteljau; up to degree 3 written out, as loops take twice the time.
template <class Number, std::size_t kMost>
Number bernstein_value(const SmallVector<Number, kMost>& c, const Number& s) {
  const auto mix = [&](const Number& a, const Number& b) -> Number { return a + s * (b - a); };
  if (c.size() == 1) return c[0];
  if (c.size() == 2) return mix(c[0], c[1]);
  if constexpr (kMost > 4)
    if (c.size() > 4) {
      SmallVector<Number, kMost> mixed;
      for (std::size_t k = 0; k + 1 < c.size(); ++k) mixed.push_back(mix(c[k], c[k + 1]));
      return bernstein_value(mixed, s);
    }
  const Number bc = mix(c[1], c[2]), abc = mix(mix(c[0], c[1]), bc);
  return c.size() == 3 ? abc : mix(abc, mix(bc, mix(c[2], c[3])));
}
/// The same polynomial over [0, 1/2] and over [1/2, 1].
template <class Number, std::size_t kMost>
std::array<SmallVector<Number, kMost>, 2> halves(SmallVector<Number, kMost> c, const Number& half) {
  std::array<SmallVector<Number, kMost>, 2> parts;
  for (; !c.empty(); c.pop_back()) {
    parts[0].push_back(c.front());
    parts[1].push_back(c.back());
    for (std::size_t k = 0; k + 1 < c.size(); ++k) c[k] = half * c[k] + half * c[k + 1];
  }
  std::reverse(parts[1].begin(), parts[1].end());
  return parts;
}
/// The derivative by s, whose coefficients are sums of differences: numbers that need no others.
template <class Number>
Bernstein<Number> bernstein_derivative(const Bernstein<Number>& c) {
  Bernstein<Number> slope;
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    const Number rise = c[k + 1] - c[k];
    slope.push_back(c.size() == 2 ? rise : c.size() == 3 ? rise + rise : rise + rise + rise);
  }
  return slope;
}
/// The weights, of which the sum at each s is what forms are divided by.
template <class Make>
auto weights_of(const Make& number, const Bezier& curve) {
  return bernstein_of(number, curve, [&](const Vec2&) { return number(1); });
}
/// The value of a form at the point of s.
template <class Make, class Number>
Number form_at(const Make& number, const Bezier& curve, const Bernstein<Number>& form,
               const Number& s) {
  if (!curve.is_weighted()) return bernstein_value(form, s);
  return bernstein_value(form, s) / bernstein_value(weights_of(number, curve), s);
}
/// One coordinate of a vector along the curve, towards greater s: the derivative of its point by s times the
/// square of the weight there.
template <class Make>
auto rates_of(const Make& number, const Bezier& curve, int axis) {
  if (!curve.is_weighted()) return bernstein_derivative(coordinates_of(number, curve, axis));
  const auto p = [&](int k) { return number(curve.point(k)[axis]); };
  const auto twice = number(2) * number(curve.weight);
  Bernstein<decltype(number(1))> rates;
  rates.push_back(twice * (p(1) - p(0)));
  rates.push_back(p(2) - p(0));
  rates.push_back(twice * (p(2) - p(1)));
  return rates;
}
/// The same in plain doubles, of an n-th of the length, n the degree: the legs of the control polygon, where
/// nothing is weighted.
inline Bernstein<Vec2> legs_of(const Bezier& curve) {
  const auto& p = curve.points;
  if (curve.is_weighted())
    return {curve.weight * (p[1] - p[0]), 0.5 * (p[2] - p[0]), curve.weight * (p[2] - p[1])};
  Bernstein<Vec2> legs;
  for (int k = 0; k < curve.degree; ++k) legs.push_back(curve.point(k + 1) - curve.point(k));
  return legs;
}
/// The point at s, and that vector there, in the arithmetic of `number`.
template <class Make, class Number>
Pair<Number> point_at(const Make& number, const Bezier& curve, const Number& s) {
  const auto coordinate = [&](int axis) {
    return form_at(number, curve, coordinates_of(number, curve, axis), s);
  };
  return {coordinate(0), coordinate(1)};
}
template <class Make, class Number>
Pair<Number> rate_at(const Make& number, const Bezier& curve, const Number& s) {
  return {bernstein_value(rates_of(number, curve, 0), s),
          bernstein_value(rates_of(number, curve, 1), s)};
}
/// Where between `low` and `high` a function of doubles changes its sign, about: by false positions, of
/// which an end that stays twice counts half (Dowell and Jarratt 1971), every fourth time by halves.
/// Needs   opposite signs there.
template <class Function>
double sign_change(const Function& value, double low, double high) {
  double at_low = value(low), at_high = value(high);
  for (int i = 1, stayed = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    double s = i % 4 == 0 ? middle : low + (high - low) * (at_low / (at_low - at_high));
    if (!(s > low && s < high)) s = middle;
    if (!(s > low && s < high)) break;
    const double here = value(s);
    if (here == 0) return s;
    if ((here < 0) == (at_low < 0)) {
      low = s, at_low = here;
      if (stayed == 1) at_high *= 0.5;
      stayed = 1;
    } else {
      high = s, at_high = here;
      if (stayed == -1) at_low *= 0.5;
      stayed = -1;
    }
  }
  return high;
}
/// The same polynomial by powers of s.
Polynomial powers_of(Bernstein<Rational> c);

/// Where the line of a ray meets a Bezier curve.
struct BezierRoot {
  Root root;         ///< it enters from the left of the curve; `both` where it stays on its side
  int index;         ///< among all roots, in the order of s
  int multiplicity;  ///< 1 where it crosses, 2 on a tangent, 3 on one that crosses
  Sign slope;        ///< of the first derivative of what is beside the ray that is not 0
  Bounded s;         ///< 0 and 1 without error
  bool at_cusp;      ///< the curve turns back there
  std::shared_ptr<const RealRoot> exact{};  ///< s, where rationals were asked

  bool is_end() const { return s.error() == 0 && s.lo() == 0 && (s.hi() == 0 || s.hi() == 1); }
  bool is_corner() const { return at_cusp || is_end(); }
};
/// All of them, in the order of s. Exact. Needs a direction that is not zero.
std::vector<BezierRoot> roots_of(const Bezier& curve, const Ray& ray);
/// One by its name, which the ray is known to have.
BezierRoot root_of(const Bezier& curve, const Ray& ray, Root root);
/// s without error, and the value of a form there.
RealRoot exact_parameter(const Bezier& curve, const Ray& ray, const BezierRoot& root);
RealRoot exact_form(const Bezier& curve, const Ray& ray, const BezierRoot& root,
                    const Bernstein<Rational>& form);

/// Each point in which a ray meets a curve, which has no inside, in the order of t, by times that are
/// rounded once. Exact.
std::vector<HitInterval> clip_curve(const Ray& ray, const Bezier& curve, Range within = kRay);

/// What a curve covers whose control points are rounded on one line. In plain doubles.
Segment stretch_of(const Bezier& curve);

/// s of a point of the curve about as near to a point as any, in plain doubles.
double parameter_near(const Bezier& curve, const Vec2& point);
/// The tangent there, of any length, in plain doubles: towards greater s.
Vec2 tangent_at(const Bezier& curve, double s);
Vec2 point_at(const Bezier& curve, double s);
/// The box around the curve itself, in plain doubles: bounds_of() is that of its control points, which
/// surely holds it.
Bounds extent_of(const Bezier& curve);
/// Positive where it turns to the left, in plain doubles.
double bend_at(const Bezier& curve, double s);
/// How fast the point moves with s, how much it turns on its way, and a bound of its acceleration, in plain
/// doubles.
double speed_at(const Bezier& curve, double s);
double curvature_at(const Bezier& curve, double s);
double most_acceleration(const Bezier& curve);

}  // namespace flatray
