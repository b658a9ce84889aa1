#include "oracle/contact.h"

#include <cmath>
#include <vector>

#include "oracle/point.h"

namespace flatray::oracle {
namespace {

using Bound = std::optional<Rational>;

struct Body {
  std::vector<Point> ring;
  Point velocity;
};

Body exact_body(std::span<const Vec2> ring, const Vec2& velocity) {
  Body body{{}, exact(velocity)};
  for (const Vec2& p : ring) body.ring.push_back(exact(p));
  return body;
}

void add_edges(const Body& body, std::vector<Point>& all) {
  for (std::size_t i = 0; i < body.ring.size(); ++i) {
    const Point edge = body.ring[(i + 1) % body.ring.size()] - body.ring[i];
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
Shadow shadow(const Point& axis, const Body& body) {
  Shadow all{dot(axis, body.ring[0]), dot(axis, body.ring[0])};
  for (const Point& p : body.ring) {
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

}  // namespace

ContactTruth contact_truth(std::span<const Vec2> ring_a, const Vec2& velocity_a,
                           std::span<const Vec2> ring_b, const Vec2& velocity_b, Range within) {
  const Body a = exact_body(ring_a, velocity_a), b = exact_body(ring_b, velocity_b);
  const Bound low = bound(within.low), high = bound(within.high), zero = Rational(0);
  std::vector<Point> edges;
  add_edges(a, edges);
  add_edges(b, edges);
  bool has_area = false;
  for (const Point& edge : edges) has_area = has_area || cross(edge, edges.front()) != 0;
  Times times;
  for (const Point& axis : axes_of(edges, has_area)) {
    const Shadow of_a = shadow(axis, a), of_b = shadow(axis, b);
    times.require(of_a.low - of_b.high, dot(axis, b.velocity - a.velocity), of_a.high - of_b.low);
  }
  ContactTruth found;
  if (!times.empty(zero, zero))
    found.start = has_area && times.inside(zero, zero) ? StartPlace::inside : StartPlace::boundary;
  if (times.empty(low, high)) return found;
  found.first = !times.first() || (low && *low > *times.first()) ? low : times.first();
  found.last = !times.last() || (high && *high < *times.last()) ? high : times.last();
  const bool one_instant = found.first && found.last && *found.first == *found.last;
  found.kind = has_area && times.inside(low, high)       ? HitClass::through
               : one_instant || velocity_a == velocity_b ? HitClass::touch
                                                         : HitClass::along;
  return found;
}

}  // namespace flatray::oracle
