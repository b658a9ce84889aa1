// needs: mpfr
// Walls that lie on one curve, or on one line: what they have in common is known without numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

const Circle kCircle{{0.25, -0.5}, 2};
const Vec2 kArcStart(0.5, 0.25), kArcDirection(-1, 2);

Vec2 on_circle(double x, double y) { return kCircle.centre + kCircle.radius * Vec2(x, y); }

CertifiedOrbit followed(const Surfaces& walls, std::uint64_t bounces) {
  auto orbit = certified_orbit(walls, {kArcStart, kArcDirection}, bounces);
  EXPECT_TRUE(orbit && orbit->decided);
  EXPECT_LE(orbit->bits, 256U);
  return *std::move(orbit);
}

CertifiedOrbit in_whole_circle(std::uint64_t bounces) {
  Surfaces whole;
  whole.add(kCircle);
  return followed(whole, bounces);
}

TEST(SharedCurves, TwoHalvesReflectAsTheWholeCircle) {
  Surfaces halves;
  halves.add(Arc{kCircle, Arc::Extent::half, {0, 1}, {0, 0}});
  halves.add(Arc{kCircle, Arc::Extent::half, {0, -1}, {0, 0}});
  const auto whole = in_whole_circle(100), parts = followed(halves, 100);
  ASSERT_EQ(parts.bounces.size(), 100U);
  std::size_t changes = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(parts.bounces[i].point, whole.bounces[i].point);
    EXPECT_EQ(parts.bounces[i].surface, parts.bounces[i].point.y() > kCircle.centre.y() ? 0U : 1U);
    if (i > 0 && parts.bounces[i].surface != parts.bounces[i - 1].surface) ++changes;
  }
  EXPECT_GE(changes, 20U);
}

// With holes about the directions (1, 0) and (-1, 0): until the ray leaves by one of them.
TEST(SharedCurves, AnOrbitLeavesACircleWithTwoHolesByAHole) {
  constexpr double kHole = 0.0625;  // half as wide, in radii
  const double x = std::sqrt(1 - kHole * kHole);
  Surfaces holed;
  holed.add(Arc{kCircle, Arc::Extent::between, on_circle(x, kHole), on_circle(-x, kHole)});
  holed.add(Arc{kCircle, Arc::Extent::between, on_circle(-x, -kHole), on_circle(x, -kHole)});
  const auto whole = in_whole_circle(100), parts = followed(holed, 100);
  EXPECT_EQ(parts.end, OrbitEnd::escape);
  const std::size_t last = parts.bounces.size();
  ASSERT_GE(last, 3U);
  ASSERT_LT(last, 100U);
  for (std::size_t i = 0; i <= last; ++i) {
    const double height = whole.bounces[i].point.y() - kCircle.centre.y();
    EXPECT_EQ(std::fabs(height) > kHole * kCircle.radius, i < last);
    if (i < last) {
      EXPECT_EQ(parts.bounces[i].point, whole.bounces[i].point);
    }
  }
}

// The curve by other half-diameters: 3, 4, 5 make a turn without rounding.
TEST(SharedCurves, ACurveIsTheSameByOtherHalfDiameters) {
  const Ellipse one({1, 2}, {10, 0}, {0, 5}), turned({1, 2}, {6, 4}, {-8, 3});
  EXPECT_TRUE(is_same_curve(one, turned));
  EXPECT_TRUE(is_same_curve(Circle{{1, 2}, 5}, Ellipse({1, 2}, {3, 4}, {-4, 3})));
  EXPECT_TRUE(is_same_curve(Circle{{1, 2}, 5}, Ellipse({1, 2}, {3, -4}, {4, 3})));
  EXPECT_FALSE(is_same_curve(one, Ellipse({1, 2}, {6, 4}, {-8, 3 + 0x1p-51})));
  EXPECT_FALSE(is_same_curve(one, Ellipse({1, 2 + 0x1p-51}, {6, 4}, {-8, 3})));
  EXPECT_FALSE(is_same_curve(one, Ellipse({1, 2}, {10, 0}, {0, -5 - 0x1p-50})));
  Surfaces whole, parts;
  whole.add(Arc{one, Arc::Extent::whole, {0, 0}, {0, 0}});
  parts.add(Arc{one, Arc::Extent::half, {1, 3}, {0, 0}});
  parts.add(Arc{turned, Arc::Extent::half, {-1, -3}, {0, 0}});
  const Ray start{{2, 3}, {1, 0.375}};
  const auto expected = certified_orbit(whole, start, 40),
             orbit = certified_orbit(parts, start, 40);
  ASSERT_TRUE(expected && orbit && expected->decided && orbit->decided);
  ASSERT_EQ(orbit->bounces.size(), 40U);
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_EQ(orbit->bounces[i].point, expected->bounces[i].point);
}

// Along the axis of a capsule. The circle of each cap goes on through the start.
TEST(SharedCurves, TheWholeCircleOfACapIsNoWall) {
  Surfaces capsule;
  capsule.add(Segment{{-1, -1}, {1, -1}});
  capsule.add(Arc{Circle{{1, 0}, 1}, Arc::Extent::half, {1, 0}, {0, 0}});
  capsule.add(Segment{{1, 1}, {-1, 1}});
  capsule.add(Arc{Circle{{-1, 0}, 1}, Arc::Extent::between, {-1, 1}, {-1, -1}});
  const auto orbit = certified_orbit(capsule, {{0, 0}, {1, 0}}, 10);
  ASSERT_TRUE(orbit && orbit->decided);
  EXPECT_EQ(orbit->bits, 128U);
  ASSERT_EQ(orbit->bounces.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_EQ(orbit->bounces[i].point, Vec2(i % 2 == 0 ? 2 : -2, 0));
  EXPECT_EQ(certified_orbit(capsule, {{0, 0}, {1, 3}}, 50)->decided, true);
}

void expect_corner(const Surfaces& walls, const std::vector<std::uint32_t>& met,
                   std::size_t bounces) {
  const auto orbit = certified_orbit(walls, {kArcStart, kArcDirection}, 50);
  ASSERT_TRUE(orbit && orbit->decided);
  EXPECT_EQ(orbit->end, OrbitEnd::corner);
  EXPECT_EQ(orbit->end_surfaces, met);
  ASSERT_EQ(orbit->bounces.size(), bounces);
  const Orbit plain = trace_orbit(walls, std::vector(walls.size(), Material::mirror),
                                  {kArcStart, kArcDirection}, 50);
  EXPECT_EQ(plain.end, OrbitEnd::corner);
  EXPECT_EQ(plain.end_surfaces, met);
  EXPECT_LT((plain.end_point - orbit->end_point).norm(), 1e-14);
  EXPECT_TRUE(proven_bounces(walls, plain).end);
}

// As in doubles, where two walls are met at once nothing says which reflects.
TEST(SharedCurves, WhereWallsLieOnEachOtherIsACorner) {
  Surfaces twice, line, overlapping;
  for (int i = 0; i < 2; ++i) twice.add(kCircle);
  expect_corner(twice, {0, 1}, 0);
  for (const double end : {2.0, 3.0}) line.add(Segment{{-end, end / 2 + 2}, {end, 2 - end / 2}});
  line.add(Circle{{9, 9}, 1});
  expect_corner(line, {0, 1}, 0);
  overlapping.add(Arc{kCircle, Arc::Extent::half, {0, 1}, {0, 0}});
  overlapping.add(Arc{kCircle, Arc::Extent::between, on_circle(-1, 0), on_circle(0.6, 0.8)});
  const auto whole = in_whole_circle(50).bounces;
  const auto on_both = std::find_if(whole.begin(), whole.end(), [](const auto& bounce) {
    const Vec2 from = bounce.point - kCircle.centre;
    return from.y() > 0 && from.x() > 0.6 * kCircle.radius;
  });
  ASSERT_GT(on_both - whole.begin(), 0);
  expect_corner(overlapping, {0, 1}, static_cast<std::size_t>(on_both - whole.begin()));
}

}  // namespace
}  // namespace flatray
