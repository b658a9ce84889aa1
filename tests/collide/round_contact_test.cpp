#include <gtest/gtest.h>

#include <cmath>

#include "collide/contact.h"
#include "geom/polygon.h"
#include "oracle/contact.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;
using Ring = std::vector<Vec2>;

struct Body {
  Ring ring;
  Vec2 velocity;
  double radius;

  operator MovingBody() const { return {ring, velocity, radius}; }
  operator oracle::MovingCore() const { return {ring, velocity, radius}; }
};
const Ring kUnitSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Body round_body(const Vec2& at, double radius, const Vec2& velocity) {
  return {{at}, velocity, radius};
}

HitInterval meet(const Body& a, const Body& b, Range within = kRay) {
  return contact(a, b, within).times;
}

TEST(RoundContact, DiscsMeetWhereTheirCentresAreBothRadiiApart) {
  // 3-4-5: the centre passes at distance 3 from one that is 5 in reach.
  const HitInterval met = meet(round_body({-10, 3}, 2, {2, 0}), round_body({0, 0}, 3, {0, 0}));
  EXPECT_EQ(met.kind, HitClass::through);
  EXPECT_EQ(met.t_enter, 3);
  EXPECT_EQ(met.t_exit, 7);
  EXPECT_EQ(met.start, StartPlace::outside);
}

TEST(RoundContact, DiscsThatPassTouchOrMissByOneUlp) {
  const Body still = round_body({0, 0}, 2, {0, 0});
  EXPECT_EQ(meet(round_body({-10, 5}, 3, {1, 0}), still).kind, HitClass::touch);
  EXPECT_EQ(meet(round_body({-10, 5}, 3, {1, 0}), still).t_enter, 10);
  EXPECT_EQ(meet(round_body({-10, 5}, std::nextafter(3, 4), {1, 0}), still).kind,
            HitClass::through);
  EXPECT_EQ(meet(round_body({-10, 5}, std::nextafter(3, 2), {1, 0}), still).kind, HitClass::miss);
}

// At times that are no doubles, so that both ends of the one instant are told by exact numbers.
TEST(RoundContact, DiscsThatTouchInPassingTouchAtOneInstantWhereverThatIs) {
  for (const double x : {3.0, 5.0, 7.0, 11.0, 0x1p600 / 3}) {
    const HitInterval met = meet(round_body({0, 0}, 0, {3, 0}), round_body({x, 1}, 1, {0, 0}));
    EXPECT_EQ(met.kind, HitClass::touch) << x;
    EXPECT_EQ(met.t_enter, x / 3);
    EXPECT_EQ(met.t_exit, x / 3);
  }
}

TEST(RoundContact, ADiscMeetsASideOfASquareAndItsCorner) {
  const Body square = {kUnitSquare, {0, 0}, 0};
  EXPECT_EQ(meet(round_body({-5, 0.5}, 1, {1, 0}), square).t_enter, 4);
  EXPECT_EQ(meet(round_body({-5, 0.5}, 1, {1, 0}), square).t_exit, 7);
  // Round the corner (0, 1) by 3-4-5.
  const Body high = round_body({-10, 4}, 5, {1, 0});
  EXPECT_EQ(meet(high, square).t_enter, 6);
  const Contact met = contact(high, square);
  ASSERT_TRUE(met.first);
  EXPECT_EQ(met.first, (ContactFeature{true, kNoEdge, 3, 0}));
  const ContactPlace place = contact_place(met.first, high, square, met.times.t_enter);
  EXPECT_NEAR((place.point - Vec2(0, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR((place.normal - Vec2(0.8, -0.6)).norm(), 0, 1e-15);
}

TEST(RoundContact, ADiscThatSlidesAlongASideIsAlong) {
  const HitInterval slide = meet(round_body({-5, 3}, 2, {1, 0}), {kUnitSquare, {0, 0}, 0});
  EXPECT_EQ(slide.kind, HitClass::along);
  EXPECT_EQ(slide.t_enter, 5);
  EXPECT_EQ(slide.t_exit, 6);
}

// 3-4-5 by discs of radius 1 that pass at 1.2, from so far that no double tells their places.
TEST(RoundContact, TheNormalOfDiscsDoesNotSufferFromTheWay) {
  for (const double far : {1e3, 1e16, 1e200, 1e300}) {
    const Body a = round_body({-far, 0}, 1, {far, 0}), b = round_body({0, 1.2}, 1, {0, 0});
    const Contact met = contact(a, b);
    ASSERT_TRUE(met.first);
    const ContactPlace place = contact_place(met.first, a, b, met.times.t_enter);
    EXPECT_NEAR((place.normal - Vec2(0.8, 0.6)).norm(), 0, 1e-15) << far;
  }
}

TEST(RoundContact, WhatLiesInEachOtherTellsTheShortestWayApart) {
  const Body square = {kUnitSquare, {0, 0}, 0};
  const Body right = {{{0.75, 0.25}, {2, 0.25}, {2, 0.75}}, {0, 0}, 0};
  EXPECT_EQ(resting_place(square, right, 0).normal, Vec2(1, 0));
  EXPECT_EQ(resting_place(right, square, 0).normal, Vec2(-1, 0));
  EXPECT_EQ(resting_place(square, round_body({0.5, 1.5}, 1, {0, 0}), 0).normal, Vec2(0, 1));
  const ContactPlace corner = resting_place(round_body({4, 5}, 6, {0, 0}), square, 0);
  EXPECT_NEAR((corner.normal - Vec2(-0.6, -0.8)).norm(), 0, 1e-15);
  EXPECT_NEAR((corner.point - Vec2(0.4, 0.2)).norm(), 0, 1e-15);
  // Touching exactly, at rest: the side it lies on.
  const Body beside = {{{1, 0.5}, {2, 0}, {2, 1}}, {0, 0}, 0};
  EXPECT_EQ(resting_place(square, beside, 0).normal, Vec2(1, 0));
}

// A square in the middle of another has four ways out.
TEST(RoundContact, OfEquallyShortWaysOutOneIsToldInNoOrder) {
  const std::vector<Vec2> small = {{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}};
  const std::pair<Vec2, Vec2> cases[] = {{{-1, 0}, {1, 0}}, {{1, 0.5}, {-1, 0}},
                                         {{1, 1}, {-1, 0}}, {{-1, 1}, {1, 0}},
                                         {{0, -2}, {0, 1}}, {{-1, 3}, {0, -1}}};
  for (const auto& [velocity, normal] : cases)
    for (std::size_t turn = 0; turn < 4; ++turn) {
      std::vector<Vec2> ring = small;
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(turn), ring.end());
      const Body one = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {0, 0}, 0};
      const Body other = {ring, velocity, 0};
      EXPECT_EQ(resting_place(one, other, 0).normal, normal) << velocity << turn;
      EXPECT_EQ(resting_place(other, one, 0).normal, -normal) << velocity << turn;
    }
}

TEST(RoundContact, ACapsuleIsASegmentWithARadius) {
  const Body capsule = {{{0, -1}, {0, 1}}, {0, 0}, 1};
  EXPECT_EQ(meet(round_body({-8, 0.5}, 1, {2, 0}), capsule).t_enter, 3);
  EXPECT_EQ(meet(round_body({-8, 2.2}, 1, {2, 0}), capsule).t_enter, 4 - 0.8);
  EXPECT_EQ(meet({{{-8, 5}, {-6, 5}}, {1, -1}, 0.5}, capsule).kind, HitClass::through);
}

TEST(RoundContact, WithoutRelativeMotionTheStartDecides) {
  const Vec2 v(1, 2);
  EXPECT_EQ(meet(round_body({0, 0}, 2, v), round_body({3, 4}, 3, v), kLine).kind, HitClass::touch);
  EXPECT_EQ(meet(round_body({0, 0}, 2, v), round_body({3, 4}, 3.5, v), kLine).kind,
            HitClass::through);
  EXPECT_EQ(meet(round_body({0, 0}, 2, v), round_body({3, 4}, 2.5, v), kLine).kind, HitClass::miss);
  EXPECT_EQ(meet(round_body({0.5, 0.5}, 0.1, v), {kUnitSquare, v, 0}, kLine).kind,
            HitClass::through);
  EXPECT_EQ(meet(round_body({0.5, 2}, 1, v), {kUnitSquare, v, 0}, kLine).kind, HitClass::touch);
}

// A core of whole numbers with a radius, so that touching is frequent.
Body drawn_body(Draw& draw) {
  const double x = draw.below(14) - 7, y = draw.below(14) - 7;
  const double vx = draw.below(5) - 2, vy = draw.below(5) - 2;
  const double half = draw.below(3) * 0.5, radius = half + (draw.below(4) == 0 ? 1e-3 : 0);
  const Vec2 at(x, y);
  const int n = static_cast<int>(draw.below(3));
  if (n == 0) return {{at}, {vx, vy}, radius};
  const double w = 1 + draw.below(3), h = draw.below(3);
  if (n == 1) return {{at, at + Vec2(w, h)}, {vx, vy}, radius};
  return {{at, at + Vec2(w, 0), at + Vec2(w, 1 + h), at + Vec2(0, 1)}, {vx, vy}, radius};
}

TEST(RoundContact, AgreesWithDistancesInRationals) {
  int met_count = 0, missed = 0;
  for (std::uint64_t item = 0; item < 1500; ++item) {
    Draw draw(51, 40, item);
    const Body a = drawn_body(draw), b = drawn_body(draw);
    if (non_convex_vertex(a.ring) || non_convex_vertex(b.ring)) continue;
    if (a.velocity == b.velocity || a.radius + b.radius == 0) continue;
    SCOPED_TRACE(item);
    const HitInterval met = meet(a, b, kLine);
    const oracle::ContactTruth truth = oracle::contact_truth(a, b, kLine);
    ASSERT_EQ(met.kind, truth.kind);
    ASSERT_EQ(met.start, truth.start);
    ++(met ? met_count : missed);
    if (!met) continue;
    // One ulp before the first time they are apart, one after it no more.
    const Rational before(std::nextafter(met.t_enter, -kInfinity)),
        after(std::nextafter(met.t_exit, kInfinity));
    ASSERT_EQ(oracle::apart_at(a, b, before), Sign::positive);
    ASSERT_EQ(oracle::apart_at(a, b, after), Sign::positive);
    const double in = std::nextafter(met.t_enter, kInfinity),
                 out = std::nextafter(met.t_exit, -kInfinity);
    if (in > out) continue;
    const Sign inside = met.kind == HitClass::through ? Sign::negative : Sign::zero;
    ASSERT_EQ(oracle::apart_at(a, b, Rational(in)), inside);
    ASSERT_EQ(oracle::apart_at(a, b, Rational(out)), inside);
    ASSERT_EQ(met, meet(b, a, kLine));
  }
  EXPECT_GT(met_count, 200);
  EXPECT_GT(missed, 200);
}

}  // namespace
}  // namespace flatray
