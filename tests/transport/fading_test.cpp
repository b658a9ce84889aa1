// What is left of light after a length, and its mean, against other functions.
#include <gtest/gtest.h>

#include <cmath>

#include "transport/light/bodies.h"

namespace flatray {
namespace {

TEST(Fading, IsExpAndItsMeanForDepthsOfAnySize) {
  for (double depth = 1e-18; depth < 600; depth *= 1.07) {
    const Fading made = fading(depth / 8, 8);
    EXPECT_NEAR(made.left / std::exp(-depth), 1, 1e-12) << depth;
    EXPECT_NEAR(made.mean / (-std::expm1(-depth) / depth), 1, 1e-12) << depth;
  }
  EXPECT_EQ(fading(0, 1e300).left, 1);
  EXPECT_EQ(fading(0, 1e300).mean, 1);
  EXPECT_EQ(fading(1e30, 1e300).left, 0);
  EXPECT_EQ(fading(1e30, 1e300).mean, 0);
}

}  // namespace
}  // namespace flatray
