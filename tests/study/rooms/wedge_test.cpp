#include "study/rooms/wedge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/philox.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

constexpr double kWedgePi = std::numbers::pi;

Vec2 at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Two walls from a tip, each in the order of its ends that a bit of `order` says, and their order.
Surfaces wedge(const Vec2& tip, double from, double to, int order, double length = 1e6) {
  Segment a{tip, tip + at(length, from)}, b{tip, tip + at(length, to)};
  if (order & 1) std::swap(a.a, a.b);
  if (order & 2) std::swap(b.a, b.b);
  if (order & 4) std::swap(a, b);
  Surfaces walls;
  walls.add(a);
  walls.add(b);
  return walls;
}

// As many as the orbit has, whichever way the walls are given; rays that start anywhere in it.
TEST(Wedge, ReflectionsAreThoseOfTheOrbit) {
  for (std::uint32_t i = 0; i < 400; ++i) {
    const auto draw = [&](std::uint32_t k) {
      return unit_double(random_bits(3, Stream::test, 7, i, k));
    };
    const double alpha = 0.05 + 2.9 * draw(0), turned = 6 * draw(1);
    const Vec2 tip(draw(2) - 0.5, draw(3));
    const Surfaces walls = wedge(tip, turned, turned + alpha, static_cast<int>(i % 8));
    const Ray ray{tip + at(0.5 + draw(4), turned + alpha * (0.1 + 0.8 * draw(5))),
                  at(1, 6.28 * draw(6))};
    const Orbit orbit = trace_orbit(walls, std::vector(2, Material::mirror), ray, 200);
    ASSERT_EQ(orbit.end, OrbitEnd::escape);
    EXPECT_EQ(wedge_reflections(walls, ray), orbit.bounces.size()) << i;
  }
}

// A ray from far away along one wall's normal meets walls alpha apart ceil(pi / alpha) - 1 times at least.
TEST(Wedge, IsNoneWhereItMayBeTooShortOrThereIsNone) {
  const Ray ray{at(1, 0.2), at(1, kWedgePi)};
  EXPECT_TRUE(wedge_reflections(wedge({0, 0}, 0, 0.5, 0, 1e3), ray));
  EXPECT_FALSE(wedge_reflections(wedge({0, 0}, 0, 0.5, 0, 0.1), ray));
  EXPECT_FALSE(wedge_reflections(wedge({0, 0}, 0.4, 0.5, 0), ray));  // not in it
  Surfaces apart, one, three = wedge({0, 0}, 0, 0.5, 0);
  apart.add(Segment{{0, 0}, {9, 0}});
  apart.add(Segment{{0, 1}, {9, 1}});
  one.add(Segment{{0, 0}, {9, 0}});
  three.add(Segment{{5, 5}, {9, 0}});
  for (const Surfaces* walls : {&apart, &one, &three}) EXPECT_FALSE(wedge_reflections(*walls, ray));
}

// Found by a reviewer: cross products of doubles lose the angle between walls this close, and so do differences
// of their ends. Between the lines from (1/8, 1/4) of slopes 1 and 1 + e the angle is e / 2 - e^2 / 4.
TEST(Wedge, ReflectionsBetweenWallsThatAreNearlyOneAreAsManyAsTheAngleGoesIntoAHalfTurn) {
  const Vec2 tip(0.125, 0.25);
  const double e = 0x1p-26;
  Surfaces walls;
  walls.add(Segment{tip, tip + 0x1p34 * Vec2(1, 1)});
  walls.add(Segment{tip, tip + 0x1p34 * Vec2(1, 1 + e)});
  const double alpha = e / 2 - e * e / 4;
  const Ray across{{0.625, 0.75 + e / 4}, {-1, 1}};
  // Seen from the tip it turns by a quarter of a turn until it leaves.
  const auto found = wedge_reflections(walls, across);
  ASSERT_TRUE(found);
  EXPECT_NEAR(static_cast<double>(*found), kWedgePi / 2 / alpha, 1.5);
}

// The last crossing decides how long walls must be: just longer than that it is told, just shorter not.
TEST(Wedge, IsToldWhereWallsReachTheLastReflection) {
  const Ray ray{{5, 1}, {-1, -0.125}};
  const Surfaces endless = wedge({0, 0}, 0, 0.4, 0);
  const Orbit orbit = trace_orbit(endless, std::vector(2, Material::mirror), ray, 200);
  double reach = 0;
  for (const Bounce& bounce : orbit.bounces) reach = std::max(reach, bounce.point.norm());
  EXPECT_EQ(wedge_reflections(wedge({0, 0}, 0, 0.4, 0, 1.001 * reach), ray), orbit.bounces.size());
  EXPECT_FALSE(wedge_reflections(wedge({0, 0}, 0, 0.4, 0, 0.999 * reach), ray));
}

}  // namespace
}  // namespace flatray
