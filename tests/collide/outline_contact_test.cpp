#include "collide/outline_contact.h"

#include <gtest/gtest.h>

#include <numbers>

#include "anim/scenes.h"
#include "collide/carried_contact.h"
#include "collide/turning_contact.h"
#include "full_counts.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;

constexpr double kTurn = 2 * std::numbers::pi;

CarriedShape turning(const Shape& shape, const Vec2& at, const Vec2& velocity, double angle,
                     double spin) {
  return {&shape, {even_motion(at, velocity, angle, spin)}};
}

// What is told of parts that begin together is that of the first, however many were joined before.
TEST(OutlineContact, WhatIsJoinedInPartsIsWhatIsJoinedAtOnce) {
  for (const std::size_t before : {1U, 17U, 50U, 99U}) {
    std::vector<MeetingPart> all;
    for (int i = 0; i < 100; ++i)
      all.push_back({{static_cast<double>(i % 2), 3},
                     HitClass::through,
                     StartPlace::outside,
                     {i, 0},
                     {1, 0}});
    std::vector<MeetingPart> some(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(before));
    join(some);
    some.insert(some.end(), all.begin() + static_cast<std::ptrdiff_t>(before), all.end());
    join(some);
    join(all);
    ASSERT_EQ(all.size(), 1U);
    ASSERT_EQ(some.size(), 1U);
    EXPECT_EQ(all[0].point, Vec2(0, 0));
    EXPECT_EQ(some[0].point, Vec2(0, 0)) << before;
  }
}

// A bar that goes round once meets a disc beside its axle with one arm, then with the other.
TEST(OutlineContact, EachArmOfWhatTurnsInOneFrameIsAMeetingOfItsOwn) {
  const Shape bar = testing::box({-3, -0.05}, {3, 0.05});
  Shape disc;
  disc.circles = {{{0, 0}, 0.1}};
  const CarriedShape propeller = turning(bar, {0, 0}, {0, 0}, kTurn / 4, kTurn);
  const CarriedShape post = turning(disc, {2, 0}, {0, 0}, 0, 0);
  const std::vector<MeetingPart> met = carried_shapes_meet(propeller, post);
  ASSERT_EQ(met.size(), 2U);
  const double half = std::asin(0.15 / 2) / kTurn;
  for (int i = 0; i < 2; ++i) {
    const MeetingPart& part = met[static_cast<std::size_t>(i)];
    EXPECT_NEAR(part.times.low, 0.25 + 0.5 * i - half, 1e-11);
    EXPECT_NEAR(part.times.high, 0.25 + 0.5 * i + half, 1e-11);
    EXPECT_TRUE(part.certain);
    EXPECT_LE(part.width, kTurningWidth);
    EXPECT_EQ(part.kind, HitClass::through);
    EXPECT_EQ(part.start, StartPlace::outside);
  }
  // Of four arms, and for three turns, twelve times.
  Shape cross = bar;
  const Shape upright = testing::box({-0.05, -3}, {0.05, 3});
  cross.vertices.insert(cross.vertices.end(), upright.vertices.begin(), upright.vertices.end());
  cross.edges.insert(cross.edges.end(), upright.edges.begin(), upright.edges.end());
  cross.begin.push_back(8);
  EXPECT_EQ(carried_shapes_meet(turning(cross, {0, 0}, {0, 0}, kTurn / 8, 3 * kTurn), post).size(),
            12U);
}

// Whoever looks at many instants sees them overlap in the meetings, and nowhere else.
TEST(OutlineContact, MeetingsOfWhatTurnsAreThoseOfAllItsInstants) {
  constexpr int kInstants = kSanitized ? 400 : 2000;
  std::size_t several = 0;
  for (std::uint64_t item = 0; item < 60; ++item) {
    Draw draw(41, 1, item);
    const double long_a = 1 + 2 * draw.unit(), long_b = 0.5 + draw.unit();
    const Shape a = testing::box({-long_a, -0.1}, {long_a, 0.1});
    const Shape b = testing::box({-long_b, -0.2}, {long_b, 0.2});
    const double vx = 2 * draw.unit() - 1, vy = 2 * draw.unit() - 1, x = 4 * draw.unit() - 2,
                 y = 4 * draw.unit() - 2;
    const double angle_a = 6 * draw.unit(), spin_a = 30 * draw.unit() - 15,
                 angle_b = 6 * draw.unit(), spin_b = 30 * draw.unit() - 15;
    const auto at = [&](double t) {
      return std::pair(
          MovingShape{&a, pose({0, 0}, angle_a + t * spin_a), {0, 0}},
          MovingShape{&b, pose(Vec2(x, y) + t * Vec2(vx, vy), angle_b + t * spin_b), {0, 0}});
    };
    const std::vector<MeetingPart> met = carried_shapes_meet(
        turning(a, {0, 0}, {0, 0}, angle_a, spin_a), turning(b, {x, y}, {vx, vy}, angle_b, spin_b));
    several += met.size() > 1 ? 1 : 0;
    for (int i = 0; i <= kInstants; ++i) {
      const double t = static_cast<double>(i) / kInstants;
      const auto [one, other] = at(t);
      const bool overlaps = !shapes_meet(one, other, {0, 0}).empty();
      bool told = false, near = false;
      for (const MeetingPart& part : met) {
        told |= part.times.low <= t && t <= part.times.high;
        near |= std::fabs(t - part.times.low) < 1e-10 || std::fabs(t - part.times.high) < 1e-10;
      }
      EXPECT_TRUE(told == overlaps || near) << item << ' ' << t;
    }
  }
  EXPECT_GT(several, 15U);
}

// The arrow (0, 0), (4, 0), (4, 4), (2, 1), (0, 4), cut from (0, 0) to (2, 1).
Shape arrow() {
  Shape shape;
  shape.vertices = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 0}, {2, 1}, {0, 4}};
  shape.edges = {0, 1, 2, -1, -1, 3, 4};
  shape.begin = {0, 4, 7};
  return shape;
}
Shape segment(const Vec2& a, const Vec2& b) {
  Shape shape;
  shape.segments = {{a, b}};
  return shape;
}

// Asked alone and, of several, together.
std::vector<MeetingPart> both_ways(const Shape& a, const Shape& b, const Vec2& at,
                                   const Vec2& velocity, Range within) {
  const MovingShape bodies[] = {{&a, pose({0, 0}, 0), {0, 0}}, {&b, pose(at, 0), velocity}};
  const std::vector<MeetingPart> alone = shapes_meet(bodies[0], bodies[1], within);
  const std::pair<std::uint32_t, std::uint32_t> pairs[] = {{0, 1}, {1, 0}, {0, 1}};
  for (const auto& met : pairs_meet(bodies, pairs, within, 1)) {
    EXPECT_EQ(met.size(), alone.size());
    for (std::size_t i = 0; i < std::min(met.size(), alone.size()); ++i) {
      EXPECT_EQ(met[i].kind, alone[i].kind);
      EXPECT_EQ(met[i].start, alone[i].start);
    }
  }
  return alone;
}

TEST(OutlineContact, WhatLiesOnACutIsInside) {
  const Shape outline = arrow(), bit = segment({0, 0}, {0.0625, 0.03125});
  Shape dot;
  dot.circles = {{{0, 0}, 0}};
  for (const Shape* shape : {&bit, static_cast<const Shape*>(&dot)})
    for (const Vec2& velocity : {Vec2(0.25, 0.125), Vec2(-0.25, -0.125), Vec2(0.25, 0), Vec2(0, 0)})
      for (const Range within : {Range{0, 1}, Range{0, 0}}) {
        const auto met = both_ways(outline, *shape, {1, 0.5}, velocity, within);
        ASSERT_EQ(met.size(), 1U);
        EXPECT_EQ(met[0].kind, HitClass::through);
        EXPECT_EQ(met[0].start, StartPlace::inside);
      }
}

TEST(OutlineContact, TheEndsOfACutAreOutline) {
  const Shape outline = arrow(), bit = segment({0, 0}, {2, 1});
  const auto at_corner = both_ways(outline, bit, {-2, -1}, {0, 0}, {0, 1});
  ASSERT_EQ(at_corner.size(), 1U);
  EXPECT_EQ(at_corner[0].kind, HitClass::touch);
  EXPECT_EQ(at_corner[0].start, StartPlace::boundary);
  const auto leaves = both_ways(outline, bit, {-2, -1}, {-2, -1}, {0, 1});
  ASSERT_EQ(leaves.size(), 1U);
  EXPECT_EQ(leaves[0].kind, HitClass::touch);
  const auto comes = both_ways(outline, bit, {-4, -2}, {2, 1}, {0, 1.5});
  ASSERT_EQ(comes.size(), 1U);
  EXPECT_EQ(comes[0].times.low, 1);
  EXPECT_EQ(comes[0].kind, HitClass::through);
  EXPECT_EQ(comes[0].start, StartPlace::outside);
  // Along a side of the outline it is still along.
  const auto side = both_ways(outline, segment({0, 0}, {1, 0}), {1, 0}, {1, 0}, {0, 1});
  ASSERT_EQ(side.size(), 1U);
  EXPECT_EQ(side[0].kind, HitClass::along);
  EXPECT_EQ(side[0].start, StartPlace::boundary);
}

}  // namespace
}  // namespace flatray
