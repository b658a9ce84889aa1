#include "trace/curve_filter.h"

#include <algorithm>

#include "geom/decide.h"

namespace flatray {
namespace {

using Verdict = FilteredCurve::Verdict;
constexpr FilteredCurve kMissed{Verdict::missed, 0, 0, Root::none};
constexpr FilteredCurve kOpen{Verdict::open, -kInfinity, kInfinity, Root::none};

[[gnu::flatten]] FilteredCurve filter_whole(const Ray& ray, const Ellipse& curve) {
  const auto time = curve_time(kNear, ray, curve);
  const auto chord = time.q.sign();
  if (chord == Sign::negative) return kMissed;
  const Near half = chord ? square_root(time.q) : either_root(time.q);
  const Near first = (time.b - half) / time.a;
  if (chord && first.low() > 0) return {Verdict::sure, first.low(), first.high(), Root::first};
  const Near second = (time.b + half) / time.a;
  if (second.high() < 0) return kMissed;
  if (chord && first.high() < 0 && second.low() > 0)
    return {Verdict::sure, second.low(), second.high(), Root::second};
  return {Verdict::open, first.low(), kInfinity, Root::none};
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
  const auto d = pair_of(kNear, ray.direction), origin = pair_of(kNear, ray.origin);
  const Near speed = dot(d, d);
  double low = kInfinity, high = -kInfinity;
  int changes = 0;
  Sign last = Sign::zero;
  for (int k = 0; k <= wall.degree; ++k) {
    const auto to = pair_of(kNear, wall.point(k)) - origin;
    const Near ahead = dot(d, to);
    if (!(ahead.error() < kInfinity)) return kOpen;
    low = std::min(low, ahead.low());
    high = std::max(high, ahead.high());
    const Sign side = cross(d, to).sign().value_or(Sign::zero);
    if (side == Sign::zero) changes = 4;  // unknown
    if (last != Sign::zero && side == -last) ++changes;
    last = side;
  }
  if (high < 0 || changes == 0) return kMissed;
  if (is_left) return kOpen;
  const double least = (Near(low) / speed).low(), most = (Near(high) / speed).high();
  if (changes > 1 || !(least > 0)) return {Verdict::open, least, kInfinity, Root::none};
  return {Verdict::sure, least, most, last == Sign::positive ? Root::first : Root::second};
}

FilteredCurve filter_curve(const Ray&, const Segment&, bool) { return kOpen; }

}  // namespace flatray
