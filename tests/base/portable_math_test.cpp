#include "base/portable_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace flatray {
namespace {

TEST(PortableMath, SpecialPointsAreExact) {
  EXPECT_EQ(portable::sin(0), 0);
  EXPECT_EQ(portable::cos(0), 1);
  EXPECT_EQ(portable::exp(0), 1);
  EXPECT_EQ(portable::log(1), 0);
  EXPECT_EQ(portable::pow(2, 10), 1024);
  EXPECT_EQ(portable::pow(5, 0), 1);
  EXPECT_EQ(portable::atan2(0, 1), 0);
}

// Bits as first computed, some of them not the nearest to the truth: every machine, tier and
// compiler must give these again.
TEST(PortableMath, BitsAreTheSameEverywhere) {
  EXPECT_EQ(portable::sin(1), 0x1.aed548f090ceep-1);
  EXPECT_EQ(portable::sin(1e22), -0x1.b453ab76bf397p-1);
  EXPECT_EQ(portable::cos(1), 0x1.14a280fb5068cp-1);
  EXPECT_EQ(portable::cos(-0x1.b011575c8edp-23), 0x1.fffffffffff49p-1);
  EXPECT_EQ(portable::sin(0x1.b549d86aa6bp+29), 0x1.ff9e265adbe3cp-1);
  EXPECT_EQ(portable::asin(0.7), 0x1.8d00e692afd95p-1);
  EXPECT_EQ(portable::atan2(1, 3), 0x1.4978fa3269ee1p-2);
  EXPECT_EQ(portable::atan2(-2, -7), -0x1.6e8062854db5ep+1);
  EXPECT_EQ(portable::exp(1), 0x1.5bf0a8b14576ap+1);
  EXPECT_EQ(portable::log(10), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(portable::pow(1.1, 2.4), 0x1.41cc1c85f4457p+0);
}

}  // namespace
}  // namespace flatray
