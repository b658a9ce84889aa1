#include "oracle/moving_pairs.h"

#include <array>

#include "geom/polygon.h"

namespace flatray::oracle {
namespace {

using Ring = std::vector<Vec2>;

// Convex, of whole coordinates: a hexagon, part of it, or less than a polygon, sheared.
Ring whole_ring(Draw& draw, int least) {
  static constexpr std::array<std::array<double, 2>, 6> kHexagon = {
      {{1, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 2}, {0, 1}}};
  const double wide = 1 + draw.below(3), shear = draw.below(5) - 2, high = 1 + draw.below(3);
  const Vec2 at = draw.whole_point(-10, 11);
  const int count = draw.whole(least, 7), first = draw.whole(0, 6);
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const auto& p = kHexagon[static_cast<std::size_t>((first + i) % 6)];
    ring.emplace_back(at.x() + wide * p[0] + shear * p[1], at.y() + high * p[1]);
  }
  return ring;
}

StraightPair whole_pair(Draw& draw, int least) {
  return {whole_ring(draw, least), whole_ring(draw, least), draw.whole_point(-4, 5),
          draw.whole_point(-4, 5)};
}

// Radii as lengths along x.
template <class Change>
StraightPair changed(StraightPair pair, const Change& change) {
  for (Ring* ring : {&pair.ring_a, &pair.ring_b})
    for (Vec2& p : *ring) p = change(p);
  for (Vec2* v : {&pair.velocity_a, &pair.velocity_b}) *v = change(*v);
  for (double* r : {&pair.radius_a, &pair.radius_b}) *r = change(Vec2(*r, 0)).x();
  return pair;
}

StraightPair grid(Draw& draw) { return whole_pair(draw, 3); }
StraightPair degenerate_pair(Draw& draw) { return whole_pair(draw, 1); }

StraightPair decimal(Draw& draw) {
  return changed(whole_pair(draw, 2), [](const Vec2& p) { return Vec2(p / 10); });
}

StraightPair one_ulp(Draw& draw) {
  StraightPair pair = whole_pair(draw, 2);
  pair.velocity_a = nudge(pair.velocity_a, draw);
  pair.velocity_b = nudge(pair.velocity_b, draw);
  Vec2& corner = pair.ring_a.front();
  corner = nudge(corner, draw);
  return pair;
}

StraightPair scaled(Draw& draw) {
  const double scale = draw.power(-1000, 900);
  return changed(whole_pair(draw, 1), [&](const Vec2& p) { return Vec2(p * scale); });
}

StraightPair offset(Draw& draw) {
  const double sign_x = draw.sign(), x = sign_x * draw.power(0, 52);
  const double sign_y = draw.sign(), y = sign_y * draw.power(0, 52);
  const Vec2 way(x, y);
  StraightPair pair = whole_pair(draw, 1);
  for (Ring* ring : {&pair.ring_a, &pair.ring_b})
    for (Vec2& p : *ring) p += way;
  return pair;
}

// Velocities almost along a side, or almost the same.
StraightPair near_parallel(Draw& draw) {
  StraightPair pair = whole_pair(draw, 2);
  const Vec2 along = pair.ring_a[1] - pair.ring_a[0];
  const double tilt = draw.signed_halves(60), other = draw.signed_halves(60);
  pair.velocity_a = pair.velocity_b + draw.below(3) * along + Vec2(tilt, other);
  return pair;
}

StraightPair pair_of_magnitudes(Draw& draw) {
  StraightPair pair = whole_pair(draw, 1);
  const double large = draw.power(-40, 40);
  const double fast = draw.power(-80, 80);
  for (Vec2& p : pair.ring_a) p *= large;
  pair.velocity_b *= fast;
  return pair;
}

StraightPair sliver(Draw& draw) {
  StraightPair pair = whole_pair(draw, 3);
  const double thin = draw.halves(1000);
  for (Vec2& p : pair.ring_a) p.y() *= thin;
  return pair;
}

StraightPair uneven(Draw& draw) {
  const double x = draw.unit(), y = draw.unit(), slant = draw.unit();
  return changed(whole_pair(draw, 1), [&](const Vec2& p) {
    return Vec2(p.x() * (0.5 + x) + slant * p.y(), p.y() * (0.5 + y));
  });
}

// A corner as near to a slanted side as doubles are, the shapes on either side of it.
StraightPair touching(Draw& draw) {
  const auto point = [&] { return Vec2{6 * draw.unit() - 3, 6 * draw.unit() - 3}; };
  const Vec2 a = point(), b = point(), c = point();
  const bool left = (b - a).x() * (c - a).y() > (b - a).y() * (c - a).x();
  const Vec2 from = left ? a : b, to = left ? b : a, along = to - from, out(along.y(), -along.x());
  const Vec2 corner = from + draw.unit() * along;
  return {{from, to, c},
          {corner, corner + out - 0.5 * along, corner + out + 0.25 * along},
          draw.whole_point(-4, 5),
          draw.whole_point(-4, 5)};
}

// A point, a segment or a quadrilateral of whole coordinates.
Ring small_ring(Draw& draw) {
  const Vec2 at = draw.whole_point(-7, 7);
  const double w = 1 + draw.below(3), h = draw.below(3);
  switch (draw.whole(0, 3)) {
    case 0:
      return {at};
    case 1:
      return {at, at + Vec2(w, h)};
    default:
      return {at, at + Vec2(w, 0), at + Vec2(w, 1 + h), at + Vec2(0, 1)};
  }
}

StraightPair whole(Draw& draw) {
  StraightPair pair{small_ring(draw), small_ring(draw), draw.whole_point(-2, 3),
                    draw.whole_point(-2, 3)};
  pair.radius_a = draw.below(4) / 2;
  pair.radius_b = pair.radius_a == 0 ? 1 : draw.below(3);
  return pair;
}

// Two that pass each other at exactly the sum of their radii, at a time that mostly is no double; what
// lies beside the point that touches is farther away, or as far.
StraightPair tangent(Draw& draw) {
  static constexpr double kRightTriangles[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}};
  static constexpr double kSpeeds[] = {1, 2, 3, 5, 7};
  const auto& [p, q, h] = draw.any(kRightTriangles);
  const double sign_p = draw.sign(), sign_q = draw.sign();
  const Vec2 way(sign_p * p, sign_q * q), across(-way.y(), way.x());
  const double reach = 1 + draw.below(3), behind = draw.below(21) - 5;
  const Vec2 at_a = draw.whole_point(0, 9), at_b = at_a + reach * across - behind * way;
  StraightPair pair{{at_a}, {at_b}, draw.whole_point(-2, 3), {0, 0}};
  pair.velocity_b = pair.velocity_a + draw.any(kSpeeds) * way;
  pair.radius_a = draw.below(static_cast<int>(reach * h));
  pair.radius_b = reach * h - pair.radius_a;
  const int more = draw.whole(0, 4);
  if (more == 1 || more == 3) pair.ring_b.push_back(at_b + across);
  if (more == 2) pair.ring_b.push_back(at_b + way);
  if (more == 3) pair.ring_a.push_back(at_a - across);
  return pair;
}

StraightPair round_decimal(Draw& draw) {
  return changed(tangent(draw), [](const Vec2& p) { return Vec2(p / 10); });
}

StraightPair round_scaled(Draw& draw) {
  const double scale = draw.power(-900, 900);
  return changed(draw.unit() < 0.5 ? tangent(draw) : whole(draw),
                 [&](const Vec2& p) { return Vec2(p * scale); });
}

StraightPair round_one_ulp(Draw& draw) {
  StraightPair pair = tangent(draw);
  pair.radius_b = nudge(pair.radius_b, draw);
  pair.velocity_b = nudge(pair.velocity_b, draw);
  return pair;
}

constexpr StraightFamily kStraight[] = {
    {"grid", &grid, 2000},
    {"degenerate", &degenerate_pair, 2001},
    {"decimal", &decimal, 2002},
    {"one-ulp", &one_ulp, 2003},
    {"scaled", &scaled, 2004},
    {"offset", &offset, 2005},
    {"near-parallel", &near_parallel, 2006},
    {"mixed-magnitude", &pair_of_magnitudes, 2007},
    {"sliver", &sliver, 2008},
    {"uneven", &uneven, 2009},
    {"touching", &touching, 2010},
};
constexpr StraightFamily kRound[] = {
    {"round-whole", &whole, 3000},           {"round-tangent", &tangent, 3001},
    {"round-decimal", &round_decimal, 3002}, {"round-scaled", &round_scaled, 3003},
    {"round-one-ulp", &round_one_ulp, 3004},
};

}  // namespace

std::span<const StraightFamily> straight_families() { return kStraight; }
std::span<const StraightFamily> round_families() { return kRound; }

StraightPair make_pair(const StraightFamily& family, std::uint64_t seed, std::uint64_t item) {
  Draw draw(seed, family.number, item);
  for (;;) {
    StraightPair pair = family.make(draw);
    if (!non_convex_vertex(pair.ring_a) && !non_convex_vertex(pair.ring_b)) return pair;
  }
}

}  // namespace flatray::oracle
