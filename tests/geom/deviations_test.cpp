#include <gtest/gtest.h>

#include "geom/clip.h"

// Where the paper is not followed, by the numbers of docs/DEVIATIONS.md. Number 5 is a Markov
// chain: tests/anim.
namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

const Ring kPaperQuad = {{20, 2}, {16, 10}, {10, 10}, {5, 5}};
const Ring kPaperSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Deviations, Number1DenominatorUsesTheRaysDirection) {
  const std::vector<ClipStep> steps = clip_steps({{1, 2}, {22, 10}}, kPaperQuad, kLine);
  ASSERT_EQ(steps.size(), 4u);
  for (const ClipStep& step : steps) {
    const auto i = static_cast<std::size_t>(step.edge);
    const Vec2 edge = kPaperQuad[(i + 1) % 4] - kPaperQuad[i], normal(edge.y(), -edge.x());
    EXPECT_EQ(normal.dot(edge), 0);  // what table 1 divides by, always
    EXPECT_EQ(step.denominator, normal.dot(Vec2(22, 10)));
    EXPECT_NE(step.denominator, 0);
  }
}

TEST(Deviations, Number2ARayOnAnEdgeIsKept) {
  const Ray on_edge{{-1, 1}, {1, 0}};
  EXPECT_EQ(clip_convex(on_edge, kPaperSquare).kind, HitClass::along);
  EXPECT_EQ(clip_steps(on_edge, kPaperSquare)[2].numerator, 0);
  EXPECT_FALSE(clip_convex({{-1, 1 + 0x1p-52}, {1, 0}}, kPaperSquare));
}

TEST(Deviations, Number3EnterBeyondExitIsAMiss) {
  // tOut <= 1 || tIn >= 0 holds for this interval and for every other.
  const std::vector<ClipStep> steps = clip_steps({{5, 8}, {3, 2}}, kPaperQuad, kSegment);
  const HitInterval last = steps.back().candidate;
  EXPECT_EQ(last.kind, HitClass::miss);
  EXPECT_GT(last.t_enter, last.t_exit);
}

TEST(Deviations, Number4TheSmallerExitIsKept) {
  const std::vector<ClipStep> steps = clip_steps({{1, 2}, {22, 10}}, kPaperQuad, kSegment);
  EXPECT_EQ(steps[1].t, 0.8);
  EXPECT_EQ(steps[1].candidate.t_exit, 19.0 / 27);
}

TEST(Deviations, Number6EdgesRunFromTheirStartToTheirEnd) {
  // With start - end the normals of a counter-clockwise polygon would point inward, and enter and
  // exit change places.
  const std::vector<ClipStep> steps = clip_steps({{-1, 0.5}, {1, 0}}, kPaperSquare);
  EXPECT_EQ(steps[1].kind, 1);   // leaves by the right side
  EXPECT_EQ(steps[3].kind, -1);  // enters by the left
}

TEST(Deviations, Number7TheBoxIsNotThePolygon) {
  const Ring box = {{5, 2}, {20, 2}, {20, 10}, {5, 10}};
  const HitInterval in_box = clip_convex({{1, 2}, {22, 10}}, box, kSegment);
  EXPECT_EQ(in_box.t_enter, 2.0 / 11);
  EXPECT_EQ(in_box.t_exit, 0.8);
  const Ray inside_box{{5, 8}, {3, 2}};
  EXPECT_EQ(clip_convex(inside_box, box, kSegment).kind, HitClass::through);
  EXPECT_FALSE(clip_convex(inside_box, kPaperQuad, kSegment));
}

TEST(Deviations, Number8AllEdgesAndContainmentAreTested) {
  // The square is met by the right side of this triangle alone, not by its first ray.
  const Ring triangle = {{-3, -1}, {0.5, -1}, {0.5, 3}};
  const auto side_hits = [&](std::size_t i) {
    const Vec2 a = triangle[i], b = triangle[(i + 1) % 3];
    return static_cast<bool>(clip_convex({a, b - a}, kPaperSquare, kSegment));
  };
  EXPECT_FALSE(side_hits(0));
  EXPECT_TRUE(side_hits(1));
  // A polygon inside the square has no vertex outside: every side, and the start alone, says
  // inside.
  const Ring inner = {{0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}};
  for (std::size_t i = 0; i < 3; ++i) {
    const HitInterval hit =
        clip_convex({inner[i], inner[(i + 1) % 3] - inner[i]}, kPaperSquare, kSegment);
    EXPECT_EQ(hit.start, StartPlace::inside);
    EXPECT_EQ(hit.edge_enter, kNoEdge);
  }
  EXPECT_EQ(clip_convex({kPaperSquare[0], {0, 0}}, inner).kind, HitClass::miss);
}

}  // namespace
}  // namespace flatray
