// Stiff cases of walls that meet: wedges, corners, corridors. Counts by unfolding.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/philox.h"
#include "full_counts.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

// Walls y = 0 and through (0, 0) and (run, 1), long enough for any ray within 1 of the tip.
Surfaces wedge(double run) {
  Surfaces walls;
  walls.add(Segment{{0, 0}, {1000 * run, 0}});
  walls.add(Segment{{0, 0}, {1000 * run, 1000}});
  return walls;
}

std::uint64_t reflections(const Surfaces& walls, const Ray& ray) {
  std::uint64_t count = 0;
  const OrbitStop stop = watch(walls, ray, 1'000'000'000, [&](const Bounce&) { ++count; });
  EXPECT_EQ(stop.end, OrbitEnd::escape);
  return count;
}

TEST(StiffCases, C3WedgeParallelEntry) {
  std::uint64_t expected[] = {31, 314, 3141, 31415, 314159};
  double run = 1;
  for (const std::uint64_t digits : expected) {
    run *= 10;
    EXPECT_EQ(reflections(wedge(run), {{100 * run, 1}, {-1, 0}}), digits);
  }
}

TEST(StiffCases, C3WedgeParallelEntryOfThreeMillion) {
  EXPECT_EQ(reflections(wedge(1e6), {{1e8, 1}, {-1, 0}}), 3'141'592U);
}

// Whole turns of a wedge of 1e-7 and 1e-8: every one of them adds the rounding of two reflections.
TEST(StiffCases, C3WedgeParallelEntryOfThreeHundredMillion) {
  if (!at_full_counts()) GTEST_SKIP() << "FLATRAY_FULL_COUNTS is not set";
  EXPECT_EQ(reflections(wedge(1e7), {{1e9, 1}, {-1, 0}}), 31'415'926U);
  EXPECT_EQ(reflections(wedge(1e8), {{1e10, 1}, {-1, 0}}), 314'159'265U);
}

TEST(StiffCases, C4WedgeAnyEntry) {
  for (const double run : {4.0, 37.0, 250.0}) {
    const double alpha = std::atan(1 / run);
    for (std::uint32_t i = 0; i < 20; ++i) {
      const double theta = alpha * unit_double(random_bits(4, Stream::test, 0, i));
      const double turns = (kHalfTurn + theta) / alpha;
      if (std::fabs(turns - std::round(turns)) < 1e-9 * turns) continue;
      // Far out at the polar angle theta, beside the tip.
      const Vec2 out(std::cos(theta), std::sin(theta));
      const Vec2 from = 100 * run * out + 1e-3 * Vec2(-out.y(), out.x());
      EXPECT_EQ(reflections(wedge(run), {from, -out}),
                static_cast<std::uint64_t>(std::ceil(turns)) - 1)
          << run << " " << theta;
    }
  }
}

// A ray at height 1 is at the distance 1 / sin(k alpha) from the tip when it is reflected the k-th
// time.
TEST(StiffCases, C5WedgeOfANanoradian) {
  std::uint64_t k = 0;
  double nearest = kInfinity;
  const OrbitStop stop =
      watch(wedge(1e9), {{1e11, 1}, {-1, 0}}, 100'000, [&](const Bounce& bounce) {
        ++k;
        const double distance = bounce.point.norm(), angle = static_cast<double>(k) * 1e-9;
        ASSERT_LT(distance, nearest);
        nearest = distance;
        ASSERT_NEAR(std::asin(1 / distance), angle, static_cast<double>(k) * 0x1p-52) << k;
      });
  EXPECT_EQ(stop.end, OrbitEnd::limit);
  EXPECT_EQ(k, 100'000U);
}

bool inside_ring(const std::vector<Vec2>& convex, const Vec2& point) {
  for (std::size_t i = 0; i < convex.size(); ++i)
    if (orientation(convex[i], convex[(i + 1) % convex.size()], point) == Sign::negative)
      return false;
  return true;
}

TEST(StiffCases, C6ClosedAcuteCorner) {
  const std::vector<Vec2> triangle = {{0, 0}, {6, 0}, {6, 1}};
  for (const double beside : {0x1p-54, -0x1p-53}) {  // the next double to either side
    const Vec2 aim(-5, -0.5 + beside);
    const Orbit orbit = in_mirrors(ring(triangle), {{5, 0.5}, aim}, 25);
    int near = 0;
    for (const Bounce& bounce : orbit.bounces) {
      EXPECT_TRUE(inside_ring(triangle, bounce.point));
      near += bounce.point.norm() < 1e-14 ? 1 : 0;
    }
    EXPECT_NEAR(near, kHalfTurn / std::atan(1.0 / 6), 1);
    ASSERT_EQ(orbit.bounces.size(), 25U);
    EXPECT_GT(orbit.bounces.back().point.norm(), 0.5);
  }
}

TEST(StiffCases, C7CornerByTheRuleOfReturning) {
  const Surfaces square = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Orbit orbit =
      trace_orbit(square, all_mirrors(square), {{0.25, 0.5}, {0.75, 0.5}}, 3, {CornerRule::back});
  // Through (1, 1) and back through the start to the left wall.
  ASSERT_EQ(orbit.bounces.size(), 3U);
  EXPECT_EQ(orbit.bounces[0].point, Vec2(1, 1));
  EXPECT_EQ(orbit.bounces[0].out, Vec2(-0.75, -0.5));
  EXPECT_EQ(orbit.bounces[0].incidence(), 0);
  EXPECT_EQ(orbit.bounces[1].surface, 3U);
  EXPECT_NEAR(orbit.bounces[1].point.y(), 1.0 / 3, 0x1p-53);
  EXPECT_NEAR(orbit.bounces[1].t, 4.0 / 3, 0x1p-52);
}

// Off the right wall into the corner (0, 0), and back the way it came.
TEST(CornerRule, BackRetracesTheOrbit) {
  const Surfaces walls = ring({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  const Orbit back =
      trace_orbit(walls, all_mirrors(walls), {{2, 0.75}, {2, -0.25}}, 4, {CornerRule::back});
  ASSERT_EQ(back.bounces.size(), 4U);
  EXPECT_EQ(back.bounces[0].point, Vec2(4, 0.5));
  EXPECT_EQ(back.bounces[1].point, Vec2(0, 0));
  EXPECT_EQ(back.bounces[2].point, Vec2(4, 0.5));
  EXPECT_EQ(back.bounces[2].surface, 1U);
  EXPECT_EQ(back.bounces[2].out, Vec2(-2, 0.25));
  EXPECT_EQ(back.bounces[2].t, back.bounces[1].t);
  EXPECT_EQ(back.bounces[3].point, Vec2(0, 1));
}

// To and fro between a circle and the end of a wall.
TEST(CornerRule, BackRetracesTheOrbitOffACircle) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 5});
  walls.add(Segment{{-20, 0}, {-21, 1}});
  const Orbit orbit =
      trace_orbit(walls, all_mirrors(walls), {{-10, 0}, {1, 0}}, 5, {CornerRule::back});
  ASSERT_EQ(orbit.bounces.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(orbit.bounces[i].point, i % 2 == 0 ? Vec2(-5, 0) : Vec2(-20, 0)) << i;
  EXPECT_EQ(orbit.bounces.back().path_length, 5 + 4 * 15);
}

// Unfolded, the ray is at height 2^-41 (1 + s) after s: it crosses the images of the walls at
// s = 1/2, 3/2, ... and 1, 3, 5, ...
TEST(StiffCases, C27ThinCorridor) {
  const Surfaces corridor = ring({{0, 0}, {1, 0}, {1, 0x1p-40}, {0, 0x1p-40}});
  const Orbit orbit = in_mirrors(corridor, {{0.5, 0x1p-41}, {1, 0x1p-41}}, 60);
  ASSERT_EQ(orbit.bounces.size(), 60U);
  std::size_t hit = 0;
  bool right = true, top = true;
  for (int half = 1; hit < 60; ++half) {
    const bool side = half % 2 == 1, level = half % 4 == 2;
    if (side) {
      EXPECT_EQ(orbit.bounces[hit++].surface, right ? 1U : 3U) << hit;
      right = !right;
    } else if (level) {
      EXPECT_EQ(orbit.bounces[hit++].surface, top ? 2U : 0U) << hit;
      top = !top;
    }
  }
}

TEST(StiffCases, C29StartsBadly) {
  const Surfaces walls = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  // On a wall: it has just been left, to either side.
  EXPECT_EQ(in_mirrors(walls, {{1, 0.5}, {-1, 0.1}}, 2).bounces.size(), 2U);
  EXPECT_EQ(in_mirrors(walls, {{1, 0.5}, {1, 0.1}}, 2).end, OrbitEnd::escape);
  // In a corner.
  EXPECT_EQ(in_mirrors(walls, {{1, 1}, {-1, -0.5}}, 2).end, OrbitEnd::corner);
  // Outside, towards the room: off it from without.
  const Orbit outside = in_mirrors(walls, {{-1, 0.5}, {1, 0.1}}, 2);
  ASSERT_EQ(outside.bounces.size(), 1U);
  EXPECT_EQ(outside.bounces[0].surface, 3U);
  EXPECT_LE(outside.bounces[0].point.x(), 0);
  EXPECT_EQ(outside.end, OrbitEnd::escape);
}

TEST(StiffCases, C30GrazingStart) {
  const Surfaces walls = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const double way : {1.0, -1.0}) {
    const Orbit orbit = in_mirrors(walls, {{1, 0.5}, {0, way}}, 5);
    EXPECT_EQ(orbit.end, OrbitEnd::along);
    EXPECT_TRUE(orbit.bounces.empty());
    EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{1}));
  }
  Surfaces circle;
  circle.add(Circle{{0, 0}, 1});
  EXPECT_EQ(in_mirrors(circle, {{0, 1}, {1, 0}}, 5).end, OrbitEnd::escape);
}

TEST(StiffCases, C32OpenChamber) {
  Surfaces walls;
  walls.add(Segment{{0, 0}, {1, 0}});
  const Orbit orbit = in_mirrors(walls, {{0, 1}, {0.5, -1}}, 5);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_NEAR(orbit.out.x(), std::sqrt(0.2), 0x1p-52);
  EXPECT_NEAR(orbit.out.y(), std::sqrt(0.8), 0x1p-52);
}

}  // namespace
}  // namespace flatray
