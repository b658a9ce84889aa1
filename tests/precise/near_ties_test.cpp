// needs: mpfr
// Coordinates that are 0 or the middle between two doubles, or next to that: by how little does not
// matter.
#include <gtest/gtest.h>

#include <cmath>

#include "geom/exact.h"
#include "precise/certified_orbit.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

CertifiedOrbit decided_orbit(const Surfaces& walls, const Ray& start, std::uint64_t bounces) {
  auto orbit = certified_orbit(walls, start, bounces);
  EXPECT_TRUE(orbit && orbit->decided);
  EXPECT_EQ(orbit->bounces.size(), bounces);
  return *std::move(orbit);
}

Surfaces beside_a_disc(const Segment& wall) {
  Surfaces walls;
  walls.add(wall);
  walls.add(Circle{{9, 9}, 1});
  return walls;
}

TEST(NearTies, ACoordinateNextToZeroIsNotZero) {
  const Surfaces walls = beside_a_disc({{0, -1}, {0.25, 1}});
  for (const double y : {1e-100, -1e-100, 1e-300, 5e-324, 0.0}) {
    const auto orbit = decided_orbit(walls, {{0.5, y}, {-1, 0}}, 1);
    EXPECT_EQ(orbit.bounces[0].point.y(), y);
    EXPECT_EQ(orbit.bounces[0].point.x(), (Rational(0.125) + Rational(0.125) * y).nearest());
  }
}

// At x = 1 the ray is at y + slope (1 - x), exactly: 2^-353 above, on, and below the middle between
// two doubles, of which the lower one is the even one or the upper one.
TEST(NearTies, AMiddleBetweenDoublesIsToldFromWhatIsBesideIt) {
  constexpr double kUlp = 0x1p-52;
  for (const Surfaces& walls :
       {beside_a_disc({{1, 0}, {1, 3}}), room({{-8, -8}, {1, -8}, {1, 8}, {-8, 8}})})
    for (const double y : {1.0, 1 + kUlp})
      for (const double x : {0x1p-300, 0.0, -0x1p-300}) {
        const auto orbit = decided_orbit(walls, {{x, y}, {1, kUlp / 2}}, 1);
        const Rational exact = Rational(y) + Rational(kUlp / 2) * (Rational(1) - x);
        const double even = y == 1 ? y : y + kUlp;
        EXPECT_EQ(orbit.bounces[0].point.y(), x > 0 ? y : x < 0 ? y + kUlp : even);
        EXPECT_EQ(orbit.bounces[0].point.y(), exact.nearest());
      }
}

// Chords of 120 degrees: the second point is (0, -1), though all else on the way has a root of 3.
TEST(NearTies, AnExactZeroAfterARootIsProven) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const auto orbit = decided_orbit(walls, {{0, 0.5}, {1, 0}}, 30);
  EXPECT_TRUE(orbit.rational);
  const double far = std::sqrt(0.75);
  const Vec2 corners[] = {{far, 0.5}, {0, -1}, {-far, 0.5}};
  for (std::size_t i = 0; i < 30; ++i) {
    const Vec2& corner = corners[i % 3];
    EXPECT_EQ(orbit.bounces[i].point.x(), corner.x());
    EXPECT_EQ(orbit.bounces[i].point.y(), corner.y());
    EXPECT_EQ(orbit.bounces[i].normal.x(), -corner.x() + 0.0);
  }
}

// The same turned by 10^-100: its second point is (10^-100, -1).
TEST(NearTies, WhatIsNextToZeroAfterARootIsNot) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const auto orbit = decided_orbit(walls, {{0, 0.5}, {1, 1e-100}}, 3);
  EXPECT_EQ(orbit.bounces[1].point, Vec2(1e-100, -1));
}

// A tangent met exactly is passed by, one met within 10^-100 is met.
TEST(NearTies, ATangentIsToldFromAChord) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const auto passes = decided_orbit(walls, {{1, -1}, {0, 1}}, 0);
  EXPECT_EQ(certified_orbit(walls, {{1, -1}, {0, 1}}, 5)->end, OrbitEnd::escape);
  EXPECT_EQ(certified_orbit(walls, {{1, -1}, {1e-100, 1}}, 5)->bounces.size(), 0U);
  const auto met = certified_orbit(walls, {{1, -1}, {-1e-100, 1}}, 5);
  ASSERT_EQ(met->bounces.size(), 1U);
  // At height h the line is at 1 - 10^-100 (h + 1), the circle at 1 - h^2 / 2: h^2 is 2 10^-100.
  EXPECT_NEAR(met->bounces[0].point.y(), -std::sqrt(2) * 1e-50, 1e-63);
  EXPECT_EQ(met->end, OrbitEnd::escape);
}

// Found by a place that stands for all of a curve, and was taken for a point of the arc: of a narrow
// one it lies outside.
TEST(NearTies, AnArcThatIsJustMetIsMet) {
  Surfaces walls;
  walls.add(Arc{Circle{{0, 0}, 1}, Arc::Extent::between, {0.5, -0.125}, {0.5, 0.125}});
  const auto met = certified_orbit(walls, {{1, -1}, {-1e-100, 1}}, 5);
  ASSERT_TRUE(met && met->decided);
  ASSERT_EQ(met->bounces.size(), 1U);
  EXPECT_NEAR(met->bounces[0].point.y(), -std::sqrt(2) * 1e-50, 1e-63);
  const auto missed = certified_orbit(walls, {{1, -1}, {1e-100, 1}}, 5);
  ASSERT_TRUE(missed && missed->decided);
  EXPECT_EQ(missed->bounces.size(), 0U);
}

// Off the wall from (3, 0) to (0, 4) the ray comes to (0, 0), where two circles touch, by thirds and
// fifths.
TEST(NearTies, ACornerOfCurvedWallsMetExactlyAfterABounceIsOne) {
  Surfaces walls;
  walls.add(Segment{{3, 0}, {0, 4}});
  walls.add(Circle{{-1, 0}, 1});
  walls.add(Circle{{-2, 0}, 2});
  const auto orbit = certified_orbit(walls, {{1, 1}, {71, 47}}, 9);
  ASSERT_TRUE(orbit && orbit->decided);
  EXPECT_TRUE(orbit->rational);
  EXPECT_EQ(orbit->bounces.size(), 1U);
  EXPECT_EQ(orbit->end, OrbitEnd::corner);
  EXPECT_EQ(orbit->end_point, Vec2(0, 0));
  EXPECT_EQ(orbit->end_surfaces, (std::vector<std::uint32_t>{1, 2}));
  const auto beside = certified_orbit(walls, {{1, 1}, {71, std::nextafter(47.0, 48.0)}}, 3);
  ASSERT_TRUE(beside && beside->decided);
  EXPECT_GE(beside->bounces.size(), 2U);
}

// Off the same wall at (9/4, 1) along (-7, -24) / 25, which is tangent to the disc; in a disc larger by an
// ulp it is a chord.
TEST(NearTies, ATangentMetExactlyAfterABounceIsPassed) {
  const auto bounces = [](double radius) {
    Surfaces walls;
    walls.add(Segment{{3, 0}, {0, 4}});
    walls.add(Circle{{2.25, 0.21875}, radius});
    const auto orbit = certified_orbit(walls, {{0, 1}, {1, 0}}, 2);
    EXPECT_TRUE(orbit && orbit->decided);
    return orbit->bounces.size();
  };
  EXPECT_EQ(bounces(0.21875), 1U);
  EXPECT_EQ(bounces(std::nextafter(0.21875, 0.0)), 1U);
  EXPECT_EQ(bounces(std::nextafter(0.21875, 1.0)), 2U);
}

}  // namespace
}  // namespace flatray
