#include "study/plots/line_density.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "base/philox.h"
#include "geom/clip.h"
#include "image/srgb.h"
#include "study/plots/palette.h"

namespace flatray {
namespace {

const Bounds kWindow{{-1, 2}, {7, 6}};  // of 8 x 4

TEST(LineDensity, CountsFromTheTopLeft) {
  LineDensity density(kWindow, 8, 4);
  density.add({-0.5, 5.5}, {2.25, 5.5});
  const std::vector<double>& cells = density.cells();
  const double shares[] = {0.5, 1, 1, 0.25, 0};
  for (std::size_t x = 0; x < 5; ++x) EXPECT_NEAR(cells[x], shares[x], 1e-15);
  EXPECT_NEAR(std::accumulate(cells.begin(), cells.end(), 0.0), 2.75, 1e-14);
  LineDensity down(kWindow, 8, 4);
  down.add({0.5, 9}, {0.5, 2.5});
  for (unsigned y = 0; y < 4; ++y) EXPECT_NEAR(down.cells()[8U * y + 1], y == 3 ? 0.5 : 1, 1e-15);
}

// Each cell has the part of the way that clipping to it leaves.
TEST(LineDensity, OfACellIsTheLengthInside) {
  constexpr int kWidth = 16, kHeight = 12;  // cells of 1/2 by 1/3
  for (std::uint32_t i = 0; i < 200; ++i) {
    const auto draw = [&](std::uint32_t k) {
      return 12 * unit_double(random_bits(4, Stream::test, 8, i, k));
    };
    const Vec2 from(draw(0) - 3, draw(1) - 2), to(draw(2) - 3, draw(3) - 2);
    LineDensity density(kWindow, kWidth, kHeight);
    density.add(from, to);
    const Vec2 a((from.x() + 1) * 2, (6 - from.y()) * 3), b((to.x() + 1) * 2, (6 - to.y()) * 3);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const std::array<Vec2, 4> cell = {Vec2(x, y), Vec2(x + 1, y), Vec2(x + 1, y + 1),
                                          Vec2(x, y + 1)};
        const HitInterval part = clip_convex({a, b - a}, cell, kSegment);
        const double inside = part ? (part.t_exit - part.t_enter) * (b - a).norm() : 0;
        ASSERT_NEAR(density.cells()[static_cast<std::size_t>(y * kWidth + x)], inside, 1e-12);
      }
  }
}

TEST(LineDensity, AddsUpAndIsBrightestWhereMostIs) {
  LineDensity one(kWindow, 8, 4), two(kWindow, 8, 4);
  for (int i = 0; i < 9; ++i) one.add({0.5, 2}, {0.5, 6});
  two.add({-1, 3.5}, {7, 3.5});
  one.add_cells(two.cells());
  EXPECT_EQ(one.cells()[8 * 2 + 1], 10);
  EXPECT_EQ(one.cells()[8 * 2 + 5], 1);
  const Image picture = one.picture();
  const auto light = [&](int x, int y) {
    return picture.at(x, y)[0] + picture.at(x, y)[1] + picture.at(x, y)[2];
  };
  EXPECT_GT(light(1, 2), light(1, 0) - 1);
  EXPECT_GT(light(1, 0), light(5, 2));
  EXPECT_GT(light(5, 2), 0);
  EXPECT_EQ(light(5, 1), 0);
  // What is lit has a mean of 0.7 before it is bent by 1 - exp.
  LineDensity even(kWindow, 8, 4);
  even.add({-1, 3.5}, {7, 3.5});
  EXPECT_EQ(even.picture().at(3, 2)[0],
            srgb_from_linear(static_cast<float>(heat(1 - std::exp(-0.7)).r)));
  EXPECT_EQ(even.picture().at(3, 2)[1],
            srgb_from_linear(static_cast<float>(heat(1 - std::exp(-0.7)).g)));
}

void expect_light(const LinearRgb& light, double r, double g, double b) {
  EXPECT_NEAR(light.r, r, 1e-12);
  EXPECT_NEAR(light.g, g, 1e-12);
  EXPECT_NEAR(light.b, b, 1e-12);
}

TEST(Palette, HuesGoRoundFromRedOverGreenAndBlue) {
  for (const double turn : {0.0, 1.0, -3.0}) {
    expect_light(hue(turn), 1, 0, 0);
    expect_light(hue(turn + 1.0 / 6), 1, 1, 0);
    expect_light(hue(turn + 1.0 / 3), 0, 1, 0);
    expect_light(hue(turn + 0.5), 0, 1, 1);
    expect_light(hue(turn + 2.0 / 3), 0, 0, 1);
    expect_light(hue(turn + 0.75), 0.5, 0, 1);
  }
  expect_light(hue_of({2, 0}), 1, 0, 0);
  expect_light(hue_of({0, 3}), 0.5, 1, 0);
  expect_light(hue_of({-1, 0}), 0, 1, 1);
  expect_light(hue_of({0, -1}), 0.5, 0, 1);
}

TEST(Palette, HeatGoesFromBlackOverRedAndYellowToWhite) {
  expect_light(heat(0), 0, 0, 0);
  expect_light(heat(1.0 / 6), 0.5, 0, 0);
  expect_light(heat(0.5), 1, 0.5, 0);
  expect_light(heat(5.0 / 6), 1, 1, 0.5);
  expect_light(heat(2), 1, 1, 1);
}

// Of the first dozen colours each is a good way from all before it.
TEST(Palette, ColoursOfNeighboursAreFarApart) {
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const LinearRgb a = nth_colour(i), b = nth_colour(k);
      EXPECT_GT(std::fabs(a.r - b.r) + std::fabs(a.g - b.g) + std::fabs(a.b - b.b),
                i - k == 1 ? 1 : 0.2)
          << i << " " << k;
    }
}

}  // namespace
}  // namespace flatray
