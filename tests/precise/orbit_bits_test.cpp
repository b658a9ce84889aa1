// needs: mpfr
// How many bits a long orbit needs, and that it is right to its end: against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/long_orbit.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

// The unit square from (1/8, 3/8) along (99, 70), unfolded: a copy of it is left through a wall
// x = i at t = (8 i - 1) / 792, through y = j at (8 j - 3) / 560. All coordinates are whole numbers
// of 1 / (792 * 70).
constexpr std::int64_t kUnit = 792 * 70;
const Vec2 kStart(0.125, 0.375), kDirection(99, 70);

struct Folded {
  std::uint32_t wall;
  std::int64_t x, y;  // in parts of kUnit
};

std::int64_t fold(std::int64_t place) {
  const std::int64_t rest = place % (2 * kUnit);
  return rest > kUnit ? 2 * kUnit - rest : rest;
}

std::vector<Folded> unfolded(std::size_t bounces) {
  std::vector<Folded> found;
  std::int64_t i = 1, j = 1;
  while (found.size() < bounces) {
    const std::int64_t tx = (8 * i - 1) * 70, ty = (8 * j - 3) * 99;  // of 55440
    const std::int64_t t = std::min(tx, ty);
    const std::int64_t x = kUnit / 8 + 99 * t, y = 3 * kUnit / 8 + 70 * t;
    found.push_back({tx < ty ? (i % 2 == 1 ? 1U : 3U) : (j % 2 == 1 ? 2U : 0U), fold(x), fold(y)});
    ++(tx < ty ? i : j);
  }
  return found;
}

// The room is the square with its sides along (a, b) and (-b, a): a quotient of whole numbers is the
// nearest double.
void expect_unfolded(std::int64_t a, std::int64_t b, std::size_t bounces, unsigned most_bits) {
  const auto turned = [&](double x, double y) {
    const auto p = static_cast<double>(a), q = static_cast<double>(b);
    return Vec2(p * x - q * y, q * x + p * y);
  };
  const Surfaces walls = room({turned(0, 0), turned(1, 0), turned(1, 1), turned(0, 1)});
  const auto orbit = certified_orbit(
      walls, {turned(kStart.x(), kStart.y()), turned(kDirection.x(), kDirection.y())}, bounces);
  ASSERT_TRUE(orbit && orbit->decided);
  EXPECT_LE(orbit->bits, most_bits);
  EXPECT_FALSE(orbit->rational);
  const std::vector<Folded> truth = unfolded(bounces);
  ASSERT_EQ(orbit->bounces.size(), truth.size());
  const auto quotient = [](std::int64_t top) {
    return static_cast<double>(top) / static_cast<double>(kUnit);
  };
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const auto& [wall, x, y] = truth[k];
    ASSERT_EQ(orbit->bounces[k].surface, wall) << k;
    ASSERT_EQ(orbit->bounces[k].point, Vec2(quotient(a * x - b * y), quotient(b * x + a * y))) << k;
  }
}

TEST(OrbitBits, ASquareAlongTheAxesTakesNoMoreForMoreBounces) { expect_unfolded(1, 0, 4000, 128); }

// Found by components whose errors grew by sqrt 2 a bounce: 4000 bounces took 8192 bits.
TEST(OrbitBits, ASquareAskewTakesTheLogarithmOfTheBounces) { expect_unfolded(4, 3, 4000, 128); }

// The chords of a circle all lie as far from its centre, and each point is the last one turned.
TEST(OrbitBits, ACircleTakesTheLogarithmOfTheBouncesToo) {
  constexpr std::size_t kBounces = 1000;
  for (const Circle& circle : {Circle{{0, 0}, 1}, Circle{{0.3, 0.1}, 1}}) {
    Surfaces walls;
    walls.add(circle);
    const Ray start{{0.5, 0.25}, {-1, 2}};
    const auto orbit = certified_orbit(walls, start, kBounces);
    ASSERT_TRUE(orbit && orbit->decided);
    EXPECT_LE(orbit->bits, 256U);
    const auto truth = oracle::long_orbit(walls, start, kBounces, 512);
    for (std::size_t k = 0; k < kBounces; ++k)
      ASSERT_EQ(orbit->bounces[k].point, truth.bounces[k].point) << k;
  }
}

// The points are (1/2, +-sqrt(3)/2) and (-1, 0), whose y no ball tells: numbers without error keep to
// few bits. Trailing zeros doubled at each bounce: 30 took minutes.
TEST(OrbitBits, NumbersWithoutErrorDoNotGrowInATriangle) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const auto orbit = certified_orbit(walls, {{0.5, 0}, {0, 1}}, 600);
  ASSERT_TRUE(orbit && orbit->decided);
  ASSERT_EQ(orbit->bounces.size(), 600U);
  const double half = 0x1.bb67ae8584caap-1;  // sqrt(3) / 2
  const Vec2 points[] = {{0.5, half}, {-1, 0}, {0.5, -half}};
  for (std::size_t k = 0; k < 600; ++k) ASSERT_EQ(orbit->bounces[k].point, points[k % 3]) << k;
}

// All that can be asked of an orbit in doubles between straight walls, and not 2048 bits of it.
TEST(OrbitBits, TheBouncesOfALongOrbitInDoublesAreProven) {
  const Surfaces walls = room({{0, 0}, {4, 3}, {1, 7}, {-3, 4}});
  const Ray start{{0.5, 2.3}, {1, 0.77}};
  const Orbit plain = trace_orbit(walls, std::vector(4, Material::mirror), start, 6000);
  const auto exact = certified_orbit(walls, start, 6000);
  ASSERT_TRUE(exact && exact->decided);
  std::uint64_t right = 0;
  while (right < 6000 && plain.bounces[right].surface == exact->bounces[right].surface) ++right;
  EXPECT_GE(right, 5000U);
  EXPECT_EQ(proven_bounces(walls, plain).bounces, right);
}

}  // namespace
}  // namespace flatray
