#include "image/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/philox.h"
#ifdef FLATRAY_HAVE_MPFR
#include <mpfr.h>
#endif

namespace flatray {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

#ifdef FLATRAY_HAVE_MPFR
// IEC 61966-2-1 to 200 bits, `value` on the scale of 8 bits.
class Light {
 public:
  explicit Light(double value) {
    mpfr_init2(light_, 200);
    mpfr_set_d(light_, value, MPFR_RNDN);
    mpfr_div_ui(light_, light_, 255, MPFR_RNDN);
    if (value <= 10) {  // 0.04045 * 255 = 10.31
      mpfr_mul_ui(light_, light_, 100, MPFR_RNDN);
      mpfr_div_ui(light_, light_, 1292, MPFR_RNDN);
    } else {
      power();
    }
  }
  Light(const Light&) = delete;
  Light& operator=(const Light&) = delete;
  ~Light() { mpfr_clear(light_); }
  float nearest() const { return mpfr_get_flt(light_, MPFR_RNDN); }
  float at_or_above() const { return mpfr_get_flt(light_, MPFR_RNDU); }

 private:
  void power() {
    mpfr_mul_ui(light_, light_, 1000, MPFR_RNDN);
    mpfr_add_ui(light_, light_, 55, MPFR_RNDN);
    mpfr_div_ui(light_, light_, 1055, MPFR_RNDN);
    mpfr_t exponent;
    mpfr_init2(exponent, 200);
    mpfr_set_ui(exponent, 12, MPFR_RNDN);
    mpfr_div_ui(exponent, exponent, 5, MPFR_RNDN);
    mpfr_pow(light_, light_, exponent, MPFR_RNDN);
    mpfr_clear(exponent);
  }
  mpfr_t light_;
};

TEST(Srgb, LightIsTheRoundedExactValue) {
  for (int value = 0; value < 256; ++value)
    EXPECT_EQ(linear_from_srgb(static_cast<std::uint8_t>(value)), Light(value).nearest()) << value;
}

// Between neighbours the value changes at the float next to their exact midpoint, and nowhere else.
TEST(Srgb, ValuesChangeExactlyAtTheirMidpoints) {
  float limit = 0;
  for (int value = 0; value < 256; ++value) {
    EXPECT_EQ(srgb_from_linear(limit), value);
    const float next = value < 255 ? Light(value + 0.5).at_or_above() : kInfinity;
    EXPECT_EQ(srgb_from_linear(std::nextafter(next, 0.0F)), value);
    limit = next;
  }
}
#endif

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
