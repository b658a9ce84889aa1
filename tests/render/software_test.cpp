#include <gtest/gtest.h>

#include "render/coverage/stroke.h"
#include "render/coverage_families.h"
#include "render/frame.h"

namespace flatray {
namespace {

using coverage_check::box_path;
using coverage_check::Draws;
using coverage_check::Family;
using coverage_check::kFamilies;
using coverage_check::make_region;
using coverage_check::ring_path;

DrawList mixed_list(int width, int height) {
  DrawList list;
  list.width = width;
  list.height = height;
  list.background = {0.9F, 0.8F, 0.7F, 1};
  for (std::uint64_t item = 0; item < 60; ++item) {
    Draws draws(21, item);
    const auto shade = [&] { return static_cast<float>(draws.unit()); };
    FillPath path = make_region(kFamilies[item % kFamilies.size()], 21, item).path;
    const double scale = 1 + 12 * draws.unit();
    const Vec2 at(draws.unit() * width, draws.unit() * height);
    for (Segment& edge : path.edges) edge = {at + scale * edge.a, at + scale * edge.b};
    // Scaling rounds: what was simple may be so no more.
    path.simple = false;
    list.items.push_back({std::move(path), {shade(), shade(), shade(), item % 3 ? 1.0F : shade()}});
    const double r = 20 * draws.unit();
    list.items.push_back(
        {FillRing{at, r, item % 2 ? 0.6 * r : -1}, {shade(), shade(), shade(), 0.5F}});
  }
  return list;
}

TEST(Software, ThreadsDoNotChangeAPixel) {
  const DrawList list = mixed_list(301, 233);
  const Image one = render_image(list, {std::nullopt, 1});
  for (const unsigned threads : {2U, 3U, 7U})
    EXPECT_EQ(render_image(list, {std::nullopt, threads}), one) << threads;
}

TEST(Software, ACropIsThatPartOfTheFrame) {
  for (const Coverage mode : {Coverage::area, Coverage::centre}) {
    DrawList list = mixed_list(301, 233);
    list.coverage = mode;
    const Image whole = render_image(list, {});
    const PixelBox crop{57, 31, 111, 97};
    const Image part = render_image(list, {crop, 2});
    for (int y = 0; y < crop.height; ++y)
      for (int x = 0; x < crop.width; ++x)
        for (int c = 0; c < 3; ++c)
          ASSERT_EQ(part.at(x, y)[c], whole.at(x + crop.x, y + crop.y)[c]) << x << ' ' << y;
  }
}

// Strokes that overlap themselves and run far beyond the film, some of them nearly level.
DrawList strokes(std::uint64_t seed, Coverage coverage, int rows) {
  DrawList list{150, 70, {1, 1, 1, seed % 2 == 0 ? 1.0F : 0.0F}, coverage, {}, rows};
  for (std::uint64_t item = 0; item < 30; ++item) {
    Draws draws(seed, item);
    const auto shade = [&] { return static_cast<float>(draws.unit()); };
    Chain chain;
    for (int i = 0; i < 5; ++i)
      chain.points.emplace_back(600 * draws.unit() - 225, 70 * draws.unit() - 20 + (i % 2));
    FillPath path;
    add_line(chain, {0.3 + 5 * draws.unit(), LineJoin::miter, LineCap::butt}, path.edges);
    list.items.push_back({std::move(path), {shade(), shade(), shade(), item % 5 ? 1.0F : shade()}});
  }
  return list;
}

// When all is kept, nothing is settled before the last item is known; of a crop, edges right of it
// are left out.
TEST(Software, WhatIsHiddenOrBesideTheCropChangesNoPixel) {
  const PixelBox crop{40, 9, 45, 50};
  for (std::uint64_t seed = 0; seed < 60; ++seed)
    for (const Coverage coverage : {Coverage::area, Coverage::rows, Coverage::centre}) {
      const DrawList list = strokes(seed, coverage, seed % 3 ? 4 : 3);
      const Image whole = render_image(list, {}), part = render_image(list, {crop, 1});
      EXPECT_EQ(whole, render_image(list, {std::nullopt, 1, true})) << seed;
      bool same = true;
      for (int y = 0; y < crop.height; ++y)
        same = same && std::equal(part.at(0, y), part.at(0, y) + crop.width * part.channels,
                                  whole.at(crop.x, crop.y + y));
      EXPECT_TRUE(same) << seed;
    }
}

// Opaque triangles, more than are told apart in a pixel, boxes that end on the border between its two
// columns, and some that hide pixels left of it.
DrawList crowd(std::uint64_t seed) {
  DrawList list{2, 4, {0, 0, 0, 1}, Coverage::area, {}};
  Draws draws(seed, 7);
  for (int i = 0; i < 120; ++i) {
    const auto at = [&] { return Vec2(2 * draws.unit(), 4 * draws.unit()); };
    std::vector<Vec2> ring{at(), at(), at()};
    if (i % 2 == 1) {
      const double low = i % 4 == 1 ? ring[0].y() : std::floor(ring[0].y());
      const double high = i % 4 == 1 ? low + 0.3 : low + 1;
      ring = {{0, low}, {1, low}, {1, high}, {0, high}};
    }
    const auto level = [&] { return static_cast<float>(draws.unit()); };
    list.items.push_back({ring_path(ring, false), {level(), level(), level(), 1}});
  }
  return list;
}

TEST(Software, CrowdedPixelsDependOnNoNeighbourAndOnNothingHidden) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const DrawList list = crowd(seed);
    const LinearImage whole = render_linear(list, {});
    EXPECT_EQ(whole.pixels, render_linear(list, {std::nullopt, 1, true}).pixels) << seed;
    for (int row = 0; row < list.height; ++row) {
      const LinearImage part = render_linear(list, {PixelBox{0, row, 2, 1}, 1});
      EXPECT_TRUE(
          std::equal(part.pixels.begin(), part.pixels.end(), whole.pixels.begin() + 6 * row))
          << seed << ", row " << row;
    }
    const LinearImage right = render_linear(list, {PixelBox{1, 0, 1, 4}, 1});
    for (std::size_t row = 0; row < 4; ++row)
      EXPECT_TRUE(std::equal(&right.pixels[3 * row], &right.pixels[3 * row] + 3,
                             &whole.pixels[6 * row + 3]))
          << seed << ", row " << row;
  }
}

// The same edges cut the pixel again and again, and rounding makes corners beside them.
TEST(Software, CopiesOfAThinTriangleShowTheUppermost) {
  const FillPath path = ring_path({{0.03397714339507729, 0.5869348547752509},
                                   {0.2003213380365878, 1},
                                   {0.19910809822022202, 1}},
                                  false);
  DrawList list{1, 1, {0, 0, 0, 1}, Coverage::area, {}};
  for (const float level : {0.2F, 0.4F, 0.6F, 0.8F})
    list.items.push_back({path, {level, level, level, 1}});
  const double area = steps_of(path, {0, 0, 1, 1})[0] / 64770.0;
  EXPECT_NEAR(static_cast<double>(render_linear(list, {}).pixels[0]), 0.8 * area, 1e-5);
}

TEST(Software, ManyEdgesAreSortedIntoBandsWithoutLosingOne) {
  // One star of 400 edges through all bands against the same edges scanned at once.
  std::vector<Vec2> ring;
  Draws draws(4, 4);
  for (int i = 0; i < 400; ++i) ring.push_back({draws.unit() * 700, draws.unit() * 500});
  FillPath path = ring_path(ring, false);
  path.rule = FillRule::even_odd;
  DrawList list{700, 500, {0, 0, 0, 1}, Coverage::area, {{path, {1, 1, 1, 1}}}};
  const LinearImage picture = render_linear(list, {std::nullopt, 2});
  const auto steps = steps_of(path, {0, 0, 700, 500});
  for (std::size_t i = 0; i < steps.size(); ++i)
    ASSERT_NEAR(static_cast<double>(picture.pixels[3 * i]), steps[i] / 64770.0, 1e-5) << i;
}

TEST(StiffCases, E1AnEmptyListIsItsBackground) {
  const Image image = render_image({5, 4, {1, 0, 0, 1}, Coverage::area, {}}, {});
  ASSERT_EQ(image.channels, 3);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(image.pixels[static_cast<std::size_t>(3 * i)], 255);
    EXPECT_EQ(image.pixels[static_cast<std::size_t>(3 * i + 1)], 0);
  }
}

TEST(Software, ATransparentBackgroundGivesFourChannels) {
  const FillPath half = ring_path({{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, false);
  const DrawList list{2, 1, {0, 0, 0, 0}, Coverage::area, {{half, {0, 1, 0, 1}}}};
  const Image image = render_image(list, {});
  ASSERT_EQ(image.channels, 4);
  EXPECT_EQ(image.at(0, 0)[1], 255) << "straight alpha keeps the colour";
  EXPECT_EQ(image.at(0, 0)[3], 128);
  EXPECT_EQ(image.at(1, 0)[3], 0);
}

TEST(StiffCases, E2ThinPicturesOfManyPixels) {
  const FillPath all = box_path(0, 0, 1e5, 1e5);
  for (const auto& [width, height] :
       {std::pair(100000, 1), std::pair(1, 100000), std::pair(1, 1)}) {
    const DrawList list{width, height, {0, 0, 0, 1}, Coverage::area, {{all, {1, 1, 1, 1}}}};
    const Image image = render_image(list, {});
    EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), 255), 3L * width * height);
  }
}

}  // namespace
}  // namespace flatray
