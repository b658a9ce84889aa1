#include "collide/contact.h"

#include <gtest/gtest.h>

#include "collide/minkowski.h"
#include "geom/polygon.h"
#include "oracle/contact.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;
using Ring = std::vector<Vec2>;

Ring box_ring(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}
const Ring kSquare = box_ring(0, 0, 1, 1);

HitInterval meet(const Ring& a, const Vec2& va, const Ring& b, const Vec2& vb,
                 Range within = kRay) {
  return contact({a, va}, {b, vb}, within).times;
}

TEST(StiffCases, D1ThePapersBoxesMeetToTheLastBit) {
  const Ring a = box_ring(250, 200, 314, 328), b = box_ring(885, 378, 949, 506);
  const HitInterval met = meet(a, {635, 178}, b, {0, 0});
  EXPECT_EQ(met.kind, HitClass::through);
  EXPECT_EQ(met.t_enter, 571.0 / 635);
  EXPECT_EQ(met.t_exit, 699.0 / 635);
  EXPECT_EQ(met.start, StartPlace::outside);
  const Contact by_edge = contact({a, {635, 178}}, {b, {0, 0}});
  // The right side of the one comes upon the left side of the other.
  EXPECT_EQ(by_edge.first.edge, by_edge.first.edge_of_a ? 1 : 3);
}

TEST(StiffCases, D2ABulletMeetsAThinWallAtEveryFrameRate) {
  const double h = 0x1p-10;
  const Ring bullet = box_ring(-h, -h, h, h), wall = box_ring(1, -8, 1 + 0x1p-40, 8);
  const HitInterval met = meet(bullet, {3e8, 0}, wall, {0, 0});
  EXPECT_EQ(met.t_enter, (1 - h) / 3e8);
  EXPECT_EQ(met.t_exit, (1 + 0x1p-40 + h) / 3e8);
  for (const double fps : {24.0, 1000.0, 1e9}) {
    int frames = 0;
    for (int k = 0; k < 8; ++k)
      frames += meet(bullet, {3e8, 0}, wall, {0, 0}, {k / fps, (k + 1) / fps}) ? 1 : 0;
    EXPECT_GE(frames, 1) << fps;
  }
}

TEST(StiffCases, D3CornerToCorner) {
  EXPECT_EQ(meet(kSquare, {1, 1}, box_ring(2, 2, 3, 3), {0, 0}).kind, HitClass::through);
  EXPECT_EQ(meet(kSquare, {1, 1}, box_ring(2, 2, 3, 3), {0, 0}).t_enter, 1);
  const HitInterval touch = meet(kSquare, {1, 1}, box_ring(2, 0, 3, 1), {0, 0});
  EXPECT_EQ(touch.kind, HitClass::touch);
  EXPECT_EQ(touch.t_enter, 1);
  EXPECT_EQ(touch.t_exit, 1);
}

TEST(StiffCases, D4SlidingIsAlongAndOneUlpDecides) {
  const HitInterval slide = meet(kSquare, {1, 0}, box_ring(2, 1, 3, 2), {0, 0});
  EXPECT_EQ(slide.kind, HitClass::along);
  EXPECT_EQ(slide.t_enter, 1);
  EXPECT_EQ(slide.t_exit, 3);
  EXPECT_EQ(meet(kSquare, {1, 0}, box_ring(2, 1 - 0x1p-53, 3, 2), {0, 0}).kind, HitClass::through);
  EXPECT_EQ(meet(kSquare, {1, 0}, box_ring(2, 1 + 0x1p-52, 3, 2), {0, 0}).kind, HitClass::miss);
}

TEST(StiffCases, D5WithoutRelativeMotionTheStartDecidesForAllTime) {
  const Vec2 v(0.1, -7e200);
  EXPECT_EQ(meet(kSquare, v, box_ring(2, 0, 3, 1), v, kLine).kind, HitClass::miss);
  const HitInterval touch = meet(kSquare, v, box_ring(1, 0, 3, 1), v, kLine);
  EXPECT_EQ(touch.kind, HitClass::touch);
  EXPECT_EQ(touch.t_enter, -kInfinity);
  EXPECT_EQ(touch.t_exit, kInfinity);
  EXPECT_EQ(meet(kSquare, v, box_ring(0.5, 0, 3, 1), v, kLine).kind, HitClass::through);
}

TEST(StiffCases, D6ContainmentIsOverlapFromTheStart) {
  for (const Vec2& v : {Vec2(0, 0), Vec2(1, 2), Vec2(-3e8, 1)}) {
    const HitInterval met = meet(kSquare, v, box_ring(-1, -1, 2, 2), {0, 0});
    EXPECT_EQ(met.kind, HitClass::through);
    EXPECT_EQ(met.t_enter, 0);
    EXPECT_EQ(met.start, StartPlace::inside);
  }
}

TEST(StiffCases, D7FarAwayIsTheSame) {
  const Vec2 far(0x1p50, -0x1p49);
  Ring a = box_ring(250, 200, 314, 328), b = box_ring(885, 378, 949, 506);
  for (Vec2& p : a) p += far;
  for (Vec2& p : b) p += far;
  EXPECT_EQ(meet(a, {635, 178}, b, {0, 0}).t_enter, 571.0 / 635);
  EXPECT_EQ(meet(a, {635, 178}, b, {0, 0}).t_exit, 699.0 / 635);
}

TEST(StiffCases, D9SegmentsAndPointsMeetAsClosedSets) {
  const Ring point = {{0.5, -1}}, segment = {{0, 0}, {1, 0}}, level = {{3, 0}, {4, 0}};
  EXPECT_EQ(meet(point, {0, 1}, segment, {0, 0}).kind, HitClass::touch);
  EXPECT_EQ(meet(point, {0, 1}, segment, {0, 0}).t_enter, 1);
  const HitInterval along = meet(segment, {1, 0}, level, {0, 0});
  EXPECT_EQ(along.kind, HitClass::along);
  EXPECT_EQ(along.t_enter, 2);
  EXPECT_EQ(along.t_exit, 4);
  EXPECT_EQ(meet(point, {0, 1}, point, {0, 1}).kind, HitClass::touch);
  EXPECT_EQ(meet(point, {0, 1}, point, {0, 2}).kind, HitClass::touch);
  EXPECT_EQ(meet({{0, 0}}, {1, 1}, {{3, 3}}, {0, 0}).t_enter, 3);
  EXPECT_EQ(meet({{0, 0}}, {1, 1}, {{3, 4}}, {0, 0}).kind, HitClass::miss);
  // Two segments that cross sweep a parallelogram: they overlap in the sense of A - B.
  EXPECT_EQ(meet(segment, {0, 1}, {{0.5, 1}, {0.5, 3}}, {0, 0}).kind, HitClass::through);
}

// A convex ring of whole numbers, of either sense, sometimes with repeated vertices, sometimes
// without area.
Ring ring_of(Draw& draw) {
  const double x = draw.below(12) - 6, y = draw.below(12) - 6;
  const int n = static_cast<int>(draw.below(6));
  if (n == 0) return {{x, y}};
  const Vec2 e{draw.below(5) - 2, draw.below(5) - 2}, f{draw.below(5) - 2, draw.below(5) - 2};
  const Vec2 at(x, y);
  if (n == 1) return {at, at + e};
  if (n == 2) return {at, at + e, at + f};
  if (n == 3) return {at, at + e, at + 2 * e, at + f};  // a vertex within an edge
  if (n == 4) return {at, at + e, at + e, at + e + f, at + f};
  return {at, at + e, at + e + f, at + f};
}

Ring mapped(Ring ring, double scale, const Vec2& by, Draw& draw, bool nudged) {
  for (Vec2& p : ring) {
    p = scale * p + by;
    if (nudged) p = nudge(p, draw);
  }
  return ring;
}

double as_double(const std::optional<Rational>& t, double none) {
  if (!t) return none;
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(t->nearest(), -largest, largest);
}

void expect_truth(const Ring& a, const Vec2& va, const Ring& b, const Vec2& vb, Range within) {
  const HitInterval met = meet(a, va, b, vb, within);
  const oracle::ContactTruth truth = oracle::contact_truth({a, va}, {b, vb}, within);
  ASSERT_EQ(met.kind, truth.kind);
  ASSERT_EQ(met.start, truth.start);
  if (!met) return;
  ASSERT_EQ(met.t_enter, as_double(truth.first, -kInfinity));
  ASSERT_EQ(met.t_exit, as_double(truth.last, kInfinity));
}

TEST(Contact, AgreesWithSeparatingAxes) {
  int kinds[4] = {};
  for (std::uint64_t item = 0; item < 3000; ++item) {
    Draw draw(5, 40, item);
    const bool nudged = item % 3 == 1;
    const double scale = item % 5 == 4 ? 0.1 : item % 7 == 3 ? 1e150 : 1;
    const Vec2 by = item % 11 == 5 ? Vec2(0x1p40, 0x1p39) : Vec2(0, 0);
    const Ring a = mapped(ring_of(draw), scale, by, draw, nudged);
    const Ring b = mapped(ring_of(draw), scale, by, draw, nudged);
    if (non_convex_vertex(a) || non_convex_vertex(b)) continue;
    const Vec2 va = scale * Vec2{draw.below(5) - 2, draw.below(5) - 2};
    const Vec2 vb = scale * Vec2{draw.below(5) - 2, draw.below(5) - 2};
    SCOPED_TRACE(item);
    for (const Range within : {kRay, kLine, kSegment}) {
      expect_truth(a, va, b, vb, within);
      if (HasFatalFailure()) return;
    }
    ++kinds[static_cast<int>(meet(a, va, b, vb).kind)];
  }
  for (const int count : kinds) EXPECT_GT(count, 20);
}

TEST(StiffCases, D8ExchangedOrCarriedAlongTheTimesAreTheSame) {
  for (std::uint64_t item = 0; item < 500; ++item) {
    Draw draw(6, 40, item);
    const Ring a = ring_of(draw), b = ring_of(draw);
    if (non_convex_vertex(a) || non_convex_vertex(b)) continue;
    const Vec2 va(draw.below(5) - 2, 1), vb(-1, draw.below(5) - 2), common(8, -16);
    const HitInterval met = meet(a, va, b, vb, kLine);
    EXPECT_EQ(met, meet(b, vb, a, va, kLine));
    EXPECT_EQ(met, meet(a, va + common, b, vb + common, kLine));
  }
}

TEST(Contact, TheFirstFeatureIsAnEdgeAndAVertexThatMeetThere) {
  const Ring house = {{4, 0}, {6, 0}, {6, 2}, {5, 3}, {4, 2}};
  const Contact met = contact({kSquare, {0, 0}}, {house, {-1, 0}});
  EXPECT_EQ(met.times.t_enter, 3);
  // The right side of the square, or the left one of the house, against an end of the other.
  EXPECT_EQ(met.first.edge, met.first.edge_of_a ? 1 : 4);
}

TEST(MinkowskiDifference, OfTwoSquaresHasEightEdgesInTheOrderOfTheirAngles) {
  const Difference d = minkowski_difference(kSquare, box_ring(3, 3, 4, 4));
  EXPECT_TRUE(d.has_area);
  ASSERT_EQ(d.corners.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    const DifferenceCorner &from = d.corners[k], &to = d.corners[(k + 1) % 8];
    EXPECT_TRUE(from.a == to.a || from.b == to.b);
  }
}

}  // namespace
}  // namespace flatray
