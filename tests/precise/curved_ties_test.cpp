// needs: mpfr
// Curved walls met or missed by less than the first bits tell, and ends that no bits tell.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "precise/ball.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

// 1 + 2^-200 beside numbers of fewer bits: no operation takes the fewer.
TEST(Ball, OfTwoNumbersHasTheBitsOfTheFiner) {
  const Ball one(1, 256), more = one + Ball(0x1p-200, 256), few(1, 128), none(0, 128);
  for (const Ball& same :
       {more + none, none + more, more - none, more * few, few * more, more / few})
    EXPECT_EQ((same - one).sign(), Sign::positive);
  EXPECT_EQ((few / more - one).sign(), Sign::negative);
}

// Its highest point is (3.4, 0): sqrt(0.75^2 + 1^2) above the centre, at cosine 0.6 and sine 0.8.
TEST(CertifiedOrbit, AnEllipseIsMetOrMissedByAsLittleAsCoordinatesSay) {
  Surfaces walls;
  walls.add(Arc{Ellipse({0, -1.25}, {3, 0.75}, {2, 1}), Arc::Extent::whole, {0, 0}, {0, 0}});
  for (const double x : {-9.0, 2.0, 3.0}) {
    const auto into = certified_orbit(walls, {{x, -0x1p-140}, {1, 0}}, 1);
    ASSERT_TRUE(into && into->decided);
    ASSERT_EQ(into->bounces.size(), 1U) << x;
    EXPECT_NEAR(into->bounces[0].point.x(), 3.4, 1e-15);
    EXPECT_EQ(into->bounces[0].point.y(), -0x1p-140);
    const auto past = certified_orbit(walls, {{x, 0x1p-140}, {1, 0}}, 1);
    ASSERT_TRUE(past && past->decided);
    EXPECT_EQ(past->end, OrbitEnd::escape);
    EXPECT_TRUE(past->bounces.empty());
  }
}

// 128 bits, twice that, and so on, until all is told.
TEST(CertifiedOrbit, PrecisionIsDoubledUntilAllIsTold) {
  Surfaces walls = room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  walls.add(Circle{{0, 0}, 1});
  unsigned before = 0;
  for (const std::uint64_t bounces : {5U, 60U, 120U, 250U}) {
    const auto orbit = certified_orbit(walls, {{-1.5, 0.3}, {1, 0.21}}, bounces);
    ASSERT_TRUE(orbit && orbit->decided);
    EXPECT_EQ(std::bit_floor(orbit->bits / 128) * 128, orbit->bits);
    EXPECT_GE(orbit->bits, before);
    before = orbit->bits;
  }
  EXPECT_GE(before, 512U);
}

// At the very point where the ray touches the disc it bounces off a segment, or leaves a cell of a torus: what is
// only touched between its ends is no corner, in doubles as in proofs.
TEST(CertifiedOrbit, ADiscThatIsOnlyTouchedMakesNoCorner) {
  for (const Arc::Extent extent : {Arc::Extent::whole, Arc::Extent::half}) {
    Surfaces walls;
    walls.add(Arc{Circle{{-4, -2}, 4}, extent, {-3, -2}, {0, 0}});
    walls.add(Segment{{3, -2}, {-2, -2}});
    const Ray ray{{0, -4}, {0, 4}};
    const Orbit plain = trace_orbit(walls, std::vector(2, Material::mirror), ray, 3);
    const auto certified = certified_orbit(walls, ray, 3);
    ASSERT_TRUE(certified && certified->decided);
    ASSERT_EQ(plain.bounces.size(), 1U);
    EXPECT_EQ(plain.bounces[0].surface, 1U);
    EXPECT_EQ(plain.end, OrbitEnd::escape);
    EXPECT_EQ(certified->bounces.size(), 1U);
    EXPECT_EQ(certified->end, OrbitEnd::escape);
    EXPECT_EQ(proven_bounces(walls, plain).bounces, 1U);
  }
}

// Exactly at an end that lies on the curve it is no bounce, however many bits there are; beside it on
// one side it is, and on the other it is not.
TEST(CertifiedOrbit, AnEndMetExactlyIsNoBounce) {
  Surfaces walls;
  walls.add(Arc{Ellipse({0, 0}, {3, 0}, {0, 1}), Arc::Extent::between, {3, 0}, {0, 1}});
  const auto met = [&](double shift) {
    return certified_orbit(walls, {{5, 1 + shift}, {-2, -1}}, 1, {.most_bits = 512}).value();
  };
  const CertifiedOrbit exact = met(0);
  EXPECT_TRUE(exact.bounces.empty());
  EXPECT_TRUE(!exact.decided || exact.end == OrbitEnd::corner);
  EXPECT_EQ(met(0x1p-40).bounces.size(), 1U);
  const CertifiedOrbit beside = met(-0x1p-40);
  EXPECT_TRUE(beside.decided);
  EXPECT_EQ(beside.end, OrbitEnd::escape);
}

// What joins an end to its curve is as short as the end is off it: rays through the disc do not meet it.
TEST(CertifiedOrbit, WhatJoinsAnEndToItsCurveIsMetWhereItIs) {
  Surfaces walls;
  walls.add(Arc{Circle{{0, 0}, 1}, Arc::Extent::between, {3, 1}, {-1, 0}});
  for (const auto& [ray, point] : {std::pair(Ray{{5, 0}, {-9, 2}}, Vec2(2, 2.0 / 3)),
                                   std::pair(Ray{{3, -4}, {0, 1}}, Vec2(3, 1))}) {
    const auto orbit = certified_orbit(walls, ray, 1);
    ASSERT_TRUE(orbit);
    EXPECT_EQ(orbit->end, OrbitEnd::corner);
    EXPECT_EQ(orbit->end_point, point);
  }
}

TEST(CertifiedOrbit, AnEndOffItsCurveIsMetNowhereElse) {
  Surfaces walls;
  walls.add(Arc{Circle{{0, 0}, 1}, Arc::Extent::between, {0.6, 0.8}, {-1, 0}});
  for (const double y : {-0.9, -0.2, 0.1, 0.7}) {
    const auto orbit = certified_orbit(walls, {{3, y}, {-1, 0}}, 1, {.most_bits = 512}).value();
    EXPECT_TRUE(orbit.decided) << y;
    EXPECT_EQ(orbit.end, y < 0 ? OrbitEnd::escape : OrbitEnd::limit) << y;
    if (y > 0) {
      ASSERT_EQ(orbit.bounces.size(), 1U);
      EXPECT_NEAR(orbit.bounces[0].point.x(), -std::sqrt(1 - y * y), 1e-15);
    }
  }
}

}  // namespace
}  // namespace flatray
