#include "transport/periodic_walls.h"

#include <gtest/gtest.h>

#include "transport/chambers.h"

namespace flatray {
namespace {

// A box of periodic walls and discs in it.
struct Torus {
  Surfaces walls = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  std::vector<Material> materials{4, Material::periodic};

  explicit Torus(const std::vector<Circle>& discs) {
    for (const Circle& disc : discs) walls.add(disc);
    materials.resize(walls.size(), Material::mirror);
  }
  Orbit orbit(const Ray& start, std::uint64_t bounces) const {
    return trace_orbit(walls, materials, start, bounces);
  }
};

TEST(PeriodicWalls, AreCrossedToThePlaceOpposite) {
  const Orbit orbit = Torus({{{0.5, 0.5}, 0.125}}).orbit({{0.75, 0.25}, {1, 0.25}}, 1);
  // (1, 5/16), (0, 5/16), and on to the disc.
  ASSERT_EQ(orbit.crossings.size(), 1U);
  EXPECT_EQ(orbit.crossings[0].from, Vec2(1, 0.3125));
  EXPECT_EQ(orbit.crossings[0].to, Vec2(0, 0.3125));
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_EQ(orbit.bounces[0].surface, 4U);
  const double from_wall = (orbit.bounces[0].point - Vec2(0, 0.3125)).x();
  EXPECT_NEAR(orbit.bounces[0].t, 0.25 + from_wall, 1e-15);
}

// The same discs in the plane, without walls: the orbit there, taken back into the box.
TEST(PeriodicWalls, MakeTheOrbitOfThePlaneUnfolded) {
  const Torus torus({{{0.5, 0.5}, 0.25}});
  constexpr int kReach = 40;
  Surfaces plane;
  for (int y = -kReach; y <= kReach; ++y)
    for (int x = -kReach; x <= kReach; ++x) plane.add(Circle{{x + 0.5, y + 0.5}, 0.25});
  for (int i = 0; i < 20; ++i) {
    const Ray start{{0.1, 0.1 + 0.01 * i}, {1, 0.3}};
    const Orbit there = in_mirrors(plane, start, 4), here = torus.orbit(start, 4);
    ASSERT_EQ(there.bounces.size(), here.bounces.size());
    for (std::size_t k = 0; k < here.bounces.size(); ++k) {
      const Vec2 cell = plane.arcs[there.bounces[k].surface].curve.centre - Vec2(0.5, 0.5);
      EXPECT_LT((there.bounces[k].point - cell - here.bounces[k].point).norm(), 1e-9);
      EXPECT_NEAR(there.bounces[k].path_length, here.bounces[k].path_length, 1e-9);
    }
  }
}

TEST(PeriodicWalls, AreCrossedTwoAtATimeInACornerOfTheBox) {
  const Orbit orbit = Torus({{{0.375, 0.375}, 0.125}}).orbit({{0.625, 0.625}, {1, 1}}, 1);
  ASSERT_EQ(orbit.crossings.size(), 1U);
  EXPECT_EQ(orbit.crossings[0].from, Vec2(1, 1));
  EXPECT_EQ(orbit.crossings[0].to, Vec2(0, 0));
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_NEAR(orbit.bounces[0].point.x(), 0.375 - 0.125 * std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(orbit.bounces[0].point.y(), orbit.bounces[0].point.x(), 1e-15);
}

TEST(PeriodicWalls, LetARayThatComesBackGo) {
  const Orbit orbit = Torus({{{0.5, 0.5}, 0.25}}).orbit({{0.125, 0.5}, {0, 1}}, 1);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  ASSERT_EQ(orbit.crossings.size(), 2U);
  EXPECT_EQ(orbit.crossings.back().to, Vec2(0.125, 0));
}

TEST(PeriodicWalls, LetARayThatMeetsNothingGoAfterManyCrossings) {
  const Orbit orbit = Torus({}).orbit({{0.125, 0.5}, {1, 0.6180339887498949}}, 1);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  EXPECT_EQ(orbit.crossings.size(), std::size_t{1} << 18);
}

TEST(PeriodicWalls, StartedOnAreCrossedOrEnteredBy) {
  const Torus torus({{{0.5, 0.5}, 0.25}});
  const Orbit out = torus.orbit({{1, 0.5}, {1, 0}}, 1), in = torus.orbit({{0, 0.5}, {1, 0}}, 1);
  EXPECT_EQ(out.crossings.size(), 1U);
  EXPECT_EQ(in.crossings.size(), 0U);
  EXPECT_EQ(out.bounces.at(0).point, Vec2(0.25, 0.5));
  EXPECT_EQ(in.bounces.at(0).point, Vec2(0.25, 0.5));
}

// Discs in the corners, all copies of one, so that crossing walls end on it.
TEST(PeriodicWalls, StopWhereAMirrorMeetsThem) {
  const Torus torus({{{0, 0}, 0.25}, {{1, 0}, 0.25}, {{0, 1}, 0.25}, {{1, 1}, 0.25}});
  EXPECT_EQ(torus.orbit({{0.5, 0.5}, {0.5, -0.25}}, 1).end, OrbitEnd::corner);
  EXPECT_EQ(torus.orbit({{0.5, 0.5}, {0.5, 0.3125}}, 50).end, OrbitEnd::limit);
}

TEST(OrbitLines, EndAtBouncesAndCrossings) {
  const Orbit orbit = Torus({{{0.5, 0.5}, 0.125}}).orbit({{0.75, 0.25}, {1, 0.25}}, 1);
  const std::vector<OrbitLine> lines = orbit_lines(orbit);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_FALSE(lines[0].reflected);
  EXPECT_EQ(lines[0].line.b, Vec2(1, 0.3125));
  EXPECT_TRUE(lines[1].reflected);
  EXPECT_EQ(lines[1].line.a, Vec2(0, 0.3125));
  EXPECT_EQ(lines[1].line.b, orbit.bounces[0].point);
}

}  // namespace
}  // namespace flatray
