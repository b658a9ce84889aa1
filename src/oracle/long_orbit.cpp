#include "oracle/long_orbit.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geom/pair.h"

namespace flatray::oracle {
namespace {

using Long = mpf_class;

using Place = Pair<Long>;

// mpf's own conversion cuts off.
double nearest(const Long& x) {
  if (sgn(x) == 0) return 0;
  const double low = x.get_d();
  const double high = std::nextafter(low, sgn(x) * std::numeric_limits<double>::infinity());
  const Long beyond = abs(x - low), to_next = abs(high - x);
  const int order = cmp(beyond, to_next);
  if (order != 0) return order > 0 ? high : low;
  return std::fmod(low / std::fabs(high - low), 2) == 0 ? low : high;
}

class Walker {
 public:
  Walker(const Surfaces& walls, const Ray& start, unsigned bits)
      : walls_(walls),
        bits_(bits),
        point_(place(start.origin)),
        way_(place(start.direction)),
        soon_(number(std::ldexp(1.0, -static_cast<int>(bits / 4 < 1000 ? bits / 4 : 1000)))),
        same_(1 - number(std::ldexp(1.0, -static_cast<int>(bits / 2 < 1000 ? bits / 2 : 1000)))) {}

  std::optional<LongOrbit::Bounce> bounce() {
    std::optional<Long> first;
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < walls_.size(); ++i)
      for (const Long& t : walls_.visit(i, [&](const auto& wall) { return times(wall); }))
        if (t > soon_ && (!first || t < *first * same_)) {
          first = t;
          met = i;
        }
    if (!first) return std::nullopt;
    point_ = point_ + *first * way_;
    const Place normal = walls_.visit(met, [&](const auto& wall) { return normal_of(wall); });
    const Long twice = 2 * dot(way_, normal) / dot(normal, normal);
    way_ = way_ - twice * normal;
    return LongOrbit::Bounce{met, {nearest(point_.x), nearest(point_.y)}};
  }

 private:
  Long number(double x) const { return {x, bits_}; }
  Place place(const Vec2& v) const { return {number(v.x()), number(v.y())}; }

  std::vector<Long> times(const Segment& wall) const {
    const Place along = place(wall.b) - place(wall.a), to = place(wall.a) - point_;
    const Long across = cross(way_, along);
    if (sgn(across) == 0) return {};
    const Long part = cross(to, way_) / across;
    if (part < 0 || part > 1) return {};
    return {cross(to, along) / across};
  }

  std::vector<Long> times(const Arc& arc) const {
    const Place from = in_circle(arc.curve, point_ - place(arc.curve.centre));
    const Place way = in_circle(arc.curve, way_);
    const Long a = dot(way, way), b = dot(way, from);
    const Long quarter = b * b - a * (dot(from, from) - 1);
    if (sgn(quarter) <= 0) return {};
    const Long root = sqrt(quarter);
    std::vector<Long> times;
    for (const Long& t : {Long((-b - root) / a), Long((root - b) / a)})
      if (is_on(arc, point_ + t * way_)) times.push_back(t);
    return times;
  }

  // Of the line of the way with a curve: its time and the parameter of the curve, between places where
  // what is beside the way changes its sign.
  struct OnCurve {
    Long t, s;
  };
  std::vector<OnCurve> meetings(const Bezier& wall) const {
    constexpr int kParts = 256;
    const auto beside = [&](const Long& s) { return cross(way_, point_at(wall, s) - point_); };
    std::vector<OnCurve> found;
    for (int i = 0; i < kParts; ++i) {
      Long low = number(i) / kParts, high = number(i + 1) / kParts;
      const int from = sgn(beside(low));
      if (from == 0 || from == sgn(beside(high))) continue;
      for (mp_bitcnt_t halvings = 0; halvings < bits_; ++halvings) {
        const Long middle = (low + high) / 2;
        (sgn(beside(middle)) == from ? low : high) = middle;
      }
      found.push_back({dot(way_, point_at(wall, high) - point_) / dot(way_, way_), high});
    }
    return found;
  }
  // By de Casteljau's rule: what is left of points when `most` are.
  static std::vector<Place> divided(std::vector<Place> points, const Long& s, std::size_t most) {
    for (; points.size() > most; points.pop_back())
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        points[k] = points[k] + s * (points[k + 1] - points[k]);
    return points;
  }
  std::vector<Place> points_of(const Bezier& wall) const {
    std::vector<Place> points;
    for (int k = 0; k <= wall.degree; ++k) points.push_back(place(wall.point(k)));
    return points;
  }
  Place point_at(const Bezier& wall, const Long& s) const {
    return divided(points_of(wall), s, 1)[0];
  }
  std::vector<Long> times(const Bezier& wall) const {
    std::vector<Long> times;
    for (const OnCurve& met : meetings(wall)) times.push_back(met.t);
    return times;
  }

  // Parts of the half-diameters that a vector is the sum of, by Cramer's rule.
  Place in_circle(const Ellipse& curve, const Place& w) const {
    const Place u = place(curve.u), v = place(curve.v);
    const Long whole = cross(u, v);
    return {cross(w, v) / whole, cross(u, w) / whole};
  }

  // A point of the curve is on an arc if it is to the right of the chord from end to end.
  bool is_on(const Arc& arc, const Place& point) const {
    if (arc.extent == Arc::Extent::whole) return true;
    if (arc.extent == Arc::Extent::half)
      return sgn(dot(point - place(arc.curve.centre), place(arc.from))) >= 0;
    const Place from = place(arc.from);
    return sgn(cross(place(arc.to) - from, point - from)) <= 0;
  }

  Place normal_of(const Segment& wall) const {
    const Place along = place(wall.b) - place(wall.a);
    return {-along.y, along.x};
  }
  Place normal_of(const Arc& arc) const {  // across the tangent
    const Ellipse& curve = arc.curve;
    const Place at = in_circle(curve, point_ - place(curve.centre));
    const Place tangent = at.x * place(curve.v) - at.y * place(curve.u);
    return {tangent.y, -tangent.x};
  }

  Place normal_of(const Bezier& wall) const {
    const std::vector<OnCurve> all = meetings(wall);
    const auto here =
        std::min_element(all.begin(), all.end(),
                         [](const OnCurve& a, const OnCurve& b) { return abs(a.t) < abs(b.t); });
    const std::vector<Place> chord = divided(points_of(wall), here->s, 2);
    return {chord[0].y - chord[1].y, chord[1].x - chord[0].x};
  }

  const Surfaces& walls_;
  mp_bitcnt_t bits_;
  Place point_, way_;
  Long soon_;  // what is met before is the wall just left
  Long same_;  // within this share of a time two walls are met together
};

}  // namespace

LongOrbit long_orbit(const Surfaces& walls, const Ray& start, std::uint64_t bounces,
                     unsigned bits) {
  LongOrbit orbit;
  Walker walker(walls, start, bits);
  while (orbit.bounces.size() < bounces) {
    const auto bounce = walker.bounce();
    if (!bounce) break;
    orbit.bounces.push_back(*bounce);
  }
  return orbit;
}

}  // namespace flatray::oracle
