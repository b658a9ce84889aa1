#include "geom/turn.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "geom/exact.h"
#include "geom/ray.h"

namespace flatray {
namespace {

TEST(Turn, QuartersAreExactHoweverTheyWereSummed) {
  const Turn quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  double summed = 0;
  for (int i = 0; i < 12; ++i) {
    for (const double angle : {i * std::numbers::pi / 2, i * 90.0 / 180 * std::numbers::pi}) {
      EXPECT_EQ(turn(angle).cos, quarters[i % 4].cos) << i;
      EXPECT_EQ(turn(angle).sin, quarters[i % 4].sin) << i;
      EXPECT_EQ(turn(-angle).sin, -quarters[i % 4].sin) << i;
    }
    summed += std::numbers::pi / 2;
  }
  EXPECT_EQ(turn(summed).cos, 1);
}

// pi by its first 224 binary digits: a whole number and seven words behind the point.
Rational pi() {
  constexpr std::array<double, 8> kWords = {3.0,         0x243f6a88p0, 0x85a308d3p0, 0x13198a2ep0,
                                            0x3707344p0, 0xa4093822p0, 0x299f31d0p0, 0x082efa98p0};
  Rational sum = 0;
  for (auto word = kWords.rbegin(); word != kWords.rend(); ++word) sum = sum * 0x1p-32 + *word;
  return sum;
}

// Also where turns are many: doubles beside the one nearest to k pi/2 are quarters, the next are not.
TEST(Turn, QuartersReachOneUlpToEitherSideAndNoFarther) {
  const auto is_quarter = [](double angle) {
    const Turn it = turn(angle);
    return it.cos == 0 || it.sin == 0;
  };
  const Rational quarter = pi() / 2;
  for (double k = 1; k < 0x1p40; k = k < 300 ? k + 1 : std::floor(1.1 * k)) {
    const double nearest = (quarter * k).nearest();
    for (const double side : {-kInfinity, kInfinity}) {
      const double beside = std::nextafter(nearest, side);
      ASSERT_TRUE(is_quarter(beside)) << k << ' ' << side;
      ASSERT_FALSE(is_quarter(std::nextafter(beside, side))) << k << ' ' << side;
    }
  }
}

TEST(Turn, OtherAnglesAreThoseOfTheFunctions) {
  const Turn third = turn(std::numbers::pi / 3);
  EXPECT_NEAR(third.cos, 0.5, 1e-15);
  EXPECT_NEAR(third.sin, std::numbers::sqrt3 / 2, 1e-15);
}

}  // namespace
}  // namespace flatray
