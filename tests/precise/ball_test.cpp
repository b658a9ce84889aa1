// needs: mpfr
#include "precise/ball.h"

#include <gtest/gtest.h>

#include "geom/exact.h"

namespace flatray {
namespace {

Ball ball(double x, int bits = 128) { return {x, bits}; }

TEST(Ball, WhatIsNotRoundedIsExact) {
  EXPECT_EQ((ball(0.5) + ball(-0.5)).sign(), Sign::zero);
  EXPECT_EQ((ball(3) * ball(7) - ball(21)).sign(), Sign::zero);
}

TEST(Ball, AThirdIsRoundedOnceAndItsTripleIsOpenAgainstOne) {
  const Ball third = ball(1) / ball(3);
  EXPECT_EQ(third.nearest(), 1.0 / 3);
  EXPECT_EQ((third * ball(3) - ball(1)).sign(), std::nullopt);
}

TEST(Ball, DividingByWhatMayBeZeroIsUnknown) {
  const Ball open = ball(1) / ball(3) * ball(3) - ball(1);
  EXPECT_EQ((ball(1) / open).sign(), std::nullopt);
  EXPECT_EQ(square_root(open).nearest(), std::nullopt);
  EXPECT_EQ((square_root(ball(-1)) * ball(0)).sign(), std::nullopt);
}

TEST(Ball, MoreBitsTellWhatFewerLeaveOpen) {
  // (1 + 2^-200) - 1, which 128 bits cannot hold
  const auto sign_at = [](int bits) {
    return (ball(1, bits) + ball(0x1p-200, bits) - ball(1, bits)).sign();
  };
  EXPECT_EQ(sign_at(128), std::nullopt);
  EXPECT_EQ(sign_at(256), Sign::positive);
}

// Every result holds the exact one: its distance is within what leaves the sign open.
TEST(Ball, HoldsWhatTheRationalsGive) {
  for (int i = 1; i < 200; ++i) {
    const double a = i / 7.0, b = 1 / (i + 0.3), c = i - 90.5;
    const Ball value = (ball(a, 64) * ball(b, 64) - ball(c, 64)) / (ball(a, 64) + ball(b, 64));
    const Rational exact = (Rational(a) * b - c) / (Rational(a) + b);
    EXPECT_EQ(value.sign(), exact.sign());
    EXPECT_EQ(value.nearest().value_or(exact.nearest()), exact.nearest());
  }
}

}  // namespace
}  // namespace flatray
