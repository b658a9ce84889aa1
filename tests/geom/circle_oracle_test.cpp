#include <fmt/core.h>
#include <gtest/gtest.h>

#include "geom/clip.h"
#include "geom/clip_cases.h"
#include "oracle/contact.h"
#include "oracle/curves.h"

namespace flatray {
namespace {

constexpr int kCasesAFamily = 250;

struct DiscCase {
  Ray ray;
  Circle circle;
};

DiscCase grid_disc(Draw& draw) {
  return {{{draw.below(12) - 6, draw.below(12) - 6}, {draw.below(9) - 4, draw.below(9) - 4}},
          {{draw.below(4), draw.below(4)}, draw.below(6)}};
}

// 3-4-5 lines are tangent to circles of integers.
DiscCase tangent_disc(Draw& draw) {
  const double k = 1 + draw.below(6), s = draw.sign();
  const Vec2 centre(draw.below(9), draw.below(9)), along(4 * s, -3);
  const Vec2 foot = centre + k * Vec2(3, 4 * s);
  return {{foot - draw.below(5) * along, along}, {centre, 5 * k}};
}

DiscCase scaled(DiscCase c, double factor) {
  return {{c.ray.origin * factor, c.ray.direction * factor},
          {c.circle.centre * factor, c.circle.radius * factor}};
}

using Family = DiscCase (*)(Draw&);
const Family kFamilies[] = {
    &grid_disc,
    &tangent_disc,
    [](Draw& draw) {  // an ulp off tangent
      DiscCase c = tangent_disc(draw);
      c.circle.radius = nudge(c.circle.radius, draw);
      c.ray.origin = nudge(c.ray.origin, draw);
      return c;
    },
    [](Draw& draw) { return scaled(grid_disc(draw), 0.1); },
    [](Draw& draw) { return scaled(tangent_disc(draw), 5e-324); },
    [](Draw& draw) { return scaled(tangent_disc(draw), 0x1p1016); },
    [](Draw& draw) {
      return scaled(grid_disc(draw), std::ldexp(1.0, static_cast<int>(draw.below(1800)) - 900));
    },
    [](Draw& draw) {  // from far away
      DiscCase c = grid_disc(draw);
      c.ray.origin -= 1e8 * c.ray.direction;
      return c;
    },
    [](Draw& draw) {
      return DiscCase{{{draw.unit(), draw.unit()}, {draw.unit() - 0.5, draw.unit() - 0.5}},
                      {{draw.unit(), draw.unit()}, draw.unit()}};
    },
};

// t is the nearest double when the root lies between the middles to its neighbours.
void expect_nearest(const oracle::Surd& root, double t) {
  const Rational above = (Rational(t) + std::nextafter(t, kInfinity)) / 2;
  const Rational below = (Rational(t) + std::nextafter(t, -kInfinity)) / 2;
  EXPECT_TRUE(root <= oracle::Surd{above});
  EXPECT_TRUE(root >= oracle::Surd{below});
}

void check(const DiscCase& c, int (&kinds)[4]) {
  const HitInterval hit = clip_circle(c.ray, c.circle, kLine);
  const Sign apart = oracle::apart_at({{&c.ray.origin, 1}, {0, 0}},
                                      {{&c.circle.centre, 1}, {0, 0}, c.circle.radius}, 0);
  const StartPlace place = apart == Sign::positive ? StartPlace::outside
                           : apart == Sign::zero   ? StartPlace::boundary
                                                   : StartPlace::inside;
  EXPECT_STREQ(name(hit.start), name(place));
  if (c.ray.direction == Vec2(0, 0)) {
    EXPECT_EQ(hit.kind == HitClass::miss, place == StartPlace::outside);
    return;
  }
  const auto first = oracle::root_of(c.ray, c.circle, Root::first);
  const auto second = oracle::root_of(c.ray, c.circle, Root::second);
  EXPECT_STREQ(name(hit.kind), name(!first          ? HitClass::miss
                                    : first->s == 0 ? HitClass::touch
                                                    : HitClass::through));
  ++kinds[static_cast<int>(hit.kind)];
  if (!hit || !first) return;
  expect_nearest(*first, hit.t_enter);
  expect_nearest(*second, hit.t_exit);
  // A ray keeps what lies ahead of its origin.
  const HitInterval ahead = clip_circle(c.ray, c.circle, kRay);
  EXPECT_EQ(ahead.kind == HitClass::miss, second->sign() == Sign::negative);
  if (ahead) {
    EXPECT_EQ(ahead.t_enter, std::max(0.0, hit.t_enter));
    EXPECT_EQ(ahead.t_exit, hit.t_exit);
  }
}

TEST(ClipCircle, AgreesWithTheOracleOnAdversarialFamilies) {
  int family = 100, kinds[4] = {0, 0, 0, 0};
  for (const Family make : kFamilies) {
    for (int item = 0; item < kCasesAFamily; ++item) {
      Draw draw = draw_of(family, item);
      check(make(draw), kinds);
      ASSERT_FALSE(testing::Test::HasFailure())
          << "family " << family << ", case " << item << " of seed " << kSeed;
    }
    ++family;
  }
  fmt::print("seed {}: {} miss, {} touch, {} through\n", kSeed, kinds[0], kinds[1], kinds[3]);
  EXPECT_GT(std::min({kinds[0], kinds[1], kinds[3]}), 300);
}

}  // namespace
}  // namespace flatray
