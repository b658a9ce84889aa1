#include "render/gradient.h"

#include <gtest/gtest.h>

#include "image/srgb.h"
#include "render/coverage_families.h"
#include "render/frame.h"

namespace flatray {
namespace {

FilmGradient black_to_white(bool radial) {
  FilmGradient gradient;
  gradient.radial = radial;
  gradient.origin = {2, 0};
  gradient.axis = {0.125, 0};
  gradient.per_pixel = 0.125;
  gradient.stops = {{0, {0, 0, 0, 1}}, {1, {1, 1, 1, 1}}};
  return gradient;
}

TEST(Gradients, RunFromTheFirstStopToTheLastAndGoOn) {
  const FilmGradient linear = black_to_white(false), radial = black_to_white(true);
  EXPECT_EQ(GradientPainter(linear).at({-5, 3})[0], 0);
  EXPECT_EQ(GradientPainter(linear).at({4, 7})[0], 0.25F);
  EXPECT_EQ(GradientPainter(linear).at({50, 3})[0], 1);
  EXPECT_EQ(GradientPainter(radial).at({2, -4})[0], 0.5F);
  EXPECT_EQ(GradientPainter(radial).at({-6, 0})[0], 1);
}

TEST(Gradients, ClearStopsFadeAndDoNotDarken) {
  FilmGradient gradient = black_to_white(false);
  gradient.stops = {{0, {1, 0, 0, 1}}, {1, {0, 0, 0, 0}}};
  const std::array<float, 4> half = GradientPainter(gradient).at({6, 0});
  EXPECT_EQ(half, (std::array<float, 4>{0.5F, 0, 0, 0.5F}));  // still pure red
}

TEST(Gradients, TwoStopsAtOnePlaceAreAnEdge) {
  FilmGradient gradient = black_to_white(false);
  gradient.stops = {{0.5, {0, 0, 0, 1}}, {0.5, {1, 1, 1, 1}}};
  EXPECT_EQ(GradientPainter(gradient).at({5.999, 0})[0], 0);
  EXPECT_EQ(GradientPainter(gradient).at({6, 0})[0], 1);
}

DrawList over_white(std::vector<DrawItem> items) {
  return {8, 8, {1, 1, 1, 1}, Coverage::area, std::move(items)};
}

DrawItem square(double low, double high, const LinearColour& colour) {
  return {coverage_check::box_path(low, low, high, high), colour};
}

TEST(Layers, ItemsOfOneLayerAreFadedAsOnePicture) {
  DrawItem fill = square(0, 6, {1, 0, 0, 1}), line = square(2, 8, {0, 0, 1, 1});
  fill.layer = line.layer = 1;
  fill.opacity = line.opacity = 0.25F;
  const LinearImage picture = render_linear(over_white({fill, line}), {});
  const auto pixel = [&](std::size_t x, std::size_t y) {
    return picture.pixels.data() + 3 * (8 * y + x);
  };
  EXPECT_EQ(pixel(1, 1)[0], 1);
  EXPECT_EQ(pixel(1, 1)[2], 0.75F);
  EXPECT_EQ(pixel(4, 4)[0], 0.75F);  // where both lie, the upper one alone is seen
  EXPECT_EQ(pixel(4, 4)[2], 1);
  EXPECT_EQ(pixel(7, 1)[0], 1);
}

TEST(Layers, WhatLiesInNoLayerIsHiddenByNoFadedItem) {
  DrawItem below = square(0, 8, {0, 1, 0, 1});
  DrawItem a = square(0, 8, {1, 0, 0, 1}), b = square(0, 8, {0, 0, 1, 1});
  a.layer = b.layer = 3;
  a.opacity = b.opacity = 0.5F;
  const Image pruned = render_image(over_white({below, a, b}), {});
  FrameOptions all;
  all.keep_all = true;
  const Image whole = render_image(over_white({below, a, b}), all);
  EXPECT_EQ(pruned.pixels, whole.pixels);
  EXPECT_EQ(pruned.at(3, 3)[1], srgb_from_linear(0.5F));
}

}  // namespace
}  // namespace flatray
