#include "geom/predicates.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/philox.h"
#include "geom/error_bounds.h"
#include "oracle/exact.h"

namespace flatray {
namespace {

constexpr std::uint64_t kPredicateSeed = 20181123;

std::uint64_t bits(std::uint64_t item, std::uint32_t draw) {
  return random_bits(kPredicateSeed, Stream::test, 0, item, draw);
}

// A coordinate from a family that is hard in its own way.
double coordinate(int family, std::uint64_t b) {
  const double unit = unit_double(b), sign = (b & 1) != 0 ? 1 : -1;
  switch (family) {
    case 0:
      return 2 * unit - 1;  // random
    case 1:
      return std::floor(unit * 5);  // grid
    case 2:
      return std::floor(unit * 20) / 10;  // decimals
    case 3:
      return 0.5 + std::floor(unit * 4) * 0x1p-53;  // one ulp apart
    case 4:
      return std::ldexp(sign, static_cast<int>(unit * 2044) - 1022);  // any magnitude
    case 5:
      return sign * std::floor(unit * 4) * 0x1p-1074;  // denormal
    case 6:
      return sign * (1 + std::floor(unit * 3)) * 0x1p1022;  // huge
    case 7:
      return 0x1p52 + std::floor(unit * 4);  // far from 0
    default:
      return (b & 6) == 0 ? 0 : sign * std::ldexp(unit, (b & 8) != 0 ? -540 : 3);
  }
}

TEST(Predicates, AgreeWithRationalSlopesWhereProductsOverflow) {
  for (std::uint64_t i = 0; i < 9000; ++i) {
    Vec2 p[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double unit = unit_double(bits(i, 10 + k));
      // Of one magnitude from 2^490 on, one far smaller, or all but on a line.
      const int power = k == 2 && i % 3 == 1 ? -500 : 490 + static_cast<int>(i % 532);
      const double x = std::ldexp(unit - 0.5, power);
      const double y = i % 3 == 2 ? x : std::ldexp(unit_double(bits(i, 20 + k)) - 0.5, power);
      p[k] = {x, k == 2 && i % 2 == 0 ? std::nextafter(y, 0) : y};
    }
    ASSERT_EQ(orientation(p[0], p[1], p[2]), oracle::side_of_line(p[0], p[1], p[2])) << i;
    ASSERT_EQ(cross_sign(p[0], p[1]), oracle::side_of_line({0, 0}, p[0], p[1])) << i;
  }
}

TEST(Predicates, AgreeWithRationalSlopesOnEveryFamily) {
  RecordProperty("seed", static_cast<int>(kPredicateSeed));
  for (std::uint64_t i = 0; i < 9000; ++i) {
    const int family = static_cast<int>(i % 9);
    Vec2 p[3];
    for (std::uint32_t k = 0; k < 3; ++k)
      p[k] = {coordinate(family, bits(i, 2 * k)), coordinate(family, bits(i, 2 * k + 1))};
    const Vec2 zero(0, 0);
    ASSERT_EQ(orientation(p[0], p[1], p[2]), oracle::side_of_line(p[0], p[1], p[2]))
        << "family " << family << " case " << i;
    ASSERT_EQ(cross_sign(p[0], p[1]), oracle::side_of_line(zero, p[0], p[1]))
        << "family " << family << " case " << i;
    // The origin moved to 0, where that rounds nothing.
    if (family != 1 && family != 7) continue;
    ASSERT_EQ(side_of_ray({p[0], p[1]}, p[2]), oracle::side_of_line(zero, p[1], p[2] - p[0]));
    ASSERT_EQ(turn_from_edge(p[0], p[1], p[2]), oracle::side_of_line(zero, p[1] - p[0], p[2]));
  }
}

TEST(StiffCases, A13NearCollinearGrid) {
  int on_line = 0;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) {
      const Vec2 point(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      const Sign side = orientation({12, 12}, {24, 24}, point);
      ASSERT_EQ(side, sign_of(point.y() - point.x())) << i << ", " << j;
      on_line += side == Sign::zero ? 1 : 0;
    }
  EXPECT_EQ(on_line, 256);
}

TEST(Predicates, ProductsThatUnderflowAreNotTakenForZero) {
  EXPECT_EQ(cross_sign({1e-300, 1e-300}, {1e-300, 1.5e-300}), Sign::positive);
  EXPECT_EQ(cross_sign({5e-324, 1e-323}, {1e-323, 5e-324}), Sign::negative);
  EXPECT_EQ(orientation({0, 0}, {5e-324, 0}, {0, 5e-324}), Sign::positive);
}

TEST(Predicates, ProductsAndDifferencesThatOverflowAreDecided) {
  EXPECT_EQ(cross_sign({1e300, 1e300}, {1e300, 2e300}), Sign::positive);
  EXPECT_EQ(cross_sign({1e300, 1e300}, {1e300, 1e300}), Sign::zero);
  EXPECT_EQ(orientation({-1.7e308, -1.7e308}, {1.7e308, 1.7e308}, {1, 1}), Sign::zero);
  EXPECT_EQ(orientation({-1.7e308, -1.7e308}, {1.7e308, 1.7e308}, {1, 1.0000000000000002}),
            Sign::positive);
}

}  // namespace
}  // namespace flatray
