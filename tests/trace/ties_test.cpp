// Walls and rays on whole numbers, where rays meet ends, several walls at once, or run along them: the
// exact code's hits on every tier.
#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/decide.h"
#include "trace/all_tracers.h"

namespace flatray {
namespace {

// Lines through x = X + m / (2m + 1) and X + (m - 1) / (2m - 1): the second is nearer by 1 over the
// product, 2^-48 at X = 2^24, where doubles are 2^-28 apart.
TEST(Ties, AreToldFromWhatRoundsToOneDouble) {
  constexpr double kX = 0x1p24, kM = 0x1p23;
  const Segment far{{kX, -kM}, {kX + 1, kM + 1}}, near{{kX, 1 - kM}, {kX + 1, kM}};
  for (const bool near_first : {false, true}) {
    Case c;
    c.walls.add(near_first ? near : far);
    c.walls.add(near_first ? far : near);
    c.rays.add({{0, 0}, {1, 0}});
    EXPECT_EQ(exact_hit_of(c, 0).surface, near_first ? 0U : 1U);
    expect_all_tiers_exact(c);
  }
}

// Rings of walls, points among them and copies, and rays at ends, along walls, from walls.
Case crowd(int span, double unit, const Vec2& corner, std::uint64_t seed) {
  Draws draw(seed);
  Case c;
  const auto point = [&] { return Vec2(corner + unit * draw.grid_point(0, span)); };
  for (int i = 0; i < 8; ++i) {
    const Vec2 a = point(), b = point(), d = point();
    for (const Segment& wall : {Segment{a, b}, Segment{b, d}, Segment{d, a}}) c.walls.add(wall);
  }
  c.walls.add(c.walls.segments[3]);
  c.walls.add(Segment{c.walls.segments[5].a, c.walls.segments[5].a});
  const auto count = static_cast<std::uint32_t>(c.walls.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const Segment& wall = c.walls.segments[i];
    const Vec2 from = point();
    if (from != wall.b) c.rays.add({from, wall.b - from});
    c.rays.add({from, Vec2(draw.grid_point(-8, 7)) + Vec2(0.5, 0.5)});
    c.rays.add({from, 0x1p-24 * draw.grid_point(1 - (1 << 24), (1 << 24) - 1)});
    if (wall.a == wall.b) continue;
    c.rays.add({wall.b, wall.a - wall.b});
    c.rays.add({wall.a, wall.a - wall.b});
    if (from != wall.a) c.rays.add({wall.a, from - wall.a}, {i, Root::none});
  }
  return c;
}

TEST(Ties, AreMetExactly) {
  std::uint64_t seed = 1;
  for (const int span : {3, 8, 1000, (1 << 24) - 1})
    for (const double unit : {1.0, 0x1p-160, 0x1p140})
      for (const Vec2& corner : {Vec2(0, 0), Vec2(-unit, unit * 0x1p40)})
        expect_all_tiers_exact(crowd(span, unit, corner, seed++));
}

// Rays from as far left or right of (0, y) that t is nearly half way between two doubles: by some
// 2^-105 of it, less than double-doubles are off by.
RayBatch rays_to_halves(const Segment& wall, int count, Draws& draw) {
  RayBatch rays;
  const Rational ax = wall.a.x(), ay = wall.a.y(), ex = ax - wall.b.x(), ey = ay - wall.b.y();
  for (int i = 0; i < count; ++i) {
    const Vec2 from(0, draw.point().y());
    const Vec2 way = (0.1 + 0.8 * draw.unit()) * (wall.a + draw.unit() * (wall.b - wall.a) - from);
    const Rational size = way.x() * ey - way.y() * ex, wy = ay - from.y();
    const double t = ((ax * ey - wy * ex) / size).nearest();
    const Rational half = (Rational(t) + std::nextafter(t, 9.0)) / 2;
    double x = (ax - (half * size + wy * ex) / ey).nearest();
    for (int steps = i % 16; steps > 0; --steps) x = std::nextafter(x, i % 2 == 0 ? 1.0 : -1.0);
    rays.add({{x, from.y()}, way});
  }
  return rays;
}

TEST(Ties, TimesHalfWayBetweenDoublesAreRoundedOnce) {
  Draws draw(11);
  const Segment wall{{1.25 + 0x1p-52, 1}, {1.5, 1.7 + 0x1p-51}};
  const int count = static_cast<int>(times(20000));
  Case c{{}, rays_to_halves(wall, count, draw)};
  c.walls.add(wall);
  const auto exact = [](double x) { return Rational(x); };
  int below = 0;
  for (std::size_t i = 0; i < c.rays.size(); ++i) {
    const Ray ray = c.rays.ray(i);
    const Rational t = determinant(exact, ray.origin, wall.a, wall.a, wall.b) /
                       determinant(exact, {0, 0}, ray.direction, wall.a, wall.b);
    ASSERT_EQ(exact_hit_of(c, i).t, t.nearest()) << i;
    below += t > t.nearest() ? 1 : 0;
  }
  EXPECT_GT(below, count / 4);
  EXPECT_LT(below, 3 * count / 4);
  expect_all_tiers_exact(c);
}

// One ray in three has other numbers.
TEST(Ties, AreMetExactlyAmongOtherRays) {
  for (const bool other_first : {false, true}) {
    Case c = crowd(8, 1, {0, 0}, 7), mixed{c.walls, {}};
    Draws draw(8);
    if (other_first)
      for (int i = 0; i < 8; ++i) mixed.rays.add({8 * draw.point(), draw.point()});
    for (std::size_t i = 0; i < c.rays.size(); ++i) {
      mixed.rays.add(c.rays.ray(i), c.rays.departed[i]);
      if (i % 2 == 0) mixed.rays.add({8 * draw.point(), draw.point() - Vec2(0.5, 0.5)});
      if (i % 8 == 0) mixed.rays.add({c.rays.ray(i).origin, {0, 0}});
    }
    expect_all_tiers_exact(mixed);
  }
}

}  // namespace
}  // namespace flatray
