#include "oracle/contact.h"

#include <cmath>
#include <vector>

#include "oracle/distance.h"
#include "oracle/point.h"

namespace flatray::oracle {
namespace {

using Bound = std::optional<Rational>;
using ExactRing = RingOf<Rational>;

void add_edges(const ExactRing& ring, std::vector<Point>& all) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point edge = ring[(i + 1) % ring.size()] - ring[i];
    if (!is_zero(edge)) all.push_back(edge);
  }
}

// Times that satisfy every condition so far, closed; and whether some satisfy all strictly.
class Times {
 public:
  // low <= speed * t <= high
  void require(const Rational& low, const Rational& speed, const Rational& high) {
    if (speed == 0) {
      never_ = never_ || low > 0 || high < 0;
      never_inside_ = never_inside_ || low >= 0 || high <= 0;
      return;
    }
    const Rational first = (speed > 0 ? low : high) / speed,
                   last = (speed > 0 ? high : low) / speed;
    if (!first_ || first > *first_) first_ = first;
    if (!last_ || last < *last_) last_ = last;
  }
  // Whether none in [low, high] satisfies all; whether one does so strictly.
  bool empty(const Bound& low, const Bound& high) const {
    const auto exceeds = [](const Bound& a, const Bound& b) { return a && b && *a > *b; };
    return never_ || exceeds(first_, last_) || exceeds(low, last_) || exceeds(first_, high);
  }
  bool inside(const Bound& low, const Bound& high) const {
    const auto reaches = [](const Bound& a, const Bound& b) { return a && b && *a >= *b; };
    return !never_ && !never_inside_ && !reaches(first_, last_) && !reaches(low, last_) &&
           !reaches(first_, high);
  }
  const Bound& first() const { return first_; }
  const Bound& last() const { return last_; }

 private:
  bool never_ = false, never_inside_ = false;
  Bound first_, last_;
};

struct Shadow {
  Rational low, high;
};
Shadow shadow(const Point& axis, const ExactRing& ring) {
  Shadow all{dot(axis, ring[0]), dot(axis, ring[0])};
  for (const Point& p : ring) {
    const Rational s = dot(axis, p);
    if (s < all.low) all.low = s;
    if (s > all.high) all.high = s;
  }
  return all;
}

// Across every edge; where nothing else bounds the shapes also along it; two axes of points.
std::vector<Point> axes_of(const std::vector<Point>& edges, bool has_area) {
  if (edges.empty()) return {{1, 0}, {0, 1}};
  std::vector<Point> axes;
  for (const Point& edge : edges) {
    axes.push_back({-edge.y, edge.x});
    if (!has_area) axes.push_back(edge);
  }
  return axes;
}

Bound bound(double t) { return std::isinf(t) ? Bound() : Bound(t); }

ContactTruth truth_of_cores(const MovingCore& a, const MovingCore& b, Range within) {
  const ExactRing ring_a = exact_ring(a.ring), ring_b = exact_ring(b.ring);
  const Point way = exact(b.velocity) - exact(a.velocity);
  const Bound low = bound(within.low), high = bound(within.high), zero = Rational(0);
  std::vector<Point> edges;
  add_edges(ring_a, edges);
  add_edges(ring_b, edges);
  bool has_area = false;
  for (const Point& edge : edges) has_area = has_area || cross(edge, edges.front()) != 0;
  Times times;
  for (const Point& axis : axes_of(edges, has_area)) {
    const Shadow of_a = shadow(axis, ring_a), of_b = shadow(axis, ring_b);
    times.require(of_a.low - of_b.high, dot(axis, way), of_a.high - of_b.low);
  }
  ContactTruth found;
  if (!times.empty(zero, zero))
    found.start = has_area && times.inside(zero, zero) ? StartPlace::inside : StartPlace::boundary;
  if (times.empty(low, high)) return found;
  found.first = !times.first() || (low && *low > *times.first()) ? low : times.first();
  found.last = !times.last() || (high && *high < *times.last()) ? high : times.last();
  const bool one_instant = found.first && found.last && *found.first == *found.last;
  found.kind = has_area && times.inside(low, high)       ? HitClass::through
               : one_instant || a.velocity == b.velocity ? HitClass::touch
                                                         : HitClass::along;
  return found;
}

ExactRing at_time(const MovingCore& body, const Rational& t) {
  ExactRing ring = exact_ring(body.ring);
  for (Point& p : ring) p = p + t * exact(body.velocity);
  return ring;
}

// When vertices are nearest to each other, within the range.
std::vector<Rational> nearest_times(const MovingCore& a, const MovingCore& b, Range within) {
  const Point way = exact(b.velocity) - exact(a.velocity);
  std::vector<Rational> times;
  for (const Vec2& p : a.ring)
    for (const Vec2& q : b.ring) {
      const Rational t = dot(exact(p) - exact(q), way) / dot(way, way);
      times.push_back(within.low == 0 && t < 0 ? 0 : t);
    }
  return times;
}

}  // namespace

// A core within the other is met by its vertices for none; as still bodies they are told apart.
Sign apart_at(const MovingCore& a, const MovingCore& b, const Rational& t) {
  const Rational reach = Rational(a.radius) + Rational(b.radius);
  return (squared_gap(at_time(a, t), at_time(b, t)) - reach * reach).sign();
}

ContactTruth contact_truth(const MovingCore& a, const MovingCore& b, Range within) {
  ContactTruth cores = truth_of_cores(a, b, within);
  if (a.radius == 0 && b.radius == 0) return cores;
  const bool cores_meet = cores.start != StartPlace::outside;
  const Sign at_start = cores_meet ? Sign::negative : apart_at(a, b, 0);
  ContactTruth truth;
  truth.start = at_start == Sign::negative ? StartPlace::inside
                : at_start == Sign::zero   ? StartPlace::boundary
                                           : StartPlace::outside;
  const bool is_still = a.velocity == b.velocity;
  if (is_still || cores.kind != HitClass::miss) {
    truth.kind = is_still && at_start == Sign::positive ? HitClass::miss
                 : is_still && at_start == Sign::zero   ? HitClass::touch
                                                        : HitClass::through;
    return truth;
  }
  for (const Rational& t : nearest_times(a, b, within)) {
    const Sign apart = apart_at(a, b, t);
    if (apart == Sign::negative) return {HitClass::through, truth.start, {}, {}};
    if (apart == Sign::positive) continue;
    if (!truth.first || t < *truth.first) truth.first = t;
    if (!truth.last || t > *truth.last) truth.last = t;
  }
  truth.kind = !truth.first                  ? HitClass::miss
               : *truth.first == *truth.last ? HitClass::touch
                                             : HitClass::along;
  return truth;
}

}  // namespace flatray::oracle
