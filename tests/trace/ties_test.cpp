// Walls and rays on whole numbers, where rays meet ends, several walls at once, or run along them: the
// exact code's hits on every tier.
#include <gtest/gtest.h>

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

// One ray in three has other numbers.
TEST(Ties, AreMetExactlyAmongOtherRays) {
  for (const bool other_first : {false, true}) {
    Case c = crowd(8, 1, {0, 0}, 7), mixed{c.walls, {}};
    Draws draw(8);
    if (other_first)
      for (int i = 0; i < 8; ++i) mixed.rays.add({8 * draw.point(), draw.point()});
    for (std::size_t i = 0; i < c.rays.size(); ++i) {
      mixed.rays.add(c.rays.ray(i), c.rays.left[i]);
      if (i % 2 == 0) mixed.rays.add({8 * draw.point(), draw.point() - Vec2(0.5, 0.5)});
      if (i % 8 == 0) mixed.rays.add({c.rays.ray(i).origin, {0, 0}});
    }
    expect_all_tiers_exact(mixed);
  }
}

}  // namespace
}  // namespace flatray
