// Walls and rays on whole numbers: which are, and the exact code's hits for them on every tier.
#include "trace/whole_nearest.h"

#include <gtest/gtest.h>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

bool hold(const Segment& wall, const Ray& ray) {
  Surfaces walls;
  walls.add(wall);
  return WholeWalls(walls).hold(ray);
}

TEST(WholeWalls, FitBoxesOfSidesBelowTwoToThe25) {
  const Ray ray{{0, 0}, {1, 0}};
  EXPECT_TRUE(hold({{0, 0}, {0x1p25 - 1, 1}}, ray));
  EXPECT_FALSE(hold({{0, 0}, {0x1p25, 1}}, ray));
  EXPECT_TRUE(hold({{0, -1}, {1, 0x1p25 - 2}}, ray));
  EXPECT_FALSE(hold({{0, -1}, {1, 0x1p25 - 1}}, ray));
  EXPECT_FALSE(hold({{0, 0}, {0.1, 1}}, ray));
}

// Of a wall of side 2^24 the unit of origins is 1: they lie up to 2^24 beside it.
TEST(WholeWalls, HoldOriginsThatFitTheBox) {
  const Segment wall{{0, 0}, {0x1p24, 1}};
  EXPECT_TRUE(hold(wall, {{-0x1p24, 0}, {1, 0}}));
  EXPECT_FALSE(hold(wall, {{-0x1p24 - 1, 0}, {1, 0}}));
  EXPECT_TRUE(hold(wall, {{0, 0x1p24}, {1, 0}}));
  EXPECT_FALSE(hold(wall, {{0, 0x1p24 + 1}, {1, 0}}));
  EXPECT_FALSE(hold(wall, {{0.5, 0}, {1, 0}}));
}

// Of a wall of side 1 it is 2^-12, however few digits the wall has, and they lie up to 2^12 beside it.
TEST(WholeWalls, HoldOriginsOfMoreDigitsThanWalls) {
  const Segment wall{{0, 0}, {1, 1}};
  EXPECT_TRUE(hold(wall, {{0x1p-12, 0}, {1, 0}}));
  EXPECT_FALSE(hold(wall, {{0x1p-13, 0}, {1, 0}}));
  EXPECT_TRUE(hold(wall, {{0x1p12, 0}, {1, 0}}));
  EXPECT_FALSE(hold(wall, {{0x1p12 + 2, 0}, {1, 0}}));
  EXPECT_FALSE(hold(wall, {{1.0 / 3, 0}, {1, 0}}));
  // Its distance from the corner (-1, -1) rounds to a whole number.
  EXPECT_FALSE(hold({{-1, -1}, {1, 1}}, {{0x1p-80, 0}, {1, 0}}));
}

TEST(WholeWalls, HoldDirectionsOfAUnitOfTheirOwn) {
  const Segment wall{{0, 0}, {1, 1}};
  const auto held = [&](const Vec2& direction) { return hold(wall, {{0, 0}, direction}); };
  for (const double unit : {1.0, 0x1p-150, 0x1p140}) {
    EXPECT_TRUE(held(unit * Vec2(1 - 0x1p24, 1)));
    EXPECT_TRUE(held(unit * Vec2(1, 0x1p24 - 1)));
    EXPECT_FALSE(held(unit * Vec2(1, 0x1p26 + 1)));
    EXPECT_FALSE(held(unit * Vec2(-0x1p26, 1)));
    EXPECT_FALSE(held(unit * Vec2(0.1, 1)));
  }
  EXPECT_TRUE(held({0, -0x1p169}));
  EXPECT_FALSE(held({0, 0x1p170}));
  EXPECT_FALSE(held({0x1p-170, 0}));
  EXPECT_FALSE(held({0, 0}));
}

TEST(WholeWalls, AreAsWholeFarFromTheOrigin) {
  EXPECT_TRUE(
      hold({{0x1p52, -0x1p52}, {0x1p52 + 3, -0x1p52 + 1}}, {{0x1p52 + 7, -0x1p52}, {1, 2}}));
  EXPECT_FALSE(hold({{0x1p52, -0x1p52}, {0x1p52 + 3, -0x1p52 + 1}}, {{0, 0}, {1, 2}}));
}

TEST(WholeWalls, AreStraightAndOfUsualSize) {
  Surfaces walls;
  EXPECT_FALSE(WholeWalls(walls).any());
  walls.add(Segment{{0, 0}, {0, 0}});
  EXPECT_FALSE(WholeWalls(walls).any());
  walls.add(Segment{{0.25, 3}, {1, 7}});
  EXPECT_TRUE(WholeWalls(walls).any());
  EXPECT_EQ(WholeWalls(walls).unit(), 0.25);
  walls.add(Circle{{0, 0}, 1});
  EXPECT_FALSE(WholeWalls(walls).any());
  EXPECT_FALSE(hold({{0x1p-200, 0}, {0, 0x1p-197}}, {{0, 0}, {1, 1}}));
  EXPECT_FALSE(hold({{0x1p226, 0}, {0, 0x1p227}}, {{0, 0}, {1, 1}}));
}

// Lines through x = X + m / (2m + 1) and X + (m - 1) / (2m - 1): the second is nearer by 1 over the
// product, 2^-48 at X = 2^24, where doubles are 2^-28 apart.
TEST(WholeNearest, TellsApartWhatRoundsToOneDouble) {
  constexpr double kX = 0x1p24, kM = 0x1p23;
  const Segment far{{kX, -kM}, {kX + 1, kM + 1}}, near{{kX, 1 - kM}, {kX + 1, kM}};
  for (const bool near_first : {false, true}) {
    Case c;
    c.walls.add(near_first ? near : far);
    c.walls.add(near_first ? far : near);
    c.rays.add({{0, 0}, {1, 0}});
    ASSERT_TRUE(WholeWalls(c.walls).hold(c.rays.ray(0)));
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

TEST(WholeNearest, GivesTheExactHitsOfAllThatTies) {
  std::uint64_t seed = 1;
  for (const int span : {3, 8, 1000, (1 << 24) - 1})
    for (const double unit : {1.0, 0x1p-160, 0x1p140})
      for (const Vec2& corner : {Vec2(0, 0), Vec2(-unit, unit * 0x1p40)}) {
        const Case c = crowd(span, unit, corner, seed++);
        const WholeWalls whole(c.walls);
        for (std::size_t i = 0; i < c.rays.size(); ++i) ASSERT_TRUE(whole.hold(c.rays.ray(i)));
        expect_all_tiers_exact(c);
      }
}

// With cells, rays that the lanes leave; of one list no ray leaves them.
TEST(WholeNearest, TakesEveryRayThatWouldLeaveTheLanes) {
  const Case c = crowd(8, 1, {0, 0}, 99);
  const RayBatch many = many_of(c.rays);
  for (const Isa isa : available_isas()) {
    const LeftByLanes grid = find_tracer("grid")->build(c.walls, isa)->left_by_lanes(many);
    EXPECT_GT(grid.rays, 0U);
    EXPECT_EQ(grid.whole, grid.rays);
    EXPECT_EQ(find_tracer("brute")->build(c.walls, isa)->left_by_lanes(many).rays, 0U);
  }
}

// One ray in three is not whole; where most of the first eight are not, no other is asked.
TEST(WholeNearest, LeavesTheOthersToTheLanes) {
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
