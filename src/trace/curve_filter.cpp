#include "trace/curve_filter.h"

#include <algorithm>

#include "geom/decide.h"
#include "geom/primitives/bezier_roots.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

using Verdict = FilteredHit::Verdict;
constexpr FilteredHit kMissed{Verdict::missed, 0, 0, Root::none};
constexpr FilteredHit kOpen{Verdict::open, -kInfinity, kInfinity, Root::none};

// Whether a ray surely passes by what joins an arc's end to its curve: that is no longer than |k| times
// the way from the centre, where 1 + k is the square of the end's share of the radius.
bool passes_by_joint(const Ray& ray, const Ellipse& curve, const Vec2& end) {
  const auto most = [](const Near& x) { return x.size() + x.error(); };
  const auto d = pair_of(kNear, ray.direction), e = pair_of(kNear, end);
  const auto from_centre = e - pair_of(kNear, curve.centre);
  const Near size = form_size(kNear, curve), square = size * size;
  const double k_square = most(curve_power(kNear, curve, from_centre));
  const Near beside = cross(d, e - pair_of(kNear, ray.origin)), across = cross(d, from_centre);
  const double least = square.size() - square.error();
  return k_square < 0.25 * least &&
         (beside.size() - beside.error()) * least > 1.0625 * most(across) * k_square;
}

// Whether the point at which a ray crosses an arc's curve is between its ends.
std::optional<bool> crosses_between(const Ray& ray, const Arc& wall, const Near& t) {
  if (wall.extent == Arc::Extent::whole) return true;
  const auto o = pair_of(kNear, ray.origin), d = pair_of(kNear, ray.direction);
  const Pair<Near> point{o.x + d.x * t, o.y + d.y * t};
  bool known = true;
  const PlaceOn place = place_in_cone(wall, [&](const Vec2& p, const Vec2& a, const Vec2& b) {
    const auto edge = pair_of(kNear, b) - pair_of(kNear, a);
    const auto sign = cross(edge, point - pair_of(kNear, p)).sign();
    known = known && sign && *sign != Sign::zero;
    return sign.value_or(Sign::zero);
  });
  return known ? std::optional(place != PlaceOn::outside) : std::nullopt;
}

// By the roots themselves, where all of them are certain; `least` is before all that are ahead.
FilteredHit filter_roots(const Ray& ray, const Bezier& wall, double least) {
  const auto plain = [](const Near& x) { return x.value(); };
  const FilteredHit open{Verdict::open, least, kInfinity, Root::none};
  const auto roots = bernstein_roots(kNear, plain, beside_ray(kNear, wall, ray), 1);
  if (!roots) return open;
  const auto d = pair_of(kNear, ray.direction);
  const auto ahead = ahead_of_ray(kNear, wall, ray);
  RootNames names;
  FilteredHit first{Verdict::missed, kInfinity, kInfinity, Root::none};
  for (const auto& [s, multiplicity, slope] : *roots) {
    const Root name = names.next(multiplicity, slope);
    const Near t = form_at(kNear, wall, ahead, s) / dot(d, d);
    if (t.high() < 0) continue;
    const bool apart = t.high() < first.low || t.low() > first.high || first.low == kInfinity;
    if (!(t.low() > 0) || !apart) return open;
    if (t.low() < first.low) first = {Verdict::sure, t.low(), t.high(), name};
  }
  return first;
}

}  // namespace

[[gnu::flatten]] FilteredHit filter_curve(const Ray& ray, const Arc& wall, Root left) {
  if (is_departed_for_good(wall, left)) return kMissed;
  if (wall.extent == Arc::Extent::between)
    for (const Vec2& end : {wall.from, wall.to})
      if (!passes_by_joint(ray, wall.curve, end)) return kOpen;
  if (left == Root::both) return kMissed;
  const auto time = curve_time(kNear, ray, wall.curve);
  const auto chord = time.q.sign();
  if (chord == Sign::negative) return kMissed;
  const Near half = chord ? square_root(time.q) : either_root(time.q);
  for (const Root root : {Root::first, Root::second}) {
    const Near t = (root == Root::first ? time.b - half : time.b + half) / time.a;
    if (root == left || t.high() < 0) continue;
    const bool ahead = chord && t.low() > 0;
    const auto between = ahead ? crosses_between(ray, wall, t) : std::nullopt;
    if (!between) return {Verdict::open, t.low(), kInfinity, Root::none};
    if (*between) return {Verdict::sure, t.low(), t.high(), root};
  }
  return kMissed;
}

// By its control points, if they tell: a polynomial has no more roots than its coefficients change signs,
// and no value beyond them. The wall it leaves is met again only ahead of the origin.
FilteredHit filter_curve(const Ray& ray, const Bezier& wall, Root) {
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
  const double least = (Near(low) / speed).low(), most = (Near(high) / speed).high();
  if (changes > 1 || !(least > 0)) return filter_roots(ray, wall, least);
  return {Verdict::sure, least, most, last == Sign::positive ? Root::first : Root::second};
}

FilteredHit filter_curve(const Ray&, const Segment&, Root) { return kOpen; }

}  // namespace flatray
