#include "oracle/round_contact.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "geom/pair.h"
#include "oracle/contact.h"

namespace flatray::oracle {
namespace {

using Point = Pair<Rational>;
const auto kNumber = [](double x) { return Rational(x); };

std::vector<Point> at_time(const RoundCore& body, const Rational& t) {
  std::vector<Point> ring;
  for (const Vec2& p : body.ring)
    ring.push_back(pair_of(kNumber, p) + t * pair_of(kNumber, body.velocity));
  return ring;
}

Rational squared_distance(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a, from = p - a;
  const Rational ahead = dot(along, from), length = dot(along, along);
  if (ahead.sign() != Sign::positive) return dot(from, from);
  if (ahead >= length) return dot(p - b, p - b);
  const Rational across = cross(along, from);
  return across * across / length;
}

Rational least(const std::vector<Point>& points, const std::vector<Point>& ring) {
  std::optional<Rational> best;
  for (const Point& p : points)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Rational d = squared_distance(p, ring[i], ring[(i + 1) % ring.size()]);
      if (!best || d < *best) best = d;
    }
  return *best;
}

}  // namespace

Sign apart_at(const RoundCore& a, const RoundCore& b, const Rational& t) {
  const std::vector<Point> ring_a = at_time(a, t), ring_b = at_time(b, t);
  const Rational reach = Rational(a.radius) + Rational(b.radius);
  // A core within the other is met by its vertices for none; as still bodies they are told apart.
  const Rational distance = std::min(least(ring_a, ring_b), least(ring_b, ring_a));
  return (distance - reach * reach).sign();
}

bool never_meet(const RoundCore& a, const RoundCore& b) {
  constexpr Range kAlways{-kInfinity, kInfinity};
  if (contact_truth(a.ring, a.velocity, b.ring, b.velocity, kAlways).kind != HitClass::miss)
    return false;
  const Point way = pair_of(kNumber, b.velocity) - pair_of(kNumber, a.velocity);
  for (const Vec2& p : a.ring)
    for (const Vec2& q : b.ring) {
      const Point from = pair_of(kNumber, q) - pair_of(kNumber, p);
      if (apart_at(a, b, -dot(from, way) / dot(way, way)) != Sign::positive) return false;
    }
  return true;
}

}  // namespace flatray::oracle
