#include "study/statistics/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/plots/plot.h"
#include "study/rooms/starts.h"
#include "study/rooms/wall_places.h"
#include "study/texts.h"

namespace flatray {
namespace {

// x = 1, 2, 3, 4 over y = 1: mean 2.5, standard error of the mean sqrt(5/3 / 4).
TEST(RatioSums, OfConstantWeightsAreAMean) {
  RatioSums sums;
  for (const double x : {1.0, 2.0, 3.0, 4.0}) sums.add(x, 1);
  EXPECT_EQ(sums.ratio(), 2.5);
  EXPECT_NEAR(sums.standard_error(), std::sqrt(5.0 / 12), 1e-15);
}

TEST(RatioSums, OfProportionalSamplesHaveNoError) {
  RatioSums sums, half;
  for (const double y : {1.0, 5.0, 9.0}) sums.add(3 * y, y);
  EXPECT_EQ(sums.ratio(), 3);
  EXPECT_EQ(sums.standard_error(), 0);
  add(sums_of(half), numbers_of(sums_of(sums)));
  EXPECT_EQ(half.ratio(), 3);
}

// Found by a reviewer: 32 sums that differ in their last digits, of which squares of the sums keep nothing.
TEST(RatioSums, AroundTheirRatioKeepASpreadOfTheLastDigits) {
  RatioSums sums{.about = 1e8};
  for (int i = 0; i < 16; ++i) sums.add(1e8 + i % 2, 1);
  EXPECT_EQ(sums.ratio(), 1e8 + 0.5);
  EXPECT_NEAR(sums.standard_error(), std::sqrt(0.25 / 15), 1e-9);
  const StartSums spread = [] {
    StartSums made(Starts::quasi);
    for (std::uint64_t i = 0; i < 64; ++i) made.add(i, 1e8 + static_cast<double>(i % 2), 1);
    return made;
  }();
  EXPECT_NEAR(spread.all().standard_error(), std::sqrt(0.25 / 31), 1e-9);
}

// Found by a reviewer: the cubes of such numbers are infinite, and their skewness was taken for none.
TEST(RatioSums, OfNumbersWhoseCubesAreNoDoublesHaveNoError) {
  RatioSums sums;
  for (int i = 0; i < 20; ++i) sums.add(i == 0 ? 1e110 : 1, 1);
  EXPECT_FALSE(sums.measure("m").standard_error);
}

TEST(Agreement, IsWithinFourStandardErrors) {
  EXPECT_TRUE(agrees({"m", 1.0, 0.1}));
  EXPECT_TRUE(agrees({"m", 1.39, 0.1, 1.0}));
  EXPECT_FALSE(agrees({"m", 1.41, 0.1, 1.0}));
  EXPECT_FALSE(agrees({"m", 1.0, 0, 2.0}));
}

// Found by a reviewer: of few orbits, right numbers were said to disagree.
TEST(Agreement, OfFewOrSkewedPartsIsWider) {
  const std::pair<double, double> quantiles[] = {{15, 5.44}, {31, 4.62}, {100, 4.178}};
  for (const auto& [freedom, t] : quantiles)
    EXPECT_NEAR(allowed_errors(freedom), t, 0.01 * t) << freedom;
  EXPECT_NEAR(allowed_errors(kInfinity), kAllowedErrors, 1e-6);
  EXPECT_TRUE(agrees({"m", 1.54, 0.1, 1.0, 15}));
  EXPECT_FALSE(agrees({"m", 1.56, 0.1, 1.0, 15}));
  Measure skewed{"m", 1.5, 0.1, 1.0};
  EXPECT_FALSE(agrees(skewed));
  skewed.widening = 1.3;
  EXPECT_TRUE(agrees(skewed));
}

// Found by a reviewer: the interval was of no width, and the truth outside of it.
TEST(RatioSums, OfGroupsWithEqualSharesHaveAnErrorYet) {
  StartSums equal(Starts::quasi);
  for (std::uint64_t i = 0; i < 10 * kShifts; ++i) equal.add(i, i < 3 * kShifts ? 1 : 0, 1);
  Measure share = equal.all().share("m");
  EXPECT_EQ(share.value, 0.3);
  EXPECT_EQ(share.standard_error, 2 / (10.0 * kShifts));
  share.expected = 0.31;
  EXPECT_TRUE(agrees(share));
}

TEST(WallPlaces, GoRoundASquareAndACircle) {
  Surfaces walls;
  walls.add(Segment{{1, 0}, {1, 2}});
  walls.add(Circle{{0, 0}, 2});
  EXPECT_EQ(WallPlaces(walls).length(0), 2);
  EXPECT_EQ(WallPlaces(walls).position(0, {1, 0.5}), 0.5);
  EXPECT_EQ(WallPlaces(walls).point(0, 0.5), Vec2(1, 0.5));
  EXPECT_EQ(wall_normal(walls, 0, {1, 1}), Vec2(-1, 0));
  EXPECT_EQ(curvature(walls, 0, {1, 1}, {-1, 0}), 0);
  const double quarter = WallPlaces(walls).length(1) / 4;
  EXPECT_NEAR(WallPlaces(walls).position(1, {0, -2}), 3 * quarter, 1e-14);
  EXPECT_NEAR((WallPlaces(walls).point(1, quarter) - Vec2(0, 2)).norm(), 0, 1e-15);
  EXPECT_EQ(curvature(walls, 1, {0, 2}, {0, 1}), 0.5);
  EXPECT_EQ(curvature(walls, 1, {0, 2}, {0, -1}), -0.5);
}

TEST(SvgPlot, IsWellFormedWhateverItIsGiven) {
  for (const bool log : {false, true}) {
    Plot plot{"a < b & \"c\"", "x", "y", {}, log};
    EXPECT_TRUE(testing::is_well_formed(svg(plot)));
    plot.series.push_back({"one", {{1, 0}}, true});
    plot.series.push_back({"<two>", {{1, kInfinity}, {2, -3, 1}, {3, 1e300}, {4, 1e-300}}});
    EXPECT_TRUE(testing::is_well_formed(svg(plot)));
    EXPECT_FALSE(testing::has(svg(plot), "nan"));
  }
}

}  // namespace
}  // namespace flatray
