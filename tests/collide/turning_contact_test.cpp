#include "collide/turning_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/turning_pairs.h"

namespace flatray {
namespace {

using Verdict = TurningContact::Verdict;
constexpr double kWidth = 0x1p-40;

TurningBody body(const oracle::TurningCore& core) {
  return {core.ring, core.radius, even_motion(core.at, core.velocity, core.angle, core.spin)};
}

// Apart before first.low, overlapping at first.high, and the truth between; or truly apart.
void expect_proven(const oracle::TurningPair& pair, const TurningContact& met) {
  const oracle::FirstTouch truth = oracle::first_touch(pair.a, pair.b, 1);
  if (truth.kind == oracle::FirstTouch::Kind::unknown) return;
  const bool touch = truth.kind == oracle::FirstTouch::Kind::touch;
  if (met.verdict != Verdict::undecided) {
    EXPECT_EQ(met.verdict == Verdict::meets, touch);
  }
  if (!touch) return;
  EXPECT_LE(met.first.low, truth.high);
  EXPECT_GE(met.first.high, truth.low);
  if (met.verdict == Verdict::meets) {
    EXPECT_EQ(oracle::apart_at(pair.a, pair.b, met.first.high), -1);
  }
}

TEST(TurningContact, AgreesWithBisectionInManyBits) {
  for (const oracle::TurningFamily& family : oracle::turning_families()) {
    int met = 0, as_asked = 0, undecided = 0;
    for (std::uint64_t item = 0; item < 60; ++item) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(item));
      const oracle::TurningPair pair = oracle::make_pair(family, 1, item);
      const TurningContact found = turning_contact(body(pair.a), body(pair.b), 1, kWidth);
      expect_proven(pair, found);
      met += found.verdict == Verdict::meets ? 1 : 0;
      undecided += found.verdict == Verdict::undecided ? 1 : 0;
      as_asked += found.first.high - found.first.low <= kWidth ? 1 : 0;
    }
    EXPECT_GT(met, 10) << family.name;
    EXPECT_LT(undecided, 6) << family.name;
    EXPECT_GT(as_asked, 30) << family.name;
  }
}

// A hand of length 2 comes down to a shelf 1 below: sin(angle) = 1/2.
TEST(TurningContact, AHandMeetsAShelf) {
  const std::vector<Vec2> hand = {{0, 0}, {2, 0}}, shelf = {{1, -1}, {1, -9}, {9, -9}, {9, -1}};
  const TurningBody a{hand, 0, even_motion({0, 0}, {0, 0}, 0, -std::numbers::pi / 3)}, b{shelf};
  const TurningContact met = turning_contact(a, b, 1, kWidth);
  ASSERT_EQ(met.verdict, Verdict::meets);
  EXPECT_LE(met.first.low, 0.5);
  EXPECT_GE(met.first.high, 0.5);
  EXPECT_LE(met.first.high - met.first.low, kWidth);
  EXPECT_NEAR((met.place.point - Vec2(std::sqrt(3), -1)).norm(), 0, 1e-11);
  EXPECT_NEAR((met.place.normal - Vec2(0, -1)).norm(), 0, 1e-11);
  EXPECT_EQ(turning_contact(a, b, 1, kWidth, true).first.high, 1);
}

// A side as long as a few of the least doubles has a direction as any other. When the disc meets the
// triangle, which hardly turns, was found by bisection in many bits.
TEST(TurningContact, ASideOfDenormalLengthHasItsNormal) {
  for (const double least : {0x1p-1074, 0x1p-1072, 0x1p-1064}) {
    const std::vector<Vec2> triangle = {{0, 0}, {2 * least, 2 * least}, {-1, 1}}, centre = {{0, 0}};
    const TurningBody a{triangle, 0, even_motion({0, 0}, {0, 0}, 0, 0x1p-20)};
    const TurningBody b{centre, 1, even_motion({2, -2}, {-1.5, 1.5}, 0, 0)};
    const TurningContact met = turning_contact(a, b, 1, kWidth);
    ASSERT_EQ(met.verdict, Verdict::meets);
    EXPECT_LE(met.first.low, 0.86192881255);
    EXPECT_GE(met.first.high, 0.86192881254);
  }
}

// Without spins it is what contact() tells.
TEST(TurningContact, HoldsTheTimeOfStraightMotion) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    oracle::TurningPair pair = oracle::make_pair(oracle::turning_families()[0], 3, item);
    pair.a.angle = pair.b.angle = pair.a.spin = pair.b.spin = 0;
    const TurningBody a = body(pair.a), b = body(pair.b);
    std::vector<Vec2> ring_a, ring_b;
    for (const Vec2& p : a.ring) ring_a.push_back(pair.a.at + p);
    for (const Vec2& p : b.ring) ring_b.push_back(pair.b.at + p);
    const HitInterval exact =
        contact({ring_a, pair.a.velocity}, {ring_b, pair.b.velocity}, {0, 1}).times;
    const TurningContact met = turning_contact(a, b, 1, kWidth);
    ASSERT_EQ(met.verdict == Verdict::meets, exact.kind == HitClass::through) << item;
    if (met.verdict != Verdict::meets) continue;
    EXPECT_LE(met.first.low, exact.t_enter + 1e-14);
    EXPECT_GE(met.first.high, exact.t_enter - 1e-14);
    const Range last = turning_contact(a, b, 1, kWidth, true).first;
    EXPECT_LE(last.low, exact.t_exit + 1e-14);
    EXPECT_GE(last.high, exact.t_exit - 1e-14);
  }
}

TEST(TurningContact, TheSameAtAnyScale) {
  const oracle::TurningPair pair = oracle::make_pair(oracle::turning_families()[1], 5, 2);
  const TurningContact one = turning_contact(body(pair.a), body(pair.b), 1, kWidth);
  for (const int exponent : {-900, -300, 300, 900}) {
    oracle::TurningPair other = pair;
    for (auto* core : {&other.a, &other.b}) {
      for (Vec2& p : core->ring) p *= std::ldexp(1.0, exponent);
      core->at *= std::ldexp(1.0, exponent);
      core->velocity *= std::ldexp(1.0, exponent);
      core->radius *= std::ldexp(1.0, exponent);
    }
    const TurningContact met = turning_contact(body(other.a), body(other.b), 1, kWidth);
    EXPECT_EQ(met.verdict, one.verdict);
    EXPECT_EQ(met.first.low, one.first.low);
    EXPECT_EQ(met.first.high, one.first.high);
  }
}

// Two points are never proven to meet, and a miss by 2^-20 is proven.
TEST(TurningContact, SaysWhatItCannotTell) {
  const std::vector<Vec2> point = {{1, 0}};
  const TurningBody a{point, 0, even_motion({0, 0}, {0, 0}, 0, 1)},
      b{point, 0, even_motion({0.5, 0.75}, {0, 0}, 0, 0)};
  EXPECT_EQ(turning_contact(a, b, 1, kWidth).verdict, Verdict::apart);
  const std::vector<Vec2> origin = {{0, 0}};
  const TurningBody flies{origin, 0, even_motion({-1, 0}, {2, 0}, 0, 0)},
      rests{origin, 0, even_motion({0, 0}, {0, 0}, 0, 1)};
  const TurningContact met = turning_contact(flies, rests, 1, kWidth);
  EXPECT_EQ(met.verdict, Verdict::undecided);
  EXPECT_LE(met.first.low, 0.5);
  EXPECT_GE(met.first.high, 0.5);
  EXPECT_LE(met.first.high - met.first.low, 1e-10);
  const TurningBody passes{origin, 0, even_motion({-1, 0x1p-20}, {2, 0}, 0, 0)};
  EXPECT_EQ(turning_contact(passes, rests, 1, kWidth).verdict, Verdict::apart);
}

// Discs about both overlap, the one in which the rod turns and the wall do not.
TEST(TurningContact, WhatSpinsFasterThanCanBeFollowedIsKnownToMissBesideAWall) {
  const std::vector<Vec2> rod{{-1, 0}, {1, 0}}, wall{{-9, -1}, {9, -1}, {9, 0}, {-9, 0}};
  for (const double spin : {1e3, 1e7, 1e9, 1e12}) {
    const TurningBody fast{rod, 0, even_motion({-5, 1.25}, {10, 0}, 0.5, spin)}, still{wall};
    EXPECT_EQ(turning_contact(fast, still, 1, 0x1p-40).verdict, TurningContact::Verdict::apart);
    EXPECT_EQ(turning_contact(still, fast, 1, 0x1p-40).verdict, TurningContact::Verdict::apart);
    EXPECT_EQ(turning_contact(still, fast, 1, 0x1p-40, true).verdict,
              TurningContact::Verdict::apart);
    const TurningBody low{rod, 0, even_motion({-5, 0.75}, {10, 0}, 0.5, spin)};
    EXPECT_NE(turning_contact(low, still, 1, 0x1p-40).verdict, TurningContact::Verdict::apart);
  }
}

}  // namespace
}  // namespace flatray
