#include "render/gradient.h"

#include <gtest/gtest.h>

#include "image/srgb.h"
#include "oracle/families.h"
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

// Of any length, and wherever they are, they have their last colour beyond their end.
TEST(Gradients, HaveTheirLastColourBeyondTheirEndHoweverShort) {
  Film size;
  size.width = size.height = 8;
  FrameState state;
  state.window = {{0, 0}, {8, 8}};
  const FilmTransform film(size, state);
  for (const double length : {1.0, 0x1p-60, 0x1p-200, 0x1p-600, 0x1p-1000})
    for (const bool radial : {false, true}) {
      Gradient gradient;
      gradient.radial = radial;
      gradient.from = {4, 4};
      gradient.along = {0.6 * length, 0.8 * length};
      gradient.stops = {{0, {0, 0, 0}}, {1, {255, 255, 255}}};
      const FilmGradient there = film_gradient(gradient, pose({0, 0}, 0), film);
      const GradientPainter painter(there);
      EXPECT_EQ(painter.at({7, 1})[0], 1) << length;
      EXPECT_EQ(painter.at({4, 4})[0], 0) << length;
      EXPECT_EQ(painter.at({1, 6})[0], radial ? 1 : 0) << length;
    }
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

// Items that cover all of a pixel or some of its quarters from left to right: its light is the mean of
// four pictures, in each of which the items of one quarter cover all.
TEST(Layers, AStackIsTheMeanOfWhatItsQuartersShow) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    oracle::Draw draw(seed, 0, 0);
    const int count = draw.whole(2, 13);
    std::vector<DrawItem> stack;
    std::array<std::vector<DrawItem>, 4> quarters;
    std::uint32_t layer = 0;
    for (int i = 0; i < count; ++i) {
      const int from = draw.whole(0, 4), to = draw.whole(from + 1, 5);
      const bool whole = draw.whole(0, 2) == 1, opaque = draw.whole(0, 10) == 0;
      std::array<float, 4> colour{};
      for (float& channel : colour) channel = static_cast<float>(draw.unit());
      if (draw.whole(0, 4) == 0) ++layer;
      const auto item = [&](double low, double high) {
        DrawItem made{coverage_check::box_path(low, 0, high, 8),
                      {colour[0], colour[1], colour[2], opaque ? 1 : colour[3]}};
        made.layer = layer % 2 == 0 ? 0 : layer;
        made.opacity = made.layer == 0 ? 1 : 0.5F;
        return made;
      };
      stack.push_back(whole ? item(0, 8) : item(4 + 0.25 * from, 4 + 0.25 * to));
      for (int quarter = 0; quarter < 4; ++quarter)
        if (whole || (from <= quarter && quarter < to))
          quarters[static_cast<std::size_t>(quarter)].push_back(item(0, 8));
    }
    const auto light = [](std::vector<DrawItem> items, std::size_t channel) {
      const LinearImage picture = render_linear(over_white(std::move(items)), {});
      return static_cast<double>(picture.pixels[3 * (8 * 4 + 4) + channel]);
    };
    for (std::size_t c = 0; c < 3; ++c) {
      double mean = 0;
      for (const std::vector<DrawItem>& items : quarters) mean += 0.25 * light(items, c);
      EXPECT_NEAR(light(stack, c), mean, 0x1p-20) << seed;
    }
  }
}

}  // namespace
}  // namespace flatray
