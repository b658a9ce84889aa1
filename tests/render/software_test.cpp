#include <gtest/gtest.h>

#include "render/coverage_families.h"
#include "render/frame.h"
#include "render/select_kernels.h"

namespace flatray {
namespace {

using coverage_check::Draws;
using coverage_check::Family;
using coverage_check::kFamilies;
using coverage_check::make_region;

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

TEST(Software, ManyEdgesAreSortedIntoBandsWithoutLosingOne) {
  // One star of 400 edges through all bands against the same edges scanned at once.
  std::vector<Vec2> ring;
  Draws draws(4, 4);
  for (int i = 0; i < 400; ++i) ring.push_back({draws.unit() * 700, draws.unit() * 500});
  FillPath path;
  coverage_check::add_ring(ring, false, path);
  path.rule = FillRule::even_odd;
  DrawList list{700, 500, {0, 0, 0, 1}, Coverage::area, {{path, {1, 1, 1, 1}}}};
  const LinearImage picture = render_linear(list, {std::nullopt, 2});
  const auto steps = coverage_check::steps_of(path, {0, 0, 700, 500});
  for (std::size_t i = 0; i < steps.size(); ++i)
    ASSERT_EQ(picture.pixels[3 * i], coverage_share(steps[i])) << i;
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
  FillPath half;
  coverage_check::add_ring({{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, false, half);
  const DrawList list{2, 1, {0, 0, 0, 0}, Coverage::area, {{half, {0, 1, 0, 1}}}};
  const Image image = render_image(list, {});
  ASSERT_EQ(image.channels, 4);
  EXPECT_EQ(image.at(0, 0)[1], 255) << "straight alpha keeps the colour";
  EXPECT_EQ(image.at(0, 0)[3], 128);
  EXPECT_EQ(image.at(1, 0)[3], 0);
}

TEST(StiffCases, E2ThinPicturesOfManyPixels) {
  FillPath all;
  coverage_check::add_ring({{0, 0}, {1e5, 0}, {1e5, 1e5}, {0, 1e5}}, false, all);
  all.simple = true;
  for (const auto& [width, height] :
       {std::pair(100000, 1), std::pair(1, 100000), std::pair(1, 1)}) {
    const DrawList list{width, height, {0, 0, 0, 1}, Coverage::area, {{all, {1, 1, 1, 1}}}};
    const Image image = render_image(list, {});
    EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), 255), 3L * width * height);
  }
}

std::vector<kernels::Run> random_runs(Draws& draws, int width, int height) {
  std::vector<kernels::Run> runs;
  for (int y = 0; y < height; ++y)
    for (int x = draws.below(9); x < width;) {
      const int end = std::min(width, x + 1 + draws.below(draws.below(2) ? 40 : 3));
      const auto steps =
          draws.below(3) == 0 ? kFullCoverage : 1 + static_cast<std::uint32_t>(draws.below(64770));
      runs.push_back({y + 3, x + 5, end + 5, steps});
      x = end + draws.below(4);
    }
  return runs;
}

TEST(SpanKernels, EveryTierGivesThePortableBits) {
  constexpr int kWidth = 211, kHeight = 7;
  for (std::uint64_t round = 0; round < 40; ++round) {
    Draws draws(31, round);
    std::vector<float> start(4 * kWidth * kHeight);
    for (float& v : start) v = static_cast<float>(draws.unit());
    const float alpha = round % 2 ? 1.0F : static_cast<float>(draws.unit());
    const float colour[4] = {alpha * static_cast<float>(draws.unit()), alpha * 0.3F, 0, alpha};
    const std::vector<kernels::Run> runs = random_runs(draws, kWidth, kHeight);
    const auto painted = [&](Isa isa) {
      std::vector<float> rgba = start;
      span_kernels(isa).fill(rgba.data() + 4, 2 + round, colour);
      span_kernels(isa).blend_runs({rgba.data(), 5, 3, kWidth}, runs.data(), runs.size(), colour);
      return rgba;
    };
    const std::vector<float> expected = painted(Isa::portable);
    EXPECT_NE(expected, start);
    for (const Isa isa : available_isas()) EXPECT_EQ(painted(isa), expected) << isa_name(isa);
  }
}

TEST(SpanKernels, ColumnsOfEdgesAreThoseOfEveryTierAndCertain) {
  for (std::uint64_t round = 0; round < 200; ++round) {
    Draws draws(37, round);
    const double x0 = draws.unit() * 40 - 10, x1 = round % 3 ? draws.unit() * 40 - 10 : x0;
    const double slope = (x1 - x0) / 19, error = round % 2 ? 1e-3 : 0;
    const kernels::EdgeLine line{x0, 2, slope, std::min(x0, x1), std::max(x0, x1), error};
    const std::size_t count = 1 + round % 20;
    const double offset = round % 5 ? 0 : 0.5;
    const auto columns = [&](Isa isa) {
      std::vector<double> out(2 * (count + kernels::kSlack));
      double* const column = out.data() + count + kernels::kSlack;
      span_kernels(isa).edge_columns(line, 2, count, offset, out.data(), column);
      std::vector<double> kept(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count));
      kept.insert(kept.end(), column, column + count);
      return kept;
    };
    const std::vector<double> expected = columns(Isa::portable);
    for (const Isa isa : available_isas()) ASSERT_EQ(columns(isa), expected) << isa_name(isa);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = expected[i] + offset, column = expected[count + i];
      ASSERT_EQ(expected[i], std::clamp(x0 + static_cast<double>(i) * slope, line.low, line.high));
      const bool certain = std::floor(x - error) == std::floor(x + error) && x != std::floor(x);
      ASSERT_EQ(column, certain ? std::floor(x) : kernels::kNoColumn);
    }
  }
}

}  // namespace
}  // namespace flatray
