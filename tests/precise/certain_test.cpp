// needs: mpfr
#include "precise/certain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flatray {
namespace {

Certain number(double x) { return {x, 128}; }

TEST(Certain, RootsOfOneKindCancelWithoutError) {
  const Certain two = square_root(number(2)), eight = square_root(number(8)),
                half = square_root(number(0.5));
  EXPECT_EQ((two + two - eight).sign(), Sign::zero);
  EXPECT_EQ((two * half - number(1)).sign(), Sign::zero);
  EXPECT_EQ((number(1) / (two - number(1)) - two - number(1)).sign(), Sign::zero);
  EXPECT_EQ((eight / half).nearest(), 4);
  EXPECT_TRUE((two * two).rational());
  EXPECT_EQ(square_root(number(6.25)).nearest(), 2.5);
  EXPECT_TRUE(square_root(number(6.25)).rational());
}

TEST(Certain, RootsOfTwoKindsAreBalls) {
  const Certain two = square_root(number(2)), three = square_root(number(3));
  EXPECT_EQ((two + three - three - two).sign(), std::nullopt);
  EXPECT_FALSE((two * three).exact());
  EXPECT_EQ((two * three).nearest(), std::sqrt(6));
  EXPECT_EQ((three - two).sign(), Sign::positive);
  EXPECT_EQ(square_root(two).nearest(), std::sqrt(std::sqrt(2.0)));
}

// 2^-200 beside a root, which a ball of 128 bits does not tell.
TEST(Certain, TellsSignsAndMiddlesThatBallsDoNot) {
  const Certain two = square_root(number(2)), hair = number(0x1p-200);
  EXPECT_EQ((two * two - number(2) + hair).sign(), Sign::positive);
  EXPECT_EQ((two.blurred() * two.blurred() - number(2) + hair).sign(), std::nullopt);
  const Certain middle = number(1) + number(0x1p-53);
  EXPECT_EQ(middle.nearest(), 1);
  EXPECT_EQ((middle + hair).nearest(), 1 + 0x1p-52);
  EXPECT_EQ((middle - hair).nearest(), 1);
}

TEST(Certain, BitsAreThoseOfTheLongestPart) {
  EXPECT_EQ(number(255).bits(), 8U);
  EXPECT_EQ((square_root(number(5)) + number(1023) / number(3)).bits(), 9U);
  EXPECT_EQ((square_root(number(5)) + number(1024)).blurred().bits(), 128U);
}

}  // namespace
}  // namespace flatray
