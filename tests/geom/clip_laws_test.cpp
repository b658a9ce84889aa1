#include <gtest/gtest.h>

#include <algorithm>

#include "geom/clip.h"
#include "geom/clip_cases.h"
#include "geom/predicates.h"
#include "trace/random_rays.h"

namespace flatray {
namespace {

constexpr int kCases = 2000;

void expect_same_answer(const HitInterval& a, const HitInterval& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.t_enter, b.t_enter);
  EXPECT_EQ(a.t_exit, b.t_exit);
}

template <class Law>
void for_grid_cases(const Law& law) {
  for (int item = 0; item < kCases; ++item) {
    Draw draw = draw_of(50, item);
    law(grid_case(draw), draw);
    ASSERT_FALSE(testing::Test::HasFailure()) << "case " << item;
  }
}

TEST(ClipLaws, AnyFirstVertexAndEitherOrientationGiveTheSameBits) {
  for_grid_cases([](const Case& c, Draw& draw) {
    auto ring = c.polygon;
    const HitInterval hit = clip_convex(c.ray, ring);
    const auto first = static_cast<std::ptrdiff_t>(draw.below(static_cast<int>(ring.size())));
    std::rotate(ring.begin(), ring.begin() + first, ring.end());
    expect_same_answer(clip_convex(c.ray, ring), hit);
    std::reverse(ring.begin(), ring.end());
    expect_same_answer(clip_convex(c.ray, ring), hit);
  });
}

TEST(ClipLaws, APowerOfTwoChangesNoBit) {
  for_grid_cases([](const Case& c, Draw& draw) {
    const double scale = std::ldexp(1.0, static_cast<int>(draw.below(1900)) - 930);
    const Case scaled = map(c, [&](const Vec2& v) { return Vec2(v * scale); });
    EXPECT_EQ(clip_convex(scaled.ray, scaled.polygon), clip_convex(c.ray, c.polygon));
  });
}

TEST(ClipLaws, ARepresentableShiftChangesNoBit) {
  for_grid_cases([](const Case& c, Draw& draw) {
    const Vec2 shift(std::ldexp(draw.sign(), static_cast<int>(draw.below(51))),
                     std::ldexp(draw.sign(), static_cast<int>(draw.below(51))));
    const Case shifted = map(c, [&](const Vec2& v) { return Vec2(v + shift); });
    EXPECT_EQ(clip_convex(shifted.ray, shifted.polygon), clip_convex(c.ray, c.polygon));
  });
}

TEST(ClipLaws, ALongerDirectionDividesTheTimes) {
  for_grid_cases([](const Case& c, Draw&) {
    const HitInterval hit = clip_convex(c.ray, c.polygon, kLine);
    const HitInterval doubled = clip_convex({c.ray.origin, 2 * c.ray.direction}, c.polygon, kLine);
    EXPECT_EQ(doubled.kind, hit.kind);
    if (!hit) return;
    EXPECT_EQ(2 * doubled.t_enter, hit.t_enter);
    EXPECT_EQ(2 * doubled.t_exit, hit.t_exit);
  });
}

// Backwards from the tip, t is 1 - t: where it enters it leaves. t is a fraction of integers under
// 2^10, so 1 - t rounds to the same double from either side within an ulp of 1.
TEST(ClipLaws, TheReversedRayLeavesWhereItEntered) {
  for_grid_cases([](const Case& c, Draw&) {
    const Ray back{c.ray.origin + c.ray.direction, -c.ray.direction};
    const HitInterval hit = clip_convex(c.ray, c.polygon, kSegment);
    const HitInterval reversed = clip_convex(back, c.polygon, kSegment);
    EXPECT_EQ(reversed.kind, hit.kind);
    if (!hit) return;
    EXPECT_NEAR(reversed.t_enter, 1 - hit.t_exit, 0x1p-52);
    EXPECT_NEAR(reversed.t_exit, 1 - hit.t_enter, 0x1p-52);
  });
}

TEST(ClipLaws, ASegmentIsThePolygonOfItsTwoEnds) {
  for_grid_cases([](const Case& c, Draw& draw) {
    const Vec2 a = vertex_of(c, draw), b = vertex_of(c, draw);
    const HitInterval hit = clip_segment(c.ray, {a, b});
    expect_same_answer(hit, clip_segment(c.ray, {b, a}));
    EXPECT_LE(hit.edge_enter, 0);
    EXPECT_NE(hit.kind, c.ray.direction == Vec2(0, 0) ? HitClass::along : HitClass::through);
  });
}

TEST(ClipLaws, TheTableEndsInTheAnswer) {
  for_grid_cases([](const Case& c, Draw&) {
    const HitInterval hit = clip_convex(c.ray, c.polygon, kSegment);
    const std::vector<ClipStep> steps = clip_steps(c.ray, c.polygon, kSegment);
    if (steps.empty()) return;  // a polygon that is a point has no edge
    EXPECT_EQ(steps.back().candidate.kind, hit.kind);
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
      EXPECT_NE(steps[i].candidate.kind, HitClass::miss);
      if (!hit) continue;
      EXPECT_LE(steps[i].candidate.t_enter, hit.t_enter);
      EXPECT_GE(steps[i].candidate.t_exit, hit.t_exit);
    }
  });
}

// Edges whose ends are any doubles, and whose direction is none: what begins or ends in a corner of a
// triangle, or on a circle, meets it there, and either way round in the same points.
TEST(ClipLaws, EdgesAreClippedAsTheyAre) {
  Draws draws(11);
  int rounded = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec2 corner(draws.spread(-3, 3), draws.spread(-3, 3));
    const Vec2 a(draws.spread(-3, 3), draws.spread(-3, 3));
    const std::vector<Vec2> triangle{corner,
                                     {draws.spread(-3, 3), draws.spread(-3, 3)},
                                     {draws.spread(-3, 3), draws.spread(-3, 3)}};
    if (orientation(triangle[0], triangle[1], triangle[2]) == Sign::zero) continue;
    const Segment there{a, corner}, back{corner, a};
    const HitInterval hit = clip_edge(there, triangle), again = clip_edge(back, triangle);
    ASSERT_TRUE(hit && again) << i;
    ASSERT_EQ(hit.t_exit, 1) << i;
    ASSERT_EQ(again.t_enter, 0) << i;
    ASSERT_EQ(hit.kind, again.kind) << i;
    ASSERT_EQ(clip_steps({there.a, there.b}, triangle, kSegment, there.a).back().candidate.kind,
              hit.kind)
        << i;
    // A ray in the rounded direction is not always told so.
    const HitInterval near = clip_convex({a, corner - a}, triangle, kSegment);
    rounded += near.kind == hit.kind && near.t_exit == 1 ? 0 : 1;
    const double size = draws.whole(1, 9);
    const Vec2 centre(draws.whole(-9, 9), draws.whole(-9, 9)), on = centre + size * Vec2(3, -4);
    const Ellipse circle(Circle{centre, 5 * size});
    const HitInterval round = clip_edge({a, on}, circle), from = clip_edge({on, a}, circle);
    ASSERT_TRUE(round && from) << i;
    ASSERT_EQ(round.t_exit, 1) << i;
    ASSERT_EQ(from.t_enter, 0) << i;
    ASSERT_EQ(round.kind, from.kind) << i;
    ASSERT_EQ(round.kind == HitClass::touch,
              curve_side(a, circle) == Sign::positive && (on - a).dot(on - centre) <= 0)
        << i;
  }
  EXPECT_GT(rounded, 100);
}

}  // namespace
}  // namespace flatray
