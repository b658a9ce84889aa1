#include <gtest/gtest.h>

#include <vector>

#include "geom/clip.h"

namespace flatray {
namespace {

const std::vector<Vec2> kUnitSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

void expect_hit(const HitInterval& hit, HitClass kind, double enter, double exit) {
  EXPECT_STREQ(name(hit.kind), name(kind));
  EXPECT_EQ(hit.t_enter, enter);
  EXPECT_EQ(hit.t_exit, exit);
}

// Paper, tables 2 and 3, case I. Integer input, so both ends are exact fractions, rounded once.
TEST(CyrusBeck, ReproducesThePaperRayAgainstQuadrilateral) {
  const std::vector<Vec2> quad = {{20, 2}, {16, 10}, {10, 10}, {5, 5}};
  const HitInterval hit = clip_convex({{1, 2}, {22, 10}}, quad);
  expect_hit(hit, HitClass::through, 19.0 / 72.0, 19.0 / 27.0);
  EXPECT_EQ(hit.edge_enter, 3);
  EXPECT_EQ(hit.edge_exit, 0);
  EXPECT_EQ(hit.start, StartPlace::outside);
}

TEST(CyrusBeck, StrictlyInsideHasNoEnteringEdge) {
  const HitInterval hit = clip_convex({{0.5, 0.25}, {1, 0}}, kUnitSquare);
  expect_hit(hit, HitClass::through, 0, 0.5);
  EXPECT_EQ(hit.edge_enter, kNoEdge);
  EXPECT_EQ(hit.edge_exit, 1);
  EXPECT_EQ(hit.start, StartPlace::inside);
}

TEST(CyrusBeck, StartingOnTheBoundaryAndLeavingIsATouchAtZero) {
  const HitInterval hit = clip_convex({{1, 0.5}, {1, 0}}, kUnitSquare);
  expect_hit(hit, HitClass::touch, 0, 0);
  EXPECT_EQ(hit.start, StartPlace::boundary);
  EXPECT_EQ(hit.edge_enter, kNoEdge);
  EXPECT_EQ(hit.edge_exit, 1);
}

TEST(CyrusBeck, SegmentEndingOnTheBoundaryIsATouch) {
  const HitInterval hit = clip_convex({{-1, 0.5}, {1, 0}}, kUnitSquare, kSegment);
  expect_hit(hit, HitClass::touch, 1, 1);
  EXPECT_EQ(hit.edge_enter, 3);
  EXPECT_EQ(hit.edge_exit, kNoEdge);
}

TEST(CyrusBeck, SegmentWhollyInsideHasNeitherEdge) {
  const HitInterval hit = clip_convex({{0.25, 0.5}, {0.5, 0.125}}, kUnitSquare, kSegment);
  expect_hit(hit, HitClass::through, 0, 1);
  EXPECT_EQ(hit.edge_enter, kNoEdge);
  EXPECT_EQ(hit.edge_exit, kNoEdge);
}

TEST(CyrusBeck, ZeroDirectionIsAPointTestOverTheWholeRange) {
  expect_hit(clip_convex({{0.5, 0.5}, {0, 0}}, kUnitSquare), HitClass::through, 0, kInfinity);
  expect_hit(clip_convex({{1, 0.5}, {0, 0}}, kUnitSquare, kSegment), HitClass::touch, 0, 1);
  EXPECT_FALSE(clip_convex({{2, 0}, {0, 0}}, kUnitSquare, kLine));
}

TEST(CyrusBeck, TimesBeyondTheDoublesAreTheLargestAndFlagged) {
  const std::vector<Vec2> wide = {{0, 0}, {1e308, 0}, {1e308, 1}, {0, 1}};
  const HitInterval hit = clip_convex({{-1e300, 0.5}, {1e-10, 0}}, wide);
  EXPECT_EQ(hit.kind, HitClass::through);
  EXPECT_EQ(hit.t_exit, std::numeric_limits<double>::max());
  EXPECT_TRUE(hit.enter_overflows && hit.exit_overflows);
}

TEST(CyrusBeck, ARangeOfOnePointInsideIsThrough) {
  expect_hit(clip_convex({{-1, 0.5}, {1, 0}}, kUnitSquare, {1.5, 1.5}), HitClass::through, 1.5,
             1.5);
  expect_hit(clip_convex({{-1, 0.5}, {1, 0}}, kUnitSquare, {1, 1}), HitClass::touch, 1, 1);
  EXPECT_FALSE(clip_convex({{-1, 0.5}, {1, 0}}, kUnitSquare, {0.5, 0.75}));
}

}  // namespace
}  // namespace flatray
