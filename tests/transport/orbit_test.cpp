#include "transport/orbit.h"

#include <gtest/gtest.h>

#include "geom/exact.h"
#include "trace/on_surface.h"

namespace flatray {
namespace {

Surfaces ring(const std::vector<Vec2>& vertices) {
  Surfaces walls;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    walls.add(Segment{vertices[i], vertices[(i + 1) % vertices.size()]});
  return walls;
}

Surfaces unit_square() { return ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

Orbit in_mirrors(const Surfaces& walls, const Ray& start, std::uint64_t bounces) {
  return trace_orbit(walls, std::vector<Material>(walls.size(), Material::mirror), start, bounces);
}

TEST(StiffCases, C1Diamond) {
  const Orbit orbit = in_mirrors(unit_square(), {{0.75, 0.25}, {1, 1}}, 1'000'000);
  ASSERT_EQ(orbit.bounces.size(), 1'000'000U);
  EXPECT_EQ(orbit.end, OrbitEnd::limit);
  const std::array<Vec2, 4> points = {Vec2{1, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0}};
  const std::array<std::uint32_t, 4> walls = {1, 2, 3, 0};
  for (std::size_t i = 0; i < orbit.bounces.size(); ++i) {
    ASSERT_EQ(orbit.bounces[i].point, points[i % 4]) << i;
    ASSERT_EQ(orbit.bounces[i].surface, walls[i % 4]) << i;
  }
}

// Unfolding: hit N of (1/8, 3/8) + t (99, 70) on the square's grid of mirrors.
TEST(StiffCases, C2Unfolding) {
  const Orbit orbit = in_mirrors(unit_square(), {{1.0 / 8, 3.0 / 8}, {99, 70}}, 1'000'000);
  ASSERT_EQ(orbit.bounces.size(), 1'000'000U);
  const auto expect = [&](std::size_t hit, std::uint32_t wall, double x, double y) {
    const Bounce& bounce = orbit.bounces[hit - 1];
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
  const Orbit orbit = in_mirrors(walls, {{0.3, 0.5}, {0, 1}}, 1'000'000);
  ASSERT_EQ(orbit.bounces.size(), 1'000'000U);
  for (const Bounce& bounce : orbit.bounces) ASSERT_EQ(bounce.point.x(), 0.3);
  EXPECT_EQ(orbit.bounces.back().path_length, 999'999.5);
}

}  // namespace
}  // namespace flatray
