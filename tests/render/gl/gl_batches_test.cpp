#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/gl/batches.h"
#include "render/gl/grid.h"
#include "render/gl/outlines.h"

namespace flatray::gl {
namespace {

constexpr PixelBox kTile{0, 0, 200, 100};

FillPath square_path(double x, double y, double side) {
  const Vec2 a(x, y), b(x + side, y), c(x + side, y + side), d(x, y + side);
  return {{{a, b}, {b, c}, {c, d}, {d, a}}, FillRule::nonzero, true};
}

// Two boxes, one inside the other: not one convex ring.
FillPath frame_path(double x, double y, double side) {
  FillPath path = square_path(x, y, side);
  for (const Segment& edge : square_path(x + 1, y + 1, side - 2).edges)
    path.edges.push_back({edge.b, edge.a});
  path.simple = false;
  return path;
}

std::vector<int> kinds(const std::vector<DrawItem>& items) {
  const auto made = batches({200, 100, {}, Coverage::area, items}, kTile);
  std::vector<int> found;
  for (const FlatrayGlBatch& batch : made.batches) found.push_back(batch.kind);
  return found;
}

TEST(GlBatches, ConvexItemsAreOneBatchInTheirOrder) {
  std::vector<DrawItem> items;
  for (int i = 0; i < 50; ++i)
    items.push_back({square_path(i, i, 10), {static_cast<float>(i), 0, 0, 1}});
  EXPECT_EQ(kinds(items), std::vector<int>{FLATRAY_GL_PAINT});
  const auto made = batches({200, 100, {}, Coverage::area, items}, kTile);
  ASSERT_EQ(made.vertices.size(), 50U * 6);
  for (std::size_t i = 0; i < made.vertices.size(); ++i)
    EXPECT_EQ(made.vertices[i].paint[0], static_cast<float>(i / 6));
}

TEST(GlBatches, TrianglesWithoutAreaAreLeftOut) {
  for (FillPath path : {square_path(0, 0, 20), frame_path(0, 0, 20)}) {
    const auto count = [&] {
      return batches({200, 100, {}, Coverage::area, {{path, {}}}}, kTile).vertices.size();
    };
    const std::size_t plain = count();
    const Segment first = path.edges.front();
    const Vec2 middle = 0.5 * (first.a + first.b);
    path.edges.front() = {first.a, middle};
    path.edges.insert(path.edges.begin() + 1, {middle, first.b});
    EXPECT_EQ(count(), plain) << path.edges.size();
  }
}

TEST(GlBatches, WhatIsNotConvexIsMarkedAndCoveredInItsPlace) {
  const LinearColour half{0, 0, 0, 0.5F};
  constexpr auto kPaint = FLATRAY_GL_PAINT, kCount = FLATRAY_GL_COUNT, kCover = FLATRAY_GL_COVER;
  EXPECT_EQ(kinds({{frame_path(0, 0, 20), half}, {frame_path(10, 10, 20), half}}),
            (std::vector<int>{kCount, kCover, kCount, kCover}));
  EXPECT_EQ(kinds({{square_path(0, 0, 20), half},
                   {frame_path(0, 0, 20), half},
                   {square_path(10, 10, 20), half},
                   {square_path(20, 10, 20), half}}),
            (std::vector<int>{kPaint, kCount, kCover, kPaint}));
}

// Squares that overlap, half transparent: what both cover must not be blended twice.
TEST(GlBatches, ConvexRingsThatRunAlikeAreCountedWhereTheyShowThrough) {
  FillPath path = square_path(0, 0, 20);
  for (const Segment& edge : square_path(10, 10, 20).edges) path.edges.push_back(edge);
  path.simple = false;
  EXPECT_EQ(kinds({{path, {0, 0, 0, 0.5F}}}),
            (std::vector<int>{FLATRAY_GL_COUNT, FLATRAY_GL_COVER}));
  EXPECT_EQ(kinds({{path, {0, 0, 0, 1}}}), std::vector<int>{FLATRAY_GL_PAINT});
}

DrawItem on_layer(std::uint32_t layer, double x, double y) {
  DrawItem item{square_path(x, y, 20), {0, 0, 0, 1}};
  item.layer = layer, item.opacity = 0.5F;
  return item;
}

TEST(GlBatches, ALayerIsDrawnAndLaidInItsPlace) {
  constexpr auto kPaint = FLATRAY_GL_PAINT, kBegin = FLATRAY_GL_LAYER, kLay = FLATRAY_GL_LAY;
  EXPECT_EQ(kinds({on_layer(1, 0, 0), on_layer(1, 10, 0)}),
            (std::vector<int>{kBegin, kPaint, kLay}));
  EXPECT_EQ(kinds({on_layer(1, 0, 0), on_layer(2, 10, 0)}),
            (std::vector<int>{kBegin, kPaint, kLay, kBegin, kPaint, kLay}));
  EXPECT_EQ(kinds({{square_path(10, 0, 20), {}}, on_layer(1, 0, 0), {square_path(10, 0, 20), {}}}),
            (std::vector<int>{kPaint, kBegin, kPaint, kLay, kPaint}));
  EXPECT_EQ(kinds({on_layer(1, -100, 0)}), std::vector<int>{});
}

TEST(GlBatches, GradientsAreBatchesOfTheirOwn) {
  DrawItem graded{square_path(0, 0, 20), {0, 0, 0, 1}};
  graded.gradient = {.stops = {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 0.5F}}}};
  const auto made = batches(
      {200, 100, {}, Coverage::area, {{square_path(50, 0, 20), {}}, graded, graded}}, kTile);
  ASSERT_EQ(made.batches.size(), 2U);
  EXPECT_EQ(made.batches[0].gradients, 0);
  EXPECT_EQ(made.batches[1].gradients, 1);
  EXPECT_EQ(made.vertices.back().paint[0], 1);
  ASSERT_EQ(made.gradients.size(), 2U);
  EXPECT_EQ(made.gradients[1].first_stop, 2U);
  EXPECT_EQ(made.stops[3].rgba[2], 0.5F);  // premultiplied
}

TEST(GlBatches, WhatIsNotInTheTileIsNotDrawn) {
  EXPECT_EQ(kinds({{square_path(-30, 0, 20), {}},
                   {square_path(0, 101, 20), {}},
                   {FillRing{{-10, -10}, 9}, {}},
                   {square_path(10, 10, 20), {0, 0, 0, 0}}}),
            std::vector<int>{});
}

TEST(GlBatches, HugeFiguresAreCutToWhatARasterizerTakes) {
  const auto made = batches({200,
                             100,
                             {},
                             Coverage::area,
                             {{square_path(-1e12, -1e12, 3e12), {}},
                              {FillRing{{50, 1e9}, 1e9}, {}},
                              {frame_path(-1e7, -1e7, 1e8), {}}}},
                            kTile);
  EXPECT_LT(made.vertices.size(), 20'000U);
  for (const FlatrayGlVertex& v : made.vertices)
    EXPECT_TRUE(v.x >= -512 && v.x <= 712 && v.y >= -512 && v.y <= 612) << v.x << ' ' << v.y;
}

// `turns` times round a square.
FillPath coil(int turns) {
  FillPath path = square_path(10, 10, 20);
  const std::vector<Segment> once = path.edges;
  for (int i = 1; i < turns; ++i) path.edges.insert(path.edges.end(), once.begin(), once.end());
  path.simple = false;
  return path;
}

TEST(GlBatches, WindingsAreCountedInAStencilWhereThatCannotOverflow) {
  FillPath few = coil(255), many = coil(256);
  for (FillPath* path : {&few, &many})  // else all rings are convex alike
    for (const Segment& edge : square_path(60, 10, 20).edges)
      path->edges.push_back({edge.b, edge.a});
  EXPECT_EQ(kinds({{few, {}}}), (std::vector<int>{FLATRAY_GL_COUNT, FLATRAY_GL_COVER}));
  EXPECT_EQ(kinds({{many, {}}}),
            (std::vector<int>{FLATRAY_GL_SUM, FLATRAY_GL_FIND, FLATRAY_GL_COVER}));
}

TEST(GlGrid, FiguresBesideOneAnotherDoNotWindMore) {
  const auto square = [](std::int64_t x, std::int64_t y) {
    return std::vector<GridPoint>{{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y + 10}};
  };
  std::vector<std::vector<GridPoint>> row, pile;
  for (int i = 0; i < 300; ++i) row.push_back(square(10 * i, 0)), pile.push_back(square(0, 0));
  EXPECT_EQ(most_windings(row, 1), 1U);
  EXPECT_EQ(most_windings(pile, 1), 300U);
  EXPECT_EQ(most_windings(pile, 600), 600U);
}

TEST(GlGrid, AHullIsConvexAndHoldsItsPoints) {
  const std::vector<GridPoint> corners =
      hull({{0, 0}, {4, 0}, {2, 0}, {4, 4}, {0, 4}, {2, 1}, {0, 0}, {4, 2}});
  EXPECT_EQ(corners.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_GT(area(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]), 0);
  EXPECT_TRUE(hull({{0, 0}, {1, 1}, {2, 2}}).empty());
}

TEST(GlOutlines, ACircleKeepsWithinAStepOfTheGrid) {
  const Bounds box{{0, 0}, {200, 100}};
  for (const double radius : {0.5, 30.0, 5000.0, 1e8}) {
    const Vec2 centre(100, 50 - radius);
    const Ring ring = circle_ring(centre, radius, box);
    EXPECT_LT(ring.size(), 3000U);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 middle = 0.5 * (ring[i] + ring[(i + 1) % ring.size()]);
      if (box.contains(middle)) {
        EXPECT_LE(radius - std::sqrt((middle - centre).squaredNorm()), 1.01 / 256) << radius;
      }
    }
  }
}

TEST(GlOutlines, ACircleIsFineWhereverABoxLiesOnIt) {
  constexpr double kRadius = 5000;
  for (int i = 0; i < 16; ++i) {
    const double angle = 0.1 + 2 * std::numbers::pi * i / 16;
    const Vec2 on = kRadius * Vec2(std::cos(angle), std::sin(angle)), half(50, 50);
    const Bounds box{on - half, on + half};
    const Ring ring = circle_ring({0, 0}, kRadius, box);
    int inside = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 middle = 0.5 * (ring[k] + ring[(k + 1) % ring.size()]);
      if (!box.contains(middle)) continue;
      EXPECT_LE(kRadius - middle.norm(), 1.01 / 256) << angle;
      ++inside;
    }
    EXPECT_GE(inside, 2) << angle;
  }
}

TEST(GlOutlines, ACircleThatIsWhollySeenHasEqualSides) {
  const Ring ring = circle_ring({50, 50}, 30, {{0, 0}, {100, 100}});
  const double side = (ring[1] - ring[0]).norm();
  for (std::size_t k = 0; k < ring.size(); ++k)
    EXPECT_NEAR((ring[(k + 1) % ring.size()] - ring[k]).norm(), side, 1e-9) << k;
}

TEST(GlOutlines, ClampingKeepsWindingInside) {
  const Bounds box{{0, 0}, {10, 10}};
  // A spiral ring that leaves the box on three sides and winds twice round (5, 5).
  const Ring ring = {{-20, -20}, {30, -20}, {30, 40}, {-9, 40}, {-9, 2}, {8, 2}, {8, 8}, {-15, 8}};
  const auto winding = [](const Ring& points, const Vec2& at) {
    int turns = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
      const double side = cross(b - a, at - a);
      if (a.y() <= at.y() && b.y() > at.y() && side > 0) ++turns;
      if (b.y() <= at.y() && a.y() > at.y() && side < 0) --turns;
    }
    return turns;
  };
  const Ring moved = clamped(ring, box);
  const Bounds reach = box_about(moved);
  EXPECT_TRUE(box.contains(reach.low) && box.contains(reach.high));
  for (const Vec2& at : {Vec2(5, 5), Vec2(9, 9), Vec2(1, 1), Vec2(5, 1.5), Vec2(9.5, 5)})
    EXPECT_EQ(winding(moved, at), winding(ring, at)) << at.transpose();
}

}  // namespace
}  // namespace flatray::gl
