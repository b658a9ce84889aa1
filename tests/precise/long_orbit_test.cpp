// needs: mpfr
// Certified orbits against a program that shares no formula with them: a moving point in GMP's mpf.
#include "oracle/long_orbit.h"

#include <gtest/gtest.h>

#include "precise/certified_orbit.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

Surfaces long_sinai() {
  Surfaces walls = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  walls.add(Circle{{0.5, 0.5}, 0.25});
  return walls;
}

Surfaces stadium() {
  Surfaces walls;
  walls.add(Segment{{-1, -1}, {1, -1}});
  walls.add(Arc{Circle{{1, 0}, 1}, Arc::Extent::between, {1, -1}, {1, 1}});
  walls.add(Segment{{1, 1}, {-1, 1}});
  walls.add(Arc{Circle{{-1, 0}, 1}, Arc::Extent::between, {-1, 1}, {-1, -1}});
  return walls;
}

void expect_agreement(const Surfaces& walls, const Ray& start, std::uint64_t bounces) {
  const auto certified = certified_orbit(walls, start, bounces);
  ASSERT_TRUE(certified && certified->decided);
  ASSERT_EQ(certified->bounces.size(), bounces);
  const oracle::LongOrbit orbit = oracle::long_orbit(walls, start, bounces, 4096);
  ASSERT_EQ(orbit.bounces.size(), bounces);
  for (std::size_t i = 0; i < bounces; ++i) {
    ASSERT_EQ(certified->bounces[i].surface, orbit.bounces[i].surface) << "bounce " << i;
    ASSERT_EQ(certified->bounces[i].point, orbit.bounces[i].point) << "bounce " << i;
  }
}

TEST(LongOrbit, AgreesWithCertifiedOrbitsOfSinaisRoomToTheLastDigit) {
  for (int i = 0; i < 20; ++i)
    expect_agreement(long_sinai(), {{0.1, 0.15 + 0.005 * i}, {1, 0.31}}, 200);
}

TEST(LongOrbit, AgreesWithCertifiedOrbitsOfTheStadiumToTheLastDigit) {
  for (int i = 0; i < 20; ++i) expect_agreement(stadium(), {{0.1, 0.2 + 0.01 * i}, {1, 0.7}}, 200);
}

TEST(LongOrbit, AgreesWithCertifiedOrbitsInAnEllipseAskew) {
  Surfaces walls;
  walls.add(Arc{Ellipse({0, 0}, {3, 1}, {-0.5, 2}), Arc::Extent::whole, {0, 0}, {0, 0}});
  walls.add(Segment{{-0.5, -0.5}, {0.5, -0.25}});
  for (int i = 0; i < 5; ++i) expect_agreement(walls, {{1, 0.5}, {1, 0.3 + 0.1 * i}}, 40);
}

TEST(LongOrbit, AgreesWithCertifiedOrbitsBetweenBezierCurves) {
  Surfaces walls;
  walls.add(Bezier({-2, 0}, {0, -2}, {2, 0}));
  walls.add(Bezier({2, 0}, {0, 2}, {-2, 0}));
  walls.add(Bezier({-0.5, -0.25}, {-0.25, 0.5}, {0.25, -0.5}, {0.5, 0.25}));
  for (int i = 0; i < 3; ++i) expect_agreement(walls, {{1, 0.125}, {1, 0.3 + 0.1 * i}}, 40);
}

TEST(LongOrbit, AgreesWithCertifiedOrbitsBetweenConics) {
  Surfaces walls;
  walls.add(Bezier({-2, 0}, {0, -2}, {2, 0}, 0.5));
  walls.add(Bezier({2, 0}, {0, 2}, {-2, 0}, 3));
  walls.add(Bezier({-0.5, -0.25}, {0, 0.5}, {0.5, -0.25}, 1.7));
  for (int i = 0; i < 3; ++i) expect_agreement(walls, {{1, 0.125}, {1, 0.3 + 0.1 * i}}, 40);
}

TEST(LongOrbit, MeetsTheLowestOfWallsOnEachOther) {
  Surfaces walls;
  for (int i = 0; i < 3; ++i) walls.add(Circle{{0.3, 0.1}, 0.7});
  const auto orbit = oracle::long_orbit(walls, {{5, 0.2}, {-1, 0.01}}, 1, 512);
  EXPECT_EQ(orbit.bounces.front().surface, 0U);
}

TEST(LongOrbit, ClosesOnItselfInTheTriangleOfFagnano) {
  const Surfaces walls = room({{0, 0}, {20, 0}, {10, 20}});
  const oracle::LongOrbit orbit = oracle::long_orbit(walls, {{13, 4}, {3, 4}}, 3000, 512);
  ASSERT_EQ(orbit.bounces.size(), 3000U);
  const Vec2 corners[] = {{16, 8}, {4, 8}, {10, 0}};
  for (std::size_t i = 0; i < 3000; ++i)
    ASSERT_LT((orbit.bounces[i].point - corners[i % 3]).norm(), 1e-100);
}

// Too few bits go astray: that is what two numbers of bits tell.
TEST(LongOrbit, InTooFewBitsIsAnother) {
  const Ray start{{0.1, 0.15}, {1, 0.31}};
  const auto few = oracle::long_orbit(long_sinai(), start, 200, 64),
             many = oracle::long_orbit(long_sinai(), start, 200, 2048);
  EXPECT_NE(few.bounces.back().point, many.bounces.back().point);
}

}  // namespace
}  // namespace flatray
