#include "oracle/round_contact.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "geom/decide.h"
#include "geom/pair.h"
#include "oracle/contact.h"

namespace flatray::oracle {
namespace {

using Point = Pair<Rational>;

std::vector<Point> at_time(const RoundCore& body, const Rational& t) {
  std::vector<Point> ring;
  for (const Vec2& p : body.ring)
    ring.push_back(pair_of(kRational, p) + t * pair_of(kRational, body.velocity));
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

namespace {

StartPlace start_of(const RoundCore& a, const RoundCore& b, bool cores_meet) {
  if (cores_meet) return StartPlace::inside;
  const Sign apart = apart_at(a, b, 0);
  return apart == Sign::negative ? StartPlace::inside
         : apart == Sign::zero   ? StartPlace::boundary
                                 : StartPlace::outside;
}

// When vertices are nearest to each other, within the range.
std::vector<Rational> nearest_times(const RoundCore& a, const RoundCore& b, Range within) {
  const Point way = pair_of(kRational, b.velocity) - pair_of(kRational, a.velocity);
  std::vector<Rational> times;
  for (const Vec2& p : a.ring)
    for (const Vec2& q : b.ring) {
      const Point from = pair_of(kRational, q) - pair_of(kRational, p);
      Rational t = -dot(from, way) / dot(way, way);
      if (within.low == 0 && t.sign() == Sign::negative) t = 0;
      times.push_back(std::move(t));
    }
  return times;
}

HitClass class_at_rest(StartPlace start) {
  return start == StartPlace::outside    ? HitClass::miss
         : start == StartPlace::boundary ? HitClass::touch
                                         : HitClass::through;
}

}  // namespace

RoundTruth round_truth(const RoundCore& a, const RoundCore& b, Range within) {
  const ContactTruth cores = contact_truth(a.ring, a.velocity, b.ring, b.velocity, within);
  RoundTruth truth;
  truth.start = start_of(a, b, cores.start != StartPlace::outside);
  if (a.velocity == b.velocity) {
    truth.kind = class_at_rest(truth.start);
    return truth;
  }
  if (cores.kind != HitClass::miss) {
    truth.kind = HitClass::through;
    return truth;
  }
  for (const Rational& t : nearest_times(a, b, within)) {
    const Sign apart = apart_at(a, b, t);
    if (apart == Sign::negative) {
      truth.kind = HitClass::through;
      truth.first = truth.last = std::nullopt;
      return truth;
    }
    if (apart == Sign::positive) continue;
    if (!truth.first || t < *truth.first) truth.first = t;
    if (!truth.last || t > *truth.last) truth.last = t;
  }
  if (truth.first) truth.kind = *truth.first == *truth.last ? HitClass::touch : HitClass::along;
  return truth;
}

}  // namespace flatray::oracle
