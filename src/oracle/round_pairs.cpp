#include "oracle/round_pairs.h"

#include <array>
#include <cmath>

#include "geom/polygon.h"

namespace flatray::oracle {
namespace {

using Ring = std::vector<Vec2>;

// A point, a segment or a quadrilateral of whole coordinates.
Ring whole_ring(Draw& draw) {
  const double x = draw.below(14) - 7, y = draw.below(14) - 7;
  const double w = 1 + draw.below(3), h = draw.below(3);
  const Vec2 at(x, y);
  switch (static_cast<int>(draw.below(3))) {
    case 0:
      return {at};
    case 1:
      return {at, at + Vec2(w, h)};
    default:
      return {at, at + Vec2(w, 0), at + Vec2(w, 1 + h), at + Vec2(0, 1)};
  }
}

Vec2 whole_velocity(Draw& draw) {
  const double x = draw.below(5) - 2, y = draw.below(5) - 2;
  return {x, y};
}

RoundPair whole(Draw& draw) {
  RoundPair pair{whole_ring(draw), whole_ring(draw), whole_velocity(draw), whole_velocity(draw)};
  pair.radius_a = draw.below(4) / 2;
  pair.radius_b = pair.radius_a == 0 ? 1 : draw.below(3);
  return pair;
}

// Two that pass each other at exactly the sum of their radii, at a time that mostly is no double; what
// lies beside the point that touches is farther away, or as far.
RoundPair tangent(Draw& draw) {
  static constexpr std::array<std::array<double, 3>, 3> kTriples = {
      {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}}};
  static constexpr std::array<double, 5> kSpeeds = {1, 2, 3, 5, 7};
  const auto& [p, q, h] = kTriples[static_cast<std::size_t>(draw.below(3))];
  const double sign_p = draw.sign(), sign_q = draw.sign();
  const Vec2 way(sign_p * p, sign_q * q), across(-way.y(), way.x());
  const double reach = 1 + draw.below(3), behind = draw.below(21) - 5, x = draw.below(9),
               y = draw.below(9);
  const Vec2 at_a(x, y), at_b = at_a + reach * across - behind * way;
  RoundPair pair{{at_a}, {at_b}, whole_velocity(draw), {}};
  pair.velocity_b = pair.velocity_a + kSpeeds[static_cast<std::size_t>(draw.below(5))] * way;
  pair.radius_a = draw.below(static_cast<int>(reach * h));
  pair.radius_b = reach * h - pair.radius_a;
  const int more = static_cast<int>(draw.below(4));
  if (more == 1 || more == 3) pair.ring_b.push_back(at_b + across);
  if (more == 2) pair.ring_b.push_back(at_b + way);
  if (more == 3) pair.ring_a.push_back(at_a - across);
  return pair;
}

template <class Change>
RoundPair changed(RoundPair pair, const Change& change) {
  for (Ring* ring : {&pair.ring_a, &pair.ring_b})
    for (Vec2& p : *ring) p = {change(p.x()), change(p.y())};
  for (Vec2* v : {&pair.velocity_a, &pair.velocity_b}) *v = {change(v->x()), change(v->y())};
  pair.radius_a = change(pair.radius_a);
  pair.radius_b = change(pair.radius_b);
  return pair;
}

RoundPair decimal(Draw& draw) {
  return changed(tangent(draw), [](double x) { return x / 10; });
}

RoundPair scaled(Draw& draw) {
  const double scale = std::ldexp(1.0, static_cast<int>(draw.below(1800)) - 900);
  return changed(draw.unit() < 0.5 ? tangent(draw) : whole(draw),
                 [scale](double x) { return x * scale; });
}

RoundPair one_ulp(Draw& draw) {
  RoundPair pair = tangent(draw);
  pair.radius_b = nudge(pair.radius_b, draw);
  pair.velocity_b = nudge(pair.velocity_b, draw);
  return pair;
}

constexpr std::array kFamilies = {
    RoundPairFamily{"whole", &whole}, RoundPairFamily{"tangent", &tangent},
    RoundPairFamily{"decimal", &decimal}, RoundPairFamily{"scaled", &scaled},
    RoundPairFamily{"one-ulp", &one_ulp}};

}  // namespace

std::span<const RoundPairFamily> round_pair_families() { return kFamilies; }

RoundPair make_pair(const RoundPairFamily& family, std::uint64_t seed, std::uint64_t item) {
  constexpr std::uint64_t kFirst = 3000;  // beyond the families of other pairs
  Draw draw(seed, kFirst + static_cast<std::uint64_t>(&family - kFamilies.data()), item);
  // Rounding may have bent a ring: the next one drawn, in the end one of whole numbers.
  constexpr int kTries = 8;
  for (int i = 0; i < kTries; ++i) {
    RoundPair pair = family.make(draw);
    if (!non_convex_vertex(pair.ring_a) && !non_convex_vertex(pair.ring_b)) return pair;
  }
  return whole(draw);
}

}  // namespace flatray::oracle
