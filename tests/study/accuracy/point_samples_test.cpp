#include "study/accuracy/point_samples.h"

#include <gtest/gtest.h>

#include <set>

#include "image/srgb.h"
#include "render/frame.h"

namespace flatray {
namespace {

DrawList box_list(double left, double top, double right, double bottom) {
  const Vec2 a(left, top), b(right, top), c(right, bottom), d(left, bottom);
  DrawList list{4, 3, {1, 1, 1, 1}, Coverage::area, {}};
  list.items.push_back(
      {FillPath{{{a, b}, {b, c}, {c, d}, {d, a}}, FillRule::nonzero, true}, {0, 0, 0, 1}});
  return list;
}

TEST(SamplePlaces, StandLikeRooks) {
  for (const unsigned count : {4U, 16U, 64U}) {
    const std::vector<SamplePlace> places = sample_places(Coverage::area, count);
    std::set<double> columns, rows;
    for (const SamplePlace& place : places) {
      columns.insert(place[0]), rows.insert(place[1]);
      EXPECT_TRUE(place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1) << count;
      EXPECT_EQ(place[0] * 256, std::floor(place[0] * 256)) << "off the grid of GL";
    }
    EXPECT_EQ(places.size(), count);
    EXPECT_EQ(columns.size(), count);
    EXPECT_EQ(rows.size(), count);
    EXPECT_EQ(*std::next(columns.begin()) - *columns.begin(), 1.0 / count);
  }
  EXPECT_EQ(sample_places(Coverage::centre, 64).size(), 1U);
}

TEST(PointSampled, CountsTheSamplesInside) {
  // Right of x = 1.5 lie two of the four samples of pixel 1.
  const DrawList list = box_list(1.5, 0.25, 3, 2);
  const PointSampled seen = point_sampled(list, sample_places(list.coverage, 4), 1);
  EXPECT_EQ(seen.picture.at(1, 1)[0], srgb_from_linear(0.5F));
  EXPECT_EQ(seen.picture.at(1, 0)[0], srgb_from_linear(0.5F));  // (0.875, 0.375), (0.625, 0.875)
  EXPECT_EQ(seen.picture.at(2, 1)[0], 0);
  EXPECT_EQ(seen.picture.at(0, 1)[0], 255);
}

TEST(PointSampled, NearIsWithinAnHundredAndTwentyEighth) {
  for (const auto& [edge, near] :
       {std::pair(1.625 + 0x1p-8, true), std::pair(1.625 + 0x1p-6, false)}) {
    const DrawList list = box_list(edge, -1, 9, 9);
    const PointSampled seen = point_sampled(list, sample_places(list.coverage, 4), 1);
    EXPECT_EQ(seen.near[4 + 1], near) << edge;
    EXPECT_FALSE(seen.near[4 + 2]) << edge;
  }
}

// A border between columns belongs to the pixel right of it.
TEST(EdgePixels, AreThoseInWhichAnOutlineLies) {
  const std::vector<bool> edges = edge_pixels(box_list(1, 0.5, 3, 2));
  const std::vector<bool> expected = {false, true,  true,  true,  false, false,
                                      false, false, false, false, false, false};
  EXPECT_EQ(edges, expected);
}

TEST(DifferenceCauses, AWrongPictureIsNotExplained) {
  const DrawList list = box_list(1.5, 0.25, 3, 2), moved = box_list(1.75, 0.25, 3, 2);
  const auto judged = [&](const DrawList& drawn) {
    const auto places = sample_places(list.coverage, 4);
    return difference_causes(point_sampled(drawn, places, 1).picture, render_image(list, {}),
                             point_sampled(list, places, 1), edge_pixels(list));
  };
  EXPECT_TRUE(judged(list).coverage_alone());
  EXPECT_FALSE(judged(moved).coverage_alone());  // by a quarter of a pixel: one sample fewer
  EXPECT_EQ(judged(moved).unexplained, 2U);
  DrawList darker = list;
  darker.background.r = 0.5F;
  EXPECT_GT(judged(darker).flat_worst, 1);
}

}  // namespace
}  // namespace flatray
