// needs: shapes/segment
#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "scene/scene_text.h"
#include "study/accuracy/linear_error.h"
#include "study/stability/margins.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

double draw(std::uint32_t number, std::uint32_t k) {
  return unit_double(random_bits(6, Stream::test, 9, number, k));
}

// The ratio of means and its error, from the samples themselves: residuals x - r y over the mean of y.
TEST(RatioSums, InPartsAreThoseOfAll) {
  RatioSums parts[3], joined;
  double x = 0, y = 0;
  constexpr std::uint32_t kSamples = 60;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    parts[i % 3].add(1 + draw(i, 0), 2 + draw(i, 1));
    x += 1 + draw(i, 0), y += 2 + draw(i, 1);
  }
  for (RatioSums& part : parts) add(sums_of(joined), numbers_of(sums_of(part)));
  EXPECT_NEAR(joined.ratio(), x / y, 1e-14);
  double squares = 0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const double off = 1 + draw(i, 0) - x / y * (2 + draw(i, 1));
    squares += off * off;
  }
  const double error = std::sqrt(squares / (kSamples - 1) / kSamples) / (y / kSamples);
  EXPECT_NEAR(joined.standard_error(), error, 1e-12 * error + 1e-14);
}

TEST(Agreement, IsHeldAgainstTheError) {
  EXPECT_FALSE(agrees({"m", 1 + 1e-9, 0, 1.0})) << "without an error only rounding is forgiven";
  EXPECT_TRUE(agrees({"m", 1 + 1e-13, 0, 1.0}));
  EXPECT_TRUE(agrees({"m", 7, 0}));
  EXPECT_FALSE(agrees({"m", -1.41, 0.1, -1.0}));
}

TEST(LinearError, IsTheRootOfTheMeanSquare) {
  LinearImage a, b;
  a.pixels = {0, 0, 0, 0, 0, 0};
  b.pixels = {3, 0, 0, 0, -3, 0};
  EXPECT_DOUBLE_EQ(rms_difference(a.pixels, b.pixels), std::sqrt(3.0));
  EXPECT_EQ(rms_difference(b.pixels, b.pixels), 0);
}

std::vector<Margin> margins_in(const std::string& scene, std::uint64_t count) {
  const std::string film = "flatray = 1\nfilm = { size = [16, 16], world = [[0, 0], [1, 1]] }\n";
  return margins(loaded(film + scene).scene, 1, count);
}

// A ray ends at the wall it meets: it comes no nearer to what is behind than that wall does.
TEST(Margins, OfRandomRaysEndAtTheWallTheyMeet) {
  const std::string walls =
      "[[entity]]\nname = \"wall\"\nshape = { segment = { from = [1.5, -1000], to = [1.5, 1000] } "
      "}\n"
      "[[entity]]\nname = \"hidden\"\nshape = { segment = { from = [3, 0.25], to = [3, 0.75] } }\n"
      "[[entity]]\nname = \"left\"\nshape = { segment = { from = [-2, 0.25], to = [-2, 0.75] } }\n";
  std::size_t left = 0;
  for (const Margin& margin : margins_in(walls, 2000)) {
    if (margin.wall == "hidden edge 0") {
      EXPECT_GE(margin.distance, 1.5) << margin.ray;
    }
    left += margin.wall == "left edge 0" ? 1 : 0;
    if (margin.wall == "left edge 0") {
      EXPECT_TRUE(margin.at == Vec2(-2, 0.25) || margin.at == Vec2(-2, 0.75));
      EXPECT_EQ(margin.ulps, margin.distance / (1000 * 0x1p-52));
    }
  }
  EXPECT_GT(left, 0U);
}

// Both ends of a wall: the nearer one is told.
TEST(Margins, TellTheNearerEnd) {
  for (const double y : {0.125, 0.875}) {
    const auto all = margins_in(
        "[[entity]]\nmaterial = \"mirror\"\nshape = { segment = { from = [3, 0], to = [3, 1] } }\n"
        "[[ray]]\nat = [0, " +
            std::to_string(y) + "]\ndirection = [1, 0]\nbounces = 1\n",
        1);
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all[0].at, Vec2(3, y < 0.5 ? 0 : 1));
    EXPECT_EQ(all[0].distance, 0.125);
    EXPECT_EQ(all[0].ray, "ray 1");
    EXPECT_EQ(all[0].wall, "entity 1 edge 0");
    EXPECT_EQ(all[0].leg, 0U);
  }
}

}  // namespace
}  // namespace flatray
