#include "transport/orbit.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "full_counts.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

Surfaces unit_square() { return ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

TEST(StiffCases, C1Diamond) {
  const std::uint64_t hits = times(10'000'000, 1'000'000);
  const std::array<Vec2, 4> points = {Vec2{1, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0}};
  const std::array<std::uint32_t, 4> walls = {1, 2, 3, 0};
  std::uint64_t hit = 0;
  watch(unit_square(), {{0.75, 0.25}, {1, 1}}, hits, [&](const Bounce& bounce) {
    ASSERT_EQ(bounce.point, points[hit % 4]) << hit;
    ASSERT_EQ(bounce.surface, walls[hit % 4]) << hit;
    ++hit;
  });
  EXPECT_EQ(hit, hits);
}

// Unfolding: hit N of (1/8, 3/8) + t (99, 70) on the square's grid of mirrors.
TEST(StiffCases, C2Unfolding) {
  const std::uint64_t hits = times(1'000'000'000, 1'000'000);
  std::uint64_t hit = 0;
  watch(unit_square(), {{1.0 / 8, 3.0 / 8}, {99, 70}}, hits, [&](const Bounce& bounce) {
    ++hit;
    const auto expect = [&](std::uint64_t number, std::uint32_t wall, double x, double y) {
      if (hit != number) return;
      const double tolerance = 1e-10 * static_cast<double>(hit) / 1e6 + 0x1p-52;
      EXPECT_EQ(bounce.surface, wall) << hit;
      EXPECT_NEAR(bounce.point.x(), x, tolerance) << hit;
      EXPECT_NEAR(bounce.point.y(), y, tolerance) << hit;
    };
    expect(1, 1, 1, 787.0 / 792);
    expect(2, 2, 111.0 / 112, 1);
    expect(3, 3, 0, 79.0 / 264);
    expect(1'000, 3, 0, 499.0 / 792);
    expect(1'000'000, 1, 1, 317.0 / 792);
    expect(1'000'000'000, 0, 541.0 / 560, 0);
  });
  EXPECT_EQ(hit, hits);
}

TEST(StiffCases, C7CornerExact) {
  const Orbit orbit = in_mirrors(unit_square(), {{0.25, 0.5}, {0.75, 0.5}}, 10);
  EXPECT_EQ(orbit.end, OrbitEnd::corner);
  EXPECT_TRUE(orbit.bounces.empty());
  EXPECT_EQ(orbit.end_point, Vec2(1, 1));
  EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{1, 2}));
}

TEST(StiffCases, C8CornerOneUlpOff) {
  for (const double side : {-1.0, 1.0}) {
    const Vec2 direction(0.75, 0.5 + side * 0x1p-53);
    const Orbit orbit = in_mirrors(unit_square(), {{0.25, 0.5}, direction}, 2);
    ASSERT_EQ(orbit.bounces.size(), 2U);
    EXPECT_EQ(orbit.bounces[0].surface, side < 0 ? 1U : 2U);
    EXPECT_EQ(orbit.bounces[1].surface, side < 0 ? 2U : 1U);
    EXPECT_LE((orbit.bounces[1].point - orbit.bounces[0].point).norm(), 0x1p-51);
    const Vec2 back = -direction.normalized();
    EXPECT_NEAR(orbit.out.x(), back.x(), 0x1p-52);
    EXPECT_NEAR(orbit.out.y(), back.y(), 0x1p-52);
  }
}

TEST(StiffCases, C9ThreeMirrors) {
  Surfaces walls;
  for (const Vec2& end : {Vec2{-1, 2}, Vec2{-1, -2}, Vec2{2, 0}}) walls.add(Segment{{0, 0}, end});
  const Orbit centre = in_mirrors(walls, {{-4, 0}, {1, 0}}, 10);
  EXPECT_EQ(centre.end, OrbitEnd::corner);
  EXPECT_EQ(centre.end_surfaces, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(centre.bounces.empty());
  for (const double side : {1.0, -1.0}) {
    const Orbit orbit = in_mirrors(walls, {{-4, side * 0x1p-60}, {1, 0}}, 10);
    EXPECT_EQ(orbit.end, OrbitEnd::escape);
    ASSERT_EQ(orbit.bounces.size(), 1U);
    EXPECT_EQ(orbit.bounces[0].surface, side > 0 ? 0U : 1U);
    EXPECT_NEAR(orbit.out.x(), -0.6, 0x1p-52);
    EXPECT_NEAR(orbit.out.y(), -side * 0.8, 0x1p-52);
  }
}

TEST(StiffCases, C31ParallelMirrors) {
  Surfaces walls;
  walls.add(Segment{{0, 0}, {1, 0}});
  walls.add(Segment{{0, 1}, {1, 1}});
  const std::uint64_t hits = times(10'000'000, 1'000'000);
  std::uint64_t hit = 0;
  double travelled = 0;
  watch(walls, {{0.3, 0.5}, {0, 1}}, hits, [&](const Bounce& bounce) {
    ASSERT_EQ(bounce.point.x(), 0.3);
    travelled = bounce.path_length;
    ++hit;
  });
  EXPECT_EQ(hit, hits);
  EXPECT_EQ(travelled, static_cast<double>(hits) - 0.5);
}

// A closed diamond: half a side of it, then eleven sides of 10 sqrt(2).
TEST(Orbit, OfTheHallEndsWhereTheDiamondSays) {
  const Surfaces hall = ring({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  const Orbit orbit = in_mirrors(hall, {{15, 5}, {1, 1}}, 12);
  ASSERT_EQ(orbit.bounces.size(), 12U);
  const Bounce& last = orbit.bounces.back();
  EXPECT_EQ(last.point, Vec2(10, 0));
  EXPECT_EQ(last.path_length, 115 * std::numbers::sqrt2);
  EXPECT_EQ(last.t, 10);
  EXPECT_EQ(last.normal, Vec2(0, 1));
  EXPECT_NEAR(last.incidence(), std::numbers::pi / 4, 0x1p-53);
  EXPECT_EQ(orbit.end, OrbitEnd::limit);
}

TEST(Orbit, AbsorbedWhereTheWallAbsorbs) {
  const Surfaces walls = unit_square();
  std::vector<Material> materials = all_mirrors(walls);
  materials[2] = Material::absorb;
  const Orbit orbit = trace_orbit(walls, materials, {{0.75, 0.25}, {1, 1}}, 10);
  EXPECT_EQ(orbit.end, OrbitEnd::absorbed);
  EXPECT_EQ(orbit.bounces.size(), 1U);
  EXPECT_EQ(orbit.end_point, Vec2(0.5, 1));
  EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{2}));
}

TEST(Orbit, ACornerAbsorbsOnlyIfAllItsWallsDo) {
  const Surfaces walls = unit_square();
  std::vector<Material> materials = all_mirrors(walls);
  materials[1] = Material::absorb;
  const Ray ray{{0.25, 0.25}, {1, 1}};
  EXPECT_EQ(trace_orbit(walls, materials, ray, 10).end, OrbitEnd::corner);
  materials[2] = Material::absorb;
  EXPECT_EQ(trace_orbit(walls, materials, ray, 10).end, OrbitEnd::absorbed);
}

TEST(Orbit, EscapesWhereNothingLiesAhead) {
  const Orbit orbit = in_mirrors(unit_square(), {{2, 0.5}, {3, 4}}, 10);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  EXPECT_TRUE(orbit.bounces.empty());
  EXPECT_NEAR(orbit.out.x(), 0.6, 0x1p-53);
  EXPECT_NEAR(orbit.out.y(), 0.8, 0x1p-53);
}

TEST(Orbit, StartingOnAWallHasJustLeftIt) {
  const Orbit inward = in_mirrors(unit_square(), {{0.5, 0}, {0, 1}}, 3);
  ASSERT_EQ(inward.bounces.size(), 3U);
  EXPECT_EQ(inward.bounces[0].surface, 2U);
  EXPECT_EQ(inward.bounces[1].surface, 0U);
  EXPECT_EQ(in_mirrors(unit_square(), {{0.5, 0}, {0, -1}}, 3).end, OrbitEnd::escape);
}

TEST(Orbit, StartingAlongAWallOrInACornerMakesNoBounce) {
  const Orbit along = in_mirrors(unit_square(), {{0.5, 0}, {1, 0}}, 3);
  EXPECT_EQ(along.end, OrbitEnd::along);
  EXPECT_EQ(along.end_surfaces, (std::vector<std::uint32_t>{0}));
  const Orbit corner = in_mirrors(unit_square(), {{1, 0}, {-1, 1}}, 3);
  EXPECT_EQ(corner.end, OrbitEnd::corner);
  EXPECT_EQ(corner.end_point, Vec2(1, 0));
  EXPECT_EQ(corner.end_surfaces, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(along.bounces.empty() && corner.bounces.empty());
}

TEST(Orbit, StartingOnACircleGoesEitherWay) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const Orbit inward = in_mirrors(walls, {{-1, 0}, {1, 0}}, 2);
  ASSERT_EQ(inward.bounces.size(), 2U);
  EXPECT_EQ(inward.bounces[0].point, Vec2(1, 0));
  EXPECT_EQ(inward.bounces[0].t, 2);
  EXPECT_EQ(inward.bounces[1].point, Vec2(-1, 0));
  EXPECT_EQ(in_mirrors(walls, {{-1, 0}, {-1, 0}}, 2).end, OrbitEnd::escape);
}

// A start on a tangent has touched the circle, as a ray that comes along it has, and goes on.
TEST(Orbit, StartingOnTheTangentOfACircleGoesOn) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  EXPECT_EQ(in_mirrors(walls, {{-1, 0}, {0, 1}}, 2).end, OrbitEnd::escape);
  walls.add(Segment{{-2, 3}, {2, 3}});
  walls.add(Arc{Ellipse{{0, -2}, {2, 0}, {0, 0.5}}, Arc::Extent::whole, {0, 0}, {0, 0}});
  const Orbit on = in_mirrors(walls, {{-1, 0}, {0, 1}}, 3);
  const Orbit before = in_mirrors(walls, {{-1, -1}, {0, 1}}, 3);  // passes the circle by
  ASSERT_GE(on.bounces.size(), 2U);
  ASSERT_EQ(on.bounces.size(), before.bounces.size());
  for (std::size_t i = 0; i < on.bounces.size(); ++i) {
    EXPECT_EQ(on.bounces[i].surface, before.bounces[i].surface);
    EXPECT_EQ(on.bounces[i].point, before.bounces[i].point);
    EXPECT_EQ(on.bounces[i].out, before.bounces[i].out);
  }
  EXPECT_EQ(on.end, before.end);
}

TEST(Orbit, PassesATangentCircle) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 5});
  const Orbit orbit = in_mirrors(walls, {{-5, 10}, {4, -3}}, 3);  // touches at (3, 4)
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  EXPECT_TRUE(orbit.bounces.empty());
}

TEST(Orbit, TwoWallsAtOnceAreACorner) {
  Surfaces crossing;
  crossing.add(Segment{{-1, -1}, {1, 1}});
  crossing.add(Segment{{-1, 1}, {1, -1}});
  const Orbit orbit = in_mirrors(crossing, {{-2, 0}, {1, 0}}, 3);
  EXPECT_EQ(orbit.end, OrbitEnd::corner);
  EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{0, 1}));
}

// The near face of a wall 2^-40 thick turns the ray back, from either side.
TEST(StiffCases, C28ThinWall) {
  Surfaces walls;
  walls.add(Segment{{1, -1}, {1, 1}});
  walls.add(Segment{{1 + 0x1p-40, -1}, {1 + 0x1p-40, 1}});
  for (const double from : {0.0, 2.0}) {
    const Orbit orbit = in_mirrors(walls, {{from, 0}, {1 - from, 0.25}}, 3);
    EXPECT_EQ(orbit.end, OrbitEnd::escape);
    ASSERT_EQ(orbit.bounces.size(), 1U);
    EXPECT_EQ(orbit.bounces[0].surface, from == 0 ? 0U : 1U);
  }
}

TEST(Orbit, IsReflectedByWallsLongerThanTheDoubles) {
  Surfaces walls;
  walls.add(Segment{{1, 1e308}, {0, -1e308}});
  const Orbit orbit = in_mirrors(walls, {{-1, -9e307}, {2, 1}}, 3);
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_EQ(orbit.bounces[0].normal, Vec2(-1, 5e-309));
  EXPECT_EQ(orbit.bounces[0].out, Vec2(-2, 1));
}

// The point met is within half an ulp of the largest double, or beyond it: that has no neighbour outward.
TEST(Orbit, StaysAmongTheDoublesAtTheLargest) {
  constexpr double kMax = std::numeric_limits<double>::max();
  Surfaces disc, wall;
  disc.add(Circle{{0, 0}, kMax});
  wall.add(Segment{{1, kMax}, {0, -kMax}});
  const Orbit in_disc = in_mirrors(disc, {{0, 1}, {1, 0}}, 3);
  const Orbit at_wall = in_mirrors(wall, {{-1, -kMax}, {2, 1}}, 3);
  EXPECT_EQ(in_disc.bounces.size(), 3U);
  for (const Orbit& orbit : {in_disc, at_wall})
    for (const Bounce& bounce : orbit.bounces) EXPECT_TRUE(bounce.point.allFinite());
}

TEST(Orbit, WithoutBouncesOnlyLooksAtTheStart) {
  const Orbit orbit = in_mirrors(unit_square(), {{0.5, 0.5}, {1, 0}}, 0);
  EXPECT_EQ(orbit.end, OrbitEnd::limit);
  EXPECT_TRUE(orbit.bounces.empty());
}

}  // namespace
}  // namespace flatray
