// needs: mpfr
#include "precise/ball.h"

#include <gtest/gtest.h>

#include <cmath>

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

// However many bits are asked for: rationals that no double has were 2^-1073 off at best.
TEST(Ball, ARationalIsKnownToItsBits) {
  const Ball third(Rational(1) / Rational(3), 4096);
  Ball little = ball(0x1p-1000, 4096);
  little = little * little * little * little;
  const Ball off = third * ball(3, 4096) - ball(1, 4096);
  EXPECT_EQ((off + little).sign(), Sign::positive);
  EXPECT_EQ((off - little).sign(), Sign::negative);
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

// Of thirds, whose sum of doubles never ends, and of numbers at the ends of the doubles and beyond.
TEST(Ball, ARationalNumberIsWithinIts) {
  for (const Rational& exact :
       {Rational(1) / 3, Rational(-1e300) / 7, Rational(5e-324) / 3, Rational(1e300) * 1e300,
        Rational(-1e300) * 1e300 * 1e300 * 1e300 / 3, Rational(0.1) * 0.1 * 0.1 * 0.1,
        Rational(1) + Rational(0x1p-500), Rational(0)})
    for (const int bits : {53, 128, 1000}) {
      const Ball close(exact, bits);
      for (const double hair : {0x1p-40, -0x1p-40}) {
        const Ball beside(exact * (Rational(1) + hair), bits);
        const auto order = (close - beside).sign();
        const auto truth = (-(exact * hair)).sign();
        EXPECT_TRUE(order == truth || !order || truth == Sign::zero);
        EXPECT_TRUE(order || std::fabs(exact.nearest()) < 1e-300);
      }
      const auto off = (close * ball(3, bits) - Ball(exact * 3, bits)).sign();
      EXPECT_EQ(off.value_or(Sign::zero), Sign::zero);
    }
  EXPECT_EQ((Ball(Rational(0.75), 53) - ball(0.75)).sign(), Sign::zero);
  const Ball beyond(Rational(1e300) * 1e300, 128);
  EXPECT_EQ((beyond - ball(1e300) * ball(1e300)).sign(), Sign::zero);
  EXPECT_EQ(beyond.nearest(), std::nullopt);
}

TEST(Ball, IsItsMiddleAndItsRest) {
  const Ball third = ball(1) / ball(3);
  EXPECT_EQ((third.middle() - third.middle()).sign(), Sign::zero);
  EXPECT_EQ(third.rest().sign(), std::nullopt);
  EXPECT_EQ(third.middle().rest().sign(), Sign::zero);
  EXPECT_EQ((third.middle() + third.rest() - third).sign(), std::nullopt);
}

// Its double is off by what the double rounds, and by what is not known of the ball.
TEST(Ball, IsNearItsDouble) {
  const Near rounded = near_of(Ball(0x1p60, 100) + Ball(1, 100));
  EXPECT_EQ(rounded.value(), 0x1p60);
  EXPECT_GE(rounded.error(), 1);
  EXPECT_LE(rounded.error(), 1.001);
  const Near unknown = near_of(ball(3) + either_root(ball(4)));
  EXPECT_EQ(unknown.value(), 3);
  EXPECT_GE(unknown.error(), 2);
  EXPECT_LE(unknown.error(), 2.001);
  EXPECT_EQ(near_of(ball(-7)).sign(), Sign::negative);
  EXPECT_EQ(near_of(ball(1) / (ball(1) - ball(1))).sign(), std::nullopt);
}

// Of a number whose sign is open, as far as it may be positive: here up to 2^-126 or so.
TEST(Ball, EitherRootHoldsBoth) {
  const Ball open = ball(1) / ball(3) * ball(3) - ball(1), root = either_root(open);
  EXPECT_EQ(root.sign(), std::nullopt);
  EXPECT_EQ((root + ball(0x1p-62)).sign(), Sign::positive);
  EXPECT_EQ((either_root(ball(4)) - ball(1.999)).sign(), std::nullopt);
  EXPECT_EQ((either_root(ball(4)) + ball(1.999)).sign(), std::nullopt);
  EXPECT_EQ((either_root(ball(4)) - ball(2.001)).sign(), Sign::negative);
}

// Expressions that cancel to the last bit or altogether, in few bits: what is told is what the
// rationals say, and much is told.
TEST(Ball, WhatIsToldIsWhatTheRationalsSay) {
  int signs = 0, doubles = 0, zeros = 0, all = 0;
  for (int i = 1; i < 400; ++i) {
    const double a = i / 7.0, b = 1 / (i + 0.3), c = (i - 200.5) / 3;
    const Rational x = a, y = b, z = c;
    const auto check = [&](const Ball& value, const Rational& exact) {
      ++all;
      if (const auto sign = value.sign()) {
        EXPECT_EQ(*sign, exact.sign());
        ++signs;
      } else if (exact.sign() == Sign::zero) {
        ++zeros;
      }
      if (const auto nearest = value.nearest()) {
        EXPECT_EQ(*nearest, exact.nearest());
        ++doubles;
      }
    };
    for (const int bits : {53, 56, 64, 110}) {
      const Ball p = ball(a, bits), q = ball(b, bits), r = ball(c, bits);
      check(p / q * q - p, Rational(0));
      check(square_root(p) * square_root(p) - p, Rational(0));
      check((p * q - r) / (p + q), (x * y - z) / (x + y));
      check((p + r) - p - r, Rational(0));
      check((p * p - q * q) - (p - q) * (p + q), Rational(0));
      check(p * q - ball(a * b, bits), x * y - a * b);
      check(p / q - ball(a / b, bits), x / y - a / b);
    }
  }
  EXPECT_GT(signs, all / 4);
  EXPECT_GT(doubles, all / 8);
  EXPECT_GT(zeros, all / 8);  // zero, and the radius says that it may be another
}

}  // namespace
}  // namespace flatray
