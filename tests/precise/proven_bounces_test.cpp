#include "precise/proven_bounces.h"

#include <gtest/gtest.h>

#include "geom/exact.h"
#include "precise/certified_orbit.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

Orbit orbit_in(const Surfaces& walls, const Ray& start, std::uint64_t bounces) {
  return trace_orbit(walls, std::vector(walls.size(), Material::mirror), start, bounces);
}

// The walls of an orbit between straight mirrors, in rationals: every division is exact.
std::vector<std::uint32_t> exact_walls(const Surfaces& walls, const Ray& start, std::size_t count) {
  Rational x = start.origin.x(), y = start.origin.y();
  Rational dx = start.direction.x(), dy = start.direction.y();
  std::vector<std::uint32_t> met;
  while (met.size() < count) {
    std::optional<Rational> nearest;
    std::uint32_t first = kNoSurface;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      if (!met.empty() && i == met.back()) continue;
      const Segment& wall = walls.segments[i];
      const Rational ex = Rational(wall.b.x()) - wall.a.x(), ey = Rational(wall.b.y()) - wall.a.y();
      const Rational ax = Rational(wall.a.x()) - x, ay = Rational(wall.a.y()) - y;
      const Rational along = dx * ey - dy * ex;
      if (along.sign() == Sign::zero) continue;
      const Rational t = (ax * ey - ay * ex) / along, u = (ax * dy - ay * dx) / along;
      if (t.sign() != Sign::positive || u < Rational(0) || Rational(1) < u) continue;
      if (nearest && *nearest <= t) continue;
      nearest = t;
      first = i;
    }
    if (!nearest) return met;
    const Segment& wall = walls.segments[first];
    const Rational ex = Rational(wall.b.x()) - wall.a.x(), ey = Rational(wall.b.y()) - wall.a.y();
    const Rational turn = Rational(2) * (dx * ey - dy * ex) / (ex * ex + ey * ey);
    x += *nearest * dx;
    y += *nearest * dy;
    dx -= turn * ey;
    dy += turn * ex;
    met.push_back(first);
  }
  return met;
}

TEST(ProvenBounces, AnOrbitOfDyadicPointsIsProvenToItsEnd) {
  const Surfaces square = room({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  const Orbit orbit = orbit_in(square, {{15, 5}, {1, 1}}, 1000);
  ASSERT_EQ(orbit.bounces.size(), 1000U);
  EXPECT_EQ(proven_bounces(square, orbit).bounces, 1000U);
}

// The first wall is met within an ulp of a corner, where no double lies between both: the orbit ends there,
// which the exact one does not.
TEST(ProvenBounces, AnEndForWantOfADoubleIsNotProven) {
  const Surfaces wedge = room({{16, 16}, {19, 17}, {19, 0x1.1000000000010p+4}});
  const Ray start{{18, 16.666666666666682}, {-1.997, -0.6656666666666821}};
  const Orbit orbit = orbit_in(wedge, start, 10);
  ASSERT_EQ(orbit.end, OrbitEnd::corner);
  ASSERT_TRUE(orbit.bounces.empty());
  EXPECT_FALSE(proven_bounces(wedge, orbit).end);
  const Surfaces square = room({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  for (const Ray& ray : {Ray{{5, 5}, {-1, -1}}, Ray{{0, 0}, {1, 1}}, Ray{{5, 0}, {1, 0}}}) {
    const Orbit at_once = orbit_in(square, ray, 10);
    ASSERT_TRUE(at_once.bounces.empty());
    EXPECT_TRUE(proven_bounces(square, at_once).end);
    EXPECT_EQ(proven_bounces(square, at_once).bounces, 0U);
  }
}

TEST(ProvenBounces, AreThoseOfTheRationals) {
  const Surfaces pentagon = room({{0, 0}, {7, -1}, {9, 5}, {4, 9}, {-1, 6}});
  for (const Vec2& towards : {Vec2(3, 1.7), Vec2(-1, 0.33), Vec2(0.01, 5)}) {
    const Ray start{{4, 3}, towards};
    const Orbit orbit = orbit_in(pentagon, start, 60);
    const std::uint64_t proven = proven_bounces(pentagon, orbit).bounces;
    const auto truth = exact_walls(pentagon, start, 60);
    std::uint64_t right = 0;
    while (right < orbit.bounces.size() && orbit.bounces[right].surface == truth[right]) ++right;
    EXPECT_LE(proven, right);
    EXPECT_EQ(proven, 60U);  // errors between straight walls grow slowly
  }
}

// Discs in a room part near rays by a factor a bounce: doubles lose an orbit within some thirty
// bounces.
TEST(ProvenBounces, EndAmongDiscsBeforeTheDoublesGoWrongForGood) {
  Surfaces walls = room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  walls.add(Circle{{0, 0}, 1});
  const Orbit orbit = orbit_in(walls, {{-1.5, 0.3}, {1, 0.21}}, 400);
  ASSERT_EQ(orbit.bounces.size(), 400U);
  const std::uint64_t proven = proven_bounces(walls, orbit).bounces;
  EXPECT_GE(proven, 10U);
  EXPECT_LT(proven, 200U);
}

TEST(ProvenBounces, DoNotDependOnTheScale) {
  const auto proven_at = [](double scale) {
    Surfaces walls =
        room({scale * Vec2(-2, -2), scale * Vec2(2, -2), scale * Vec2(2, 2), scale * Vec2(-2, 2)});
    walls.add(Circle{{0, 0}, scale});
    const Orbit orbit = orbit_in(walls, {scale * Vec2(-1.5, 0.3), {1, 0.21}}, 100);
    return proven_bounces(walls, orbit).bounces;
  };
  EXPECT_EQ(proven_at(0x1p40), proven_at(1));
  EXPECT_EQ(proven_at(0x1p-40), proven_at(1));
}

TEST(ProvenBounces, InsideACircleTheRootLeftIsNotMetAgain) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const Orbit from_inside = orbit_in(walls, {{0.25, 0}, {0.5, 1}}, 50);
  EXPECT_EQ(proven_bounces(walls, from_inside).bounces, 50U);
  const Orbit from_wall = orbit_in(walls, {{1, 0}, {-1, 1}}, 50);
  EXPECT_EQ(proven_bounces(walls, from_wall).bounces, 50U);
}

TEST(ProvenBounces, OfAnOrbitWithoutBouncesAreNone) {
  const Surfaces square = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(proven_bounces(square, orbit_in(square, {{0.5, 0.5}, {1, 1}}, 9)).bounces, 0U);
}

// Both ends of a mirror: beside one the ray is met again, beside the other it leaves.
TEST(ProvenBounces, TellWhetherTheEndIsProvenToo) {
  Surfaces walls;
  walls.add(Segment{{0, 0}, {1, 0}});
  walls.add(Circle{{4, 3}, 1});
  Orbit orbit = orbit_in(walls, {{-1, 1}, {1.5, -1}}, 9);
  ASSERT_EQ(orbit.end, OrbitEnd::escape);
  EXPECT_TRUE(proven_bounces(walls, orbit).end);
  orbit.bounces.pop_back();
  EXPECT_FALSE(proven_bounces(walls, orbit).end);
}

// All bounces are on one disc, of which the doubles come to other copies sooner or later.
TEST(ProvenBounces, BetweenPeriodicWallsCountTheWallsCrossedToo) {
  Surfaces cell = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  cell.add(Circle{{0.5, 0.5}, 0.375});
  std::vector<Material> materials(5, Material::periodic);
  materials[4] = Material::mirror;
  const Orbit orbit = trace_orbit(cell, materials, {{0.0625, 0.0625}, {1, 0.8125}}, 100);
  ASSERT_EQ(orbit.bounces.size(), 100U);
  const std::uint64_t proven = proven_bounces(cell, orbit, materials).bounces;
  EXPECT_GE(proven, 10U);
  EXPECT_LT(proven, 90U);
  Orbit astray = orbit;
  ASSERT_GE(astray.crossings[0].bounces, 1U);
  CellIndex& step = astray.crossings[0].step;
  step = {-step.a, -step.b};
  EXPECT_EQ(proven_bounces(cell, astray, materials).bounces, astray.crossings[0].bounces);
}

// In doubles the ray stays at one height, which is to cross the cell for ever. Exactly it rises by half an
// ulp a cell, and meets the disc. Along the diagonal it does escape.
TEST(ProvenBounces, ThatARayOnlyCrossesPeriodicWallsIsNotTakenForGranted) {
  Surfaces cell = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  cell.add(Circle{{0.5, 0.75}, 0.25 - 0x1p-52});
  std::vector<Material> materials(5, Material::periodic);
  materials[4] = Material::mirror;
  const Ray start{{0.5, 0.5}, {1, 5e-17}};
  const Orbit plain = trace_orbit(cell, materials, start, 1);
  ASSERT_EQ(plain.end, OrbitEnd::escape);
  ASSERT_TRUE(plain.bounces.empty());
  EXPECT_FALSE(proven_bounces(cell, plain, materials).end);
  if (const auto exact = certified_orbit(cell, start, 1, {materials})) {
    EXPECT_TRUE(exact->decided);
    EXPECT_EQ(exact->bounces.size(), 1U);
  }
  const Ray diagonal{{0.125, 0.875}, {1, 1}};
  const Orbit round = trace_orbit(cell, materials, diagonal, 1);
  ASSERT_EQ(round.end, OrbitEnd::escape);
  EXPECT_TRUE(proven_bounces(cell, round, materials).end);
}

}  // namespace
}  // namespace flatray
