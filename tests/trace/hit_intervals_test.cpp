#include "trace/hit_intervals.h"

#include <gtest/gtest.h>

#include "trace/random_rays.h"

namespace flatray {
namespace {

const std::vector<Range> kRanges = {kRay, kLine, kSegment, {0.25, 0.5}, {2, 2}};

void expect_as_clip_convex(const std::vector<Vec2>& polygon, const RayBatch& rays) {
  std::vector<HitInterval> intervals(rays.size());
  for (const Isa isa : available_isas())
    for (const Range within : kRanges) {
      clip_convex_batch(rays, polygon, within, intervals, isa);
      for (std::size_t i = 0; i < rays.size(); ++i)
        ASSERT_EQ(intervals[i], clip_convex(rays.ray(i), polygon, within))
            << isa_name(isa) << ", ray " << i;
    }
}

RayBatch grid_rays(Draws& draw, int count, double scale) {
  RayBatch rays;
  for (int i = 0; i < count; ++i)
    rays.add({scale * draw.grid_point(-1, 6), scale * draw.grid_point(-3, 3)});
  return rays;
}

const std::vector<Vec2> kHexagon = {{1, 0}, {3, 0}, {4, 2}, {3, 4}, {1, 4}, {0, 2}};

TEST(ClipConvexBatch, EqualsEachClipOnTheGrid) {
  Draws draw(1);
  const std::vector<Vec2> clockwise(kHexagon.rbegin(), kHexagon.rend());
  const std::vector<Vec2> repeated = {{0, 0}, {0, 0}, {2, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}};
  const std::vector<Vec2> flat = {{0, 0}, {4, 4}, {2, 2}};
  for (const auto& polygon : {kHexagon, clockwise, repeated, flat, std::vector<Vec2>{{2, 2}}})
    expect_as_clip_convex(polygon, grid_rays(draw, 203, 1));
}

TEST(ClipConvexBatch, EqualsEachClipAtEveryScale) {
  for (const double scale : {0.1, 0x1p-1070, 0x1p-530, 0x1p505, 0x1p1015}) {
    Draws draw(2);
    std::vector<Vec2> polygon;
    for (const Vec2& vertex : kHexagon) polygon.push_back(scale * vertex);
    expect_as_clip_convex(polygon, grid_rays(draw, 100, scale));
  }
}

TEST(ClipConvexBatch, EqualsEachClipOnRandomRays) {
  Draws draw(3);
  RayBatch rays;
  for (int i = 0; i < 300; ++i)
    rays.add({6 * draw.point() - Vec2(1, 1), 2 * draw.point() - Vec2(1, 1)});
  expect_as_clip_convex(kHexagon, rays);
}

// Points of a parabola and its chord: where edges are searched, not looked at one by one.
TEST(ClipConvexBatch, EqualsEachClipOfManyEdges) {
  Draws draw(4);
  std::vector<Vec2> polygon;
  for (int i = 0; i < 2000; ++i) polygon.emplace_back(i / 500.0, i / 500.0 * (i / 500.0));
  RayBatch rays;
  for (int i = 0; i < 100; ++i) {
    const Vec2 origin = 6 * draw.point() - Vec2(1, 1);
    rays.add({origin, polygon[draw.bits() % polygon.size()] - origin});
    rays.add({origin, draw.point() - Vec2(0.5, 0.5)});
    rays.add({polygon[draw.bits() % polygon.size()], {0, 0}});
  }
  expect_as_clip_convex(polygon, rays);
}

TEST(ClipConvexBatch, AnEmptyPolygonIsMissed) {
  RayBatch rays;
  rays.add({{0, 0}, {1, 0}});
  std::vector<HitInterval> intervals(1);
  intervals[0].kind = HitClass::through;
  clip_convex_batch(rays, {}, kRay, intervals);
  EXPECT_EQ(intervals[0], HitInterval{});
}

}  // namespace
}  // namespace flatray
