#include "oracle/moving_pairs.h"

#include <array>
#include <cmath>

#include "geom/polygon.h"

namespace flatray::oracle {
namespace {

using Ring = std::vector<Vec2>;

// Convex, of whole coordinates: a hexagon, part of it, or less than a polygon, sheared.
Ring whole_ring(Draw& draw, int least) {
  static constexpr std::array<std::array<double, 2>, 6> kHexagon = {
      {{1, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 2}, {0, 1}}};
  const double wide = 1 + draw.below(3), shear = draw.below(5) - 2, high = 1 + draw.below(3);
  const double x = draw.below(21) - 10, y = draw.below(21) - 10;
  const int count = least + static_cast<int>(draw.below(7 - least));
  const int first = static_cast<int>(draw.below(6));
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const auto& p = kHexagon[static_cast<std::size_t>((first + i) % 6)];
    ring.emplace_back(x + wide * p[0] + shear * p[1], y + high * p[1]);
  }
  return ring;
}

Vec2 whole_velocity(Draw& draw) {
  const double x = draw.below(9) - 4, y = draw.below(9) - 4;
  return {x, y};
}

StraightPair whole_pair(Draw& draw, int least) {
  Ring a = whole_ring(draw, least), b = whole_ring(draw, least);
  const Vec2 va = whole_velocity(draw), vb = whole_velocity(draw);
  return {std::move(a), std::move(b), va, vb};
}

template <class Change>
StraightPair changed(StraightPair pair, const Change& change) {
  for (Ring* ring : {&pair.ring_a, &pair.ring_b})
    for (Vec2& p : *ring) p = change(p);
  pair.velocity_a = change(pair.velocity_a);
  pair.velocity_b = change(pair.velocity_b);
  return pair;
}

StraightPair grid(Draw& draw) { return whole_pair(draw, 3); }
StraightPair degenerate(Draw& draw) { return whole_pair(draw, 1); }

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
  const int exponent = static_cast<int>(draw.below(1900)) - 1000;
  return changed(whole_pair(draw, 1),
                 [exponent](const Vec2& p) { return Vec2(p * std::ldexp(1.0, exponent)); });
}

StraightPair offset(Draw& draw) {
  const double x = draw.sign() * std::ldexp(1.0, static_cast<int>(draw.below(52)));
  const double y = draw.sign() * std::ldexp(1.0, static_cast<int>(draw.below(52)));
  StraightPair pair = whole_pair(draw, 1);
  for (Ring* ring : {&pair.ring_a, &pair.ring_b})
    for (Vec2& p : *ring) p += Vec2(x, y);
  return pair;
}

// Velocities almost along a side, or almost the same.
StraightPair near_parallel(Draw& draw) {
  StraightPair pair = whole_pair(draw, 2);
  const Vec2 along = pair.ring_a[1] - pair.ring_a[0];
  const double tilt = draw.sign() * std::ldexp(1.0, -static_cast<int>(draw.below(60)));
  const double other = draw.sign() * std::ldexp(1.0, -static_cast<int>(draw.below(60)));
  pair.velocity_a = pair.velocity_b + draw.below(3) * along + Vec2(tilt, other);
  return pair;
}

StraightPair mixed_magnitude(Draw& draw) {
  StraightPair pair = whole_pair(draw, 1);
  const double large = std::ldexp(1.0, static_cast<int>(draw.below(80)) - 40);
  const double fast = std::ldexp(1.0, static_cast<int>(draw.below(160)) - 80);
  for (Vec2& p : pair.ring_a) p *= large;
  pair.velocity_b *= fast;
  return pair;
}

StraightPair sliver(Draw& draw) {
  StraightPair pair = whole_pair(draw, 3);
  const double thin = std::ldexp(1.0, -static_cast<int>(draw.below(1000)));
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
  const auto point = [&] {
    const double x = 6 * draw.unit() - 3, y = 6 * draw.unit() - 3;
    return Vec2(x, y);
  };
  const Vec2 a = point(), b = point(), c = point();
  const bool left = (b - a).x() * (c - a).y() > (b - a).y() * (c - a).x();
  const Vec2 from = left ? a : b, to = left ? b : a, along = to - from, out(along.y(), -along.x());
  const Vec2 corner = from + draw.unit() * along;
  const Vec2 velocity_a = whole_velocity(draw), velocity_b = whole_velocity(draw);
  return {{from, to, c},
          {corner, corner + out - 0.5 * along, corner + out + 0.25 * along},
          velocity_a,
          velocity_b};
}

constexpr std::array kFamilies = {StraightFamily{"grid", &grid},
                                  StraightFamily{"degenerate", &degenerate},
                                  StraightFamily{"decimal", &decimal},
                                  StraightFamily{"one-ulp", &one_ulp},
                                  StraightFamily{"scaled", &scaled},
                                  StraightFamily{"offset", &offset},
                                  StraightFamily{"near-parallel", &near_parallel},
                                  StraightFamily{"mixed-magnitude", &mixed_magnitude},
                                  StraightFamily{"sliver", &sliver},
                                  StraightFamily{"uneven", &uneven},
                                  StraightFamily{"touching", &touching}};

}  // namespace

std::span<const StraightFamily> straight_families() { return kFamilies; }

StraightPair make_pair(const StraightFamily& family, std::uint64_t seed, std::uint64_t item) {
  constexpr std::uint64_t kFirst = 2000;  // beyond the families of rays and of turning pairs
  Draw draw(seed, kFirst + static_cast<std::uint64_t>(&family - kFamilies.data()), item);
  // Rounding may have bent a ring: the next one drawn, in the end one of whole numbers.
  constexpr int kTries = 8;
  for (int i = 0; i < kTries; ++i) {
    StraightPair pair = family.make(draw);
    if (!non_convex_vertex(pair.ring_a) && !non_convex_vertex(pair.ring_b)) return pair;
  }
  return grid(draw);
}

}  // namespace flatray::oracle
