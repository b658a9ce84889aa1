#include "geom/turn.h"

#include <gtest/gtest.h>

#include <numbers>

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

TEST(Turn, OtherAnglesAreThoseOfTheFunctions) {
  const Turn third = turn(std::numbers::pi / 3);
  EXPECT_NEAR(third.cos, 0.5, 1e-15);
  EXPECT_NEAR(third.sin, std::numbers::sqrt3 / 2, 1e-15);
}

}  // namespace
}  // namespace flatray
