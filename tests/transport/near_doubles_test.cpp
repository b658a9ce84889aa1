#include "transport/near_doubles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace flatray {
namespace {

TEST(NearDoubles, AStepIsTheNextDoubleAlsoThroughZero) {
  for (const double x : {1.0, -1.0, 0x1p-1022, 1e308, -0.3, 0.0, 5e-324})
    for (int k = -3; k <= 3; ++k) {
      double expected = x;
      for (int i = 0; i < std::abs(k); ++i) expected = std::nextafter(expected, k * HUGE_VAL);
      EXPECT_EQ(step_ulps(x, k), expected);
    }
  EXPECT_FALSE(std::signbit(step_ulps(-5e-324, 1)));
  EXPECT_EQ(step_ulps(std::numeric_limits<double>::max(), 2), HUGE_VAL);
}

TEST(NearDoubles, AreTriedNearestFirstWhateverTheUlpsOfBothCoordinates) {
  for (const Vec2& centre : {Vec2(1, 1), Vec2(1, 2), Vec2(-3, 0.2), Vec2(1e-9, 5), Vec2(0, 1),
                             Vec2(1e300, 1e-300), Vec2(0, 0), Vec2(7, -7.5)}) {
    const auto ulp = [](double x) { return std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x); };
    const double unit = std::max(ulp(centre.x()), ulp(centre.y()));
    std::set<std::pair<int, int>> seen{{0, 0}};
    long double last = 0;
    for (const UlpSteps& step : steps_about(centre)) {
      const long double x = step.x * static_cast<long double>(ulp(centre.x()) / unit),
                        y = step.y * static_cast<long double>(ulp(centre.y()) / unit);
      EXPECT_GE(x * x + y * y, last);
      last = x * x + y * y;
      seen.insert({step.x, step.y});
    }
    EXPECT_EQ(seen.size(), 25);
  }
}

TEST(NearDoubles, TheFirstAcceptedIsGivenAndNoneBeyondTwoUlps) {
  const Vec2 centre(0.5, 3);
  EXPECT_EQ(nearest_double(centre, [](const Vec2&) { return true; }), centre);
  const double up = std::nextafter(0.5, 1);
  EXPECT_EQ(nearest_double(centre, [](const Vec2& p) { return p.x() > 0.5; }), Vec2(up, 3));
  EXPECT_FALSE(nearest_double(centre, [](const Vec2& p) { return p.x() > 0.5 + 0x1p-51; }));
}

TEST(NearDoubles, NoneIsInfinite) {
  constexpr double kMax = std::numeric_limits<double>::max();
  const auto any = [](const Vec2&) { return true; };
  EXPECT_FALSE(nearest_double(Vec2(-kMax, 1), [](const Vec2& p) { return p.x() < -kMax; }));
  EXPECT_EQ(nearest_double(Vec2(HUGE_VAL, 1), any), Vec2(kMax, 1));
}

}  // namespace
}  // namespace flatray
