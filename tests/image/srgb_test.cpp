#include "image/srgb.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace flatray {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The light of IEC 61966-2-1, `value` on the scale of 8 bits: v / 12.92, or u^(12/5) with u = (v +
// 0.055) / 1.055. Whether a float lies below it is a question of rationals: f < u^(12/5) where f^5
// < u^12.
class ExactLight {
 public:
  explicit ExactLight(const mpq_class& value)
      : linear_(value <= 10),  // 0.04045 * 255 = 10.31
        base_(linear_ ? mpq_class(value / 255 * 100 / 1292)
                      : mpq_class((value / 255 * 1000 + 55) / 1055)) {}

  bool above(const mpq_class& light) const {
    return linear_ ? light < base_ : power(light, 5) < power(base_, 12);
  }

 private:
  static mpq_class power(const mpq_class& base, unsigned exponent) {
    mpq_class result = 1;
    for (unsigned i = 0; i < exponent; ++i) result *= base;
    return result;
  }
  bool linear_;
  mpq_class base_;
};

mpq_class exact(float value) { return {static_cast<double>(value)}; }
float before(float value) { return std::nextafter(value, -kInfinity); }
float after(float value) { return std::nextafter(value, kInfinity); }

TEST(Srgb, LightIsTheRoundedExactValue) {
  EXPECT_EQ(linear_from_srgb(0), 0.0F);
  for (int value = 1; value < 256; ++value) {
    const float light = linear_from_srgb(static_cast<std::uint8_t>(value));
    const ExactLight truth{mpq_class(value)};
    EXPECT_TRUE(truth.above((exact(before(light)) + exact(light)) / 2)) << value;
    EXPECT_FALSE(truth.above((exact(light) + exact(after(light))) / 2)) << value;
  }
}

// By bisection between the lights of both values: the last float that is still `value - 1`.
float last_below(int value) {
  auto low = std::bit_cast<std::uint32_t>(linear_from_srgb(static_cast<std::uint8_t>(value - 1)));
  auto high = std::bit_cast<std::uint32_t>(linear_from_srgb(static_cast<std::uint8_t>(value)));
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (srgb_from_linear(std::bit_cast<float>(middle)) < value ? low : high) = middle;
  }
  return std::bit_cast<float>(low);
}

// Between neighbours the value changes at the float next to their exact midpoint, and nowhere else.
TEST(Srgb, ValuesChangeExactlyAtTheirMidpoints) {
  EXPECT_EQ(srgb_from_linear(0.0F), 0);
  for (int value = 1; value < 256; ++value) {
    const ExactLight midpoint{mpq_class(2 * value - 1, 2)};
    const float limit = last_below(value);
    EXPECT_EQ(srgb_from_linear(limit), value - 1);
    EXPECT_TRUE(midpoint.above(exact(limit))) << value;
    EXPECT_FALSE(midpoint.above(exact(after(limit)))) << value;
  }
}

TEST(Srgb, ComingBackFromLightIsExact) {
  for (int value = 0; value < 256; ++value)
    EXPECT_EQ(srgb_from_linear(linear_from_srgb(static_cast<std::uint8_t>(value))), value);
}

TEST(Srgb, MoreLightIsNeverDarker) {
  std::uint8_t last = 0;
  for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(1.0F); bits += 1021) {
    const std::uint8_t value = srgb_from_linear(std::bit_cast<float>(bits));
    ASSERT_GE(value, last) << std::bit_cast<float>(bits);
    last = value;
  }
  EXPECT_EQ(last, 255);
}

TEST(Srgb, WhatIsOutsideTheRangeIsClamped) {
  EXPECT_EQ(srgb_from_linear(-0.0F), 0);
  EXPECT_EQ(srgb_from_linear(-1.0F), 0);
  EXPECT_EQ(srgb_from_linear(-kInfinity), 0);
  EXPECT_EQ(srgb_from_linear(std::numeric_limits<float>::denorm_min()), 0);
  EXPECT_EQ(srgb_from_linear(1.0F), 255);
  EXPECT_EQ(srgb_from_linear(1e30F), 255);
  EXPECT_EQ(srgb_from_linear(kInfinity), 255);
  EXPECT_EQ(srgb_from_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb_from_linear(-std::numeric_limits<float>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace flatray
