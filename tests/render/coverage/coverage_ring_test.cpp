#include <gtest/gtest.h>

#include <cmath>

#include "render/scan_region.h"

namespace flatray {
namespace {

constexpr double kRingPi = 3.14159265358979323846;

TEST(RingCoverage, ThePixelsSumToTheArea) {
  for (const double r : {0.2, 0.7, 1.0, 3.3, 9.5}) {
    const double edge_pixels = 8 * (r + 2);
    const Steps disc = steps_of(FillRing{{10.3, 10.1}, r}, {0, 0, 21, 21});
    EXPECT_NEAR(covered_area(disc), kRingPi * r * r, edge_pixels / kFullCoverage) << r;
    const Steps ring = steps_of(FillRing{{10.3, 10.1}, r, 0.5 * r}, {0, 0, 21, 21});
    EXPECT_NEAR(covered_area(ring), 0.75 * kRingPi * r * r, 2 * edge_pixels / kFullCoverage) << r;
  }
}

TEST(RingCoverage, AMirroredDiscHasMirroredCoverage) {
  const PixelBox box{0, 0, 20, 20};
  for (const double r : {0.31, 2.0, 6.37, 9.99}) {
    const Steps steps = steps_of(FillRing{{7.25, 8.5}, r, 0.3 * r}, box);
    const Steps across = steps_of(FillRing{{12.75, 8.5}, r, 0.3 * r}, box);
    const Steps down = steps_of(FillRing{{7.25, 11.5}, r, 0.3 * r}, box);
    for (std::size_t y = 0; y < 20; ++y)
      for (std::size_t x = 0; x < 20; ++x) {
        ASSERT_NEAR(steps[y * 20 + x], across[y * 20 + 19 - x], 1) << r;
        ASSERT_NEAR(steps[y * 20 + x], down[(19 - y) * 20 + x], 1) << r;
      }
  }
}

// The area under the arc x = cx + sqrt(r^2 - (y - cy)^2) in a pixel, by Simpson's rule on 4096
// parts: for an arc without ends in the pixel its error is far below a step.
TEST(RingCoverage, ALargeArcIsWithinAStepOfQuadrature) {
  for (const double r : {50.0, 1e3, 1e5, 1e7}) {
    const Vec2 centre(0.4 - r, 0.5);  // the arc passes x = 0.4 and hardly bends in one row
    const auto x = [&](double y) {
      const double d = y - centre.y();
      return 0.4 - d * d / (r + std::sqrt((r - d) * (r + d)));
    };
    double sum = 0;
    constexpr int kParts = 4096;
    for (int i = 0; i < kParts; ++i) {
      const double a = static_cast<double>(i) / kParts, b = (i + 1.0) / kParts;
      sum += (x(a) + 4 * x(0.5 * (a + b)) + x(b)) / (6 * kParts);
    }
    const Steps steps = steps_of(FillRing{centre, r}, {0, 0, 2, 1});
    EXPECT_NEAR(steps[0], kFullCoverage * sum, 1.0) << r;
    EXPECT_EQ(steps[1], 0U);
  }
}

TEST(RingCoverage, AnyCropGivesTheSamePixels) {
  const FillRing ring{{9.7, 10.2}, 8.4, 3.9};
  const Steps whole = steps_of(ring, {0, 0, 20, 20});
  const Steps part = steps_of(ring, {5, 3, 9, 7});
  for (std::size_t y = 0; y < 7; ++y)
    for (std::size_t x = 0; x < 9; ++x) ASSERT_EQ(part[y * 9 + x], whole[(y + 3) * 20 + x + 5]);
}

TEST(StiffCases, B13OddCirclesAreDrawnOrNothing) {
  const PixelBox box{0, 0, 4, 4};
  EXPECT_EQ(covered_area(steps_of(FillRing{{2, 2}, 0}, box)), 0);
  EXPECT_EQ(covered_area(steps_of(FillRing{{2, 2}, 5e-324}, box)), 0);
  EXPECT_EQ(covered_area(steps_of(FillRing{{2, 2}, 1e308}, box)), 16);
  EXPECT_EQ(covered_area(steps_of(FillRing{{2, 2}, 1e308, 1e307}, box)), 0);
}

}  // namespace
}  // namespace flatray
