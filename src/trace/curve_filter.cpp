#include "trace/curve_filter.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace flatray {
namespace {

// Eight roundings of the terms a number is made of; twice what any below has.
constexpr double kRounding = 0x1p-50;
constexpr double kLeast = 0x1p-400, kMost = 0x1p400;

// A number that is off by at most `error`.
struct Near {
  double value, error;
};
Near exactly(double x) { return {x, 0}; }

Near operator*(const Near& a, const Near& b) {
  const double value = a.value * b.value;
  return {value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                     kRounding * std::fabs(value)};
}
Near operator+(const Near& a, const Near& b) {
  return {a.value + b.value, (a.error + b.error) * (1 + kRounding) +
                                 kRounding * (std::fabs(a.value) + std::fabs(b.value))};
}
Near operator-(const Near& a, const Near& b) { return a + Near{-b.value, b.error}; }

// Below and above value / a.
double below(double value, const Near& a) {
  const double t = value / (value < 0 ? a.value - a.error : a.value + a.error);
  return t - kRounding * std::fabs(t);
}
double above(double value, const Near& a) { return -below(-value, a); }

std::optional<Sign> sign_of(const Near& x) {
  if (x.value > x.error) return Sign::positive;
  if (x.value < -x.error) return Sign::negative;
  return std::nullopt;
}

using Verdict = FilteredCurve::Verdict;
constexpr FilteredCurve kOpen{Verdict::open, -kInfinity, kInfinity, Root::none};

// t = (b -+ sqrt(r^2 a - k^2)) / a, as geom/hit_time.cpp has it.
FilteredCurve filter_whole(const Ray& ray, const Ellipse& curve) {
  const Vec2 to = curve.centre - ray.origin;
  const Pair<Near> d = curve_form(exactly, curve, pair_of(exactly, ray.direction));
  const Pair<Near> w = curve_form(
      exactly, curve,
      Pair<Near>{{to.x(), kRounding * std::fabs(to.x())}, {to.y(), kRounding * std::fabs(to.y())}});
  const Near r = form_size(exactly, curve);
  const Near a = dot(d, d), b = dot(d, w), k = cross(d, w), r2 = r * r;
  const double far = std::fabs(w.x.value) + std::fabs(w.y.value);
  if (!(a.value > kLeast && a.value < kMost && r2.value > kLeast && r2.value < kMost &&
        (far == 0 || (far > kLeast && far < kMost)) && a.error < 0.25 * a.value))
    return kOpen;
  const Near q = r2 * a - k * k;
  if (q.value < -q.error) return {Verdict::missed, 0, 0, Root::none};
  const double most = std::sqrt(q.value + q.error) * (1 + kRounding);
  if (b.value + b.error + most < 0) return {Verdict::missed, 0, 0, Root::none};
  const double low = below(b.value - b.error - most, a);
  if (!(q.value > q.error)) return {Verdict::open, low, kInfinity, Root::none};
  const double least = std::sqrt(q.value - q.error) * (1 - kRounding);
  if (low > 0) return {Verdict::sure, low, above(b.value + b.error - least, a), Root::first};
  if (b.value + b.error - least < 0 && b.value - b.error + least > 0)
    return {Verdict::sure, below(b.value - b.error + least, a), above(b.value + b.error + most, a),
            Root::second};
  return {Verdict::open, low, kInfinity, Root::none};
}

}  // namespace

// What joins an arc to its ends is met at other times than its curve.
FilteredCurve filter_curve(const Ray& ray, const Arc& wall, bool is_left) {
  if (wall.extent == Arc::Extent::between) return kOpen;
  const FilteredCurve hit = filter_whole(ray, wall.curve);
  if (hit.verdict == Verdict::missed) return hit;
  if (is_left) return kOpen;
  if (wall.extent == Arc::Extent::whole) return hit;
  return {Verdict::open, hit.low, kInfinity, Root::none};
}

// By its control points: a polynomial has no more roots than its coefficients change signs, and no
// value beyond them.
FilteredCurve filter_curve(const Ray& ray, const Bezier& wall, bool is_left) {
  const Pair<Near> d = pair_of(exactly, ray.direction);
  const Near speed = dot(d, d);
  if (!(speed.value > kLeast && speed.value < kMost)) return kOpen;
  double low = kInfinity, high = -kInfinity;
  int changes = 0;
  Sign last = Sign::zero;
  for (int k = 0; k <= wall.degree; ++k) {
    const Vec2 to = wall.point(k) - ray.origin;
    const double far = std::fabs(to.x()) + std::fabs(to.y());
    if (!(far == 0 || (far > kLeast && far < kMost))) return kOpen;
    const Pair<Near> w{{to.x(), kRounding * std::fabs(to.x())},
                       {to.y(), kRounding * std::fabs(to.y())}};
    const Near ahead = dot(d, w);
    low = std::min(low, ahead.value - ahead.error);
    high = std::max(high, ahead.value + ahead.error);
    const Sign side = sign_of(cross(d, w)).value_or(Sign::zero);
    if (side == Sign::zero) changes = 4;  // unknown
    if (last != Sign::zero && side == -last) ++changes;
    last = side;
  }
  if (high < 0 || changes == 0) return {Verdict::missed, 0, 0, Root::none};
  if (is_left) return kOpen;
  if (changes > 1 || !(low > 0)) return {Verdict::open, below(low, speed), kInfinity, Root::none};
  return {Verdict::sure, below(low, speed), above(high, speed),
          last == Sign::positive ? Root::first : Root::second};
}

FilteredCurve filter_curve(const Ray&, const Segment&, bool) { return kOpen; }

}  // namespace flatray
