// Bezier curves as walls of every exact tracer.
#include <gtest/gtest.h>

#include <array>

#include "oracle/families.h"
#include "oracle/nearest.h"
#include "trace/random_rays.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

bool has_beziers(const oracle::Family& family) {
  const std::string name = family.name;
  return name.find("bezier") != std::string::npos || name.starts_with("conic");
}

void expect_truth(const Surfaces& walls, const std::vector<Ray>& rays) {
  oracle::NearestWalls oracle(walls);
  const auto tracer = accelerate(walls);
  for (const Ray& ray : rays) {
    const oracle::NearestWall truth = oracle.of(ray);
    const NearestHit hit = tracer->nearest_of_one(ray, {}, true);
    ASSERT_EQ(static_cast<bool>(hit), static_cast<bool>(truth));
    if (!hit) continue;
    EXPECT_EQ(hit.surface, truth.wall);
    EXPECT_EQ(hit.kind, truth.kind);
    EXPECT_EQ(hit.root, truth.root);
    EXPECT_EQ(hit.at_end, truth.at_end);
    EXPECT_EQ(hit.t, std::min(truth.t, std::numeric_limits<double>::max()));
  }
}

TEST(BezierWalls, AreMetAsTheOracleTells) {
  for (const oracle::Family& family : oracle::families()) {
    if (!has_beziers(family)) continue;
    SCOPED_TRACE(family.name);
    oracle::AimedScene scene = oracle::make_scene(family, 7, 0);
    scene.rays.resize(32);
    expect_truth(scene.surfaces(), scene.rays);
  }
}

// A parabola as a quadratic curve and as a cubic one, the same points: every ray meets both at one time.
TEST(BezierWalls, OfTwoThatAreTheSameTheFirstIsMet) {
  const std::array<Vec2, 3> p = {Vec2(0, 0), Vec2(6, 21), Vec2(15, 3)};
  const Bezier quadratic(p[0], p[1], p[2]),
      cubic(p[0], (p[0] + 2 * p[1]) / 3, (2 * p[1] + p[2]) / 3, p[2]);
  Surfaces one, other;
  one.add(quadratic), one.add(cubic);
  other.add(cubic), other.add(quadratic);
  const auto first = accelerate(one), second = accelerate(other);
  Draws draw(5);
  std::size_t met = 0;
  for (int i = 0; i < 500; ++i) {
    const double x = draw.unit(), y = draw.unit(), u = draw.unit(), v = draw.unit();
    const Ray ray{{15 * x, 20 * y}, {u - 0.5, v - 0.5}};
    const NearestHit hit = first->nearest_of_one(ray), same = second->nearest_of_one(ray);
    ASSERT_EQ(static_cast<bool>(hit), static_cast<bool>(same));
    if (!hit) continue;
    ++met;
    EXPECT_EQ(hit.surface, 0U);
    EXPECT_EQ(same.surface, 0U);
    EXPECT_EQ(hit.t, same.t);
  }
  EXPECT_GT(met, 100U);
}

// There both roots are one meeting, in a corner.
TEST(BezierWalls, AreMetWhereTheyCrossThemselves) {
  Surfaces walls;
  walls.add(Bezier(Vec2(-18, 12), Vec2(26, -4), Vec2(-26, -4), Vec2(18, 12)));
  std::vector<Ray> rays;
  for (int x = -20; x <= 20; x += 3)
    for (int y = -8; y <= 1; y += 3) rays.push_back({Vec2(x, y), Vec2(0, 3) - Vec2(x, y)});
  expect_truth(walls, rays);
}

// So many that they are in cells, among segments and discs.
TEST(BezierWalls, InCellsNoneIsLost) {
  Draws draw(11);
  Surfaces walls;
  const auto point = [&](const Vec2& from, double size) {
    const double x = draw.unit();
    return Vec2(from + size * Vec2(x, draw.unit()));
  };
  for (int i = 0; i < 60; ++i) {
    const Vec2 at = point({0, 0}, 30);
    if (i % 3 == 0)
      walls.add(Bezier(point(at, 2), point(at, 2), point(at, 2), point(at, 2)));
    else if (i % 3 == 1)
      walls.add(Bezier(point(at, 2), point(at, 2), point(at, 2)));
    else
      walls.add(Circle{at, 0.5});
    if (i % 4 == 0) walls.add(Segment{point(at, 2), point(at, 2)});
  }
  std::vector<Ray> rays;
  for (int i = 0; i < 300; ++i) {
    const Vec2 from = point({-2, -2}, 34);
    rays.push_back({from, point({-1, -1}, 2)});
  }
  expect_truth(walls, rays);
}

// What a ray has left it does not meet again at once; what it crosses after that, it does.
TEST(BezierWalls, AWallJustLeftIsMetElsewhere) {
  Surfaces walls;
  walls.add(Bezier({-2, 4}, {0, -4}, {2, 4}));  // y = x^2
  const auto tracer = accelerate(walls);
  const NearestHit across = tracer->nearest_of_one({{-1, 1}, {1, 0}}, {0, Root::first}, false);
  ASSERT_TRUE(across);
  EXPECT_EQ(across.t, 2);
  EXPECT_EQ(across.root, Root::first);
  EXPECT_FALSE(tracer->nearest_of_one({{1, 1}, {1, 0}}, {0, Root::second}, false));
  EXPECT_EQ(tracer->nearest_of_one({{1, 1}, {1, 0}}, {}, false).t, 0);
  EXPECT_EQ(tracer->all_of_one({{-3, 1}, {1, 0}}, {}, true).size(), 2U);
}

}  // namespace
}  // namespace flatray
