#include "oracle/round_contact.h"

#include "oracle/distance.h"
#include "oracle/point.h"

namespace flatray::oracle {
namespace {

RingOf<Rational> at_time(const RoundCore& body, const Rational& t) {
  RingOf<Rational> ring;
  for (const Vec2& p : body.ring) ring.push_back(exact(p) + t * exact(body.velocity));
  return ring;
}

}  // namespace

// A core within the other is met by its vertices for none; as still bodies they are told apart.
Sign apart_at(const RoundCore& a, const RoundCore& b, const Rational& t) {
  const Rational reach = Rational(a.radius) + Rational(b.radius);
  return (squared_gap(at_time(a, t), at_time(b, t)) - reach * reach).sign();
}

namespace {

StartPlace start_of(const RoundCore& a, const RoundCore& b, bool cores_meet) {
  const Sign apart = cores_meet ? Sign::negative : apart_at(a, b, 0);
  return apart == Sign::negative ? StartPlace::inside
         : apart == Sign::zero   ? StartPlace::boundary
                                 : StartPlace::outside;
}

// When vertices are nearest to each other, within the range.
std::vector<Rational> nearest_times(const RoundCore& a, const RoundCore& b, Range within) {
  const Point way = exact(b.velocity) - exact(a.velocity);
  std::vector<Rational> times;
  for (const Vec2& p : a.ring)
    for (const Vec2& q : b.ring) {
      const Rational t = dot(exact(p) - exact(q), way) / dot(way, way);
      times.push_back(within.low == 0 && t < 0 ? 0 : t);
    }
  return times;
}

HitClass class_at_rest(StartPlace start) {
  return start == StartPlace::outside    ? HitClass::miss
         : start == StartPlace::boundary ? HitClass::touch
                                         : HitClass::through;
}

}  // namespace

ContactTruth round_truth(const RoundCore& a, const RoundCore& b, Range within) {
  const ContactTruth cores = contact_truth(a.ring, a.velocity, b.ring, b.velocity, within);
  ContactTruth truth;
  truth.start = start_of(a, b, cores.start != StartPlace::outside);
  truth.kind = HitClass::through;
  if (a.velocity == b.velocity) truth.kind = class_at_rest(truth.start);
  if (a.velocity == b.velocity || cores.kind != HitClass::miss) return truth;
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
