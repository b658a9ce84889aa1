#include "geom/exact.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "base/philox.h"

namespace flatray {
namespace {

std::uint64_t bits_of(std::uint64_t item) { return random_bits(3, Stream::test, 0, item, 0); }

double any_finite(std::uint64_t item) {
  const double x = std::bit_cast<double>(bits_of(item));
  return std::isfinite(x) ? x : 0;
}

TEST(Rational, HoldsEveryDouble) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const double x = any_finite(i);
    EXPECT_EQ(Rational(x).nearest(), x);
  }
  for (const double x : {5e-324, -5e-324, 0x1p-1022, 0x1.fffffffffffffp1023, 0.0})
    EXPECT_EQ(Rational(x).nearest(), x);
}

// Half-way between neighbours it rounds to the even one; a hair beyond, to that side. Subnormals
// too.
TEST(Rational, RoundsHalvesToEven) {
  const Rational hair = Rational(0x1p-1074) * 0x1p-200;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const double x =
        i % 2 == 0 ? std::fabs(any_finite(i)) : std::ldexp(1.0 + static_cast<double>(i), -1074);
    const double next = std::nextafter(x, 2 * x + 1);
    if (std::isinf(next)) continue;
    const Rational middle = (Rational(x) + next) / 2;
    EXPECT_EQ(middle.nearest(), (std::bit_cast<std::uint64_t>(x) & 1) == 0 ? x : next);
    EXPECT_EQ((middle + hair).nearest(), next);
    EXPECT_EQ((middle - hair).nearest(), x);
    EXPECT_EQ((-middle - hair).nearest(), -next);
  }
}

TEST(Rational, BelowHalfTheLeastIsZeroAndBeyondTheLargestInfinite) {
  EXPECT_EQ((Rational(5e-324) / 2).nearest(), 0);
  EXPECT_EQ((Rational(5e-324) * 0.75).nearest(), 5e-324);
  const double largest = 0x1.fffffffffffffp1023;
  EXPECT_EQ((Rational(largest) + 0x1p969).nearest(), largest);
  EXPECT_TRUE(std::isinf((Rational(largest) + 0x1p970).nearest()));  // half-way to 2^1024
  EXPECT_EQ((Rational(largest) * -2).nearest(), -kInfinity);
}

TEST(Rational, ComputesFractions) {
  EXPECT_EQ((Rational(1) / 3 + Rational(1) / 6).text(), "1/2");
  EXPECT_EQ((Rational(-7) / 2).floor().text(), "-4");
  EXPECT_LT(Rational(0.1) + 0.2, Rational(3) / 10 + 0x1p-54);
  EXPECT_GT(Rational(0.1) + 0.2, Rational(3) / 10);
  EXPECT_EQ((Rational(1) / 3).nearest(), 1.0 / 3);
}

TEST(Rational, CopiesAreIndependent) {
  Rational a = 5, b = a, c = std::move(a);
  b += 1;
  EXPECT_EQ(c.text(), "5");
  EXPECT_EQ(b.text(), "6");
  c = b;
  b = std::move(c);
  EXPECT_EQ(b.text(), "6");
}

TEST(Rational, RootSignDecidesCancellation) {
  EXPECT_EQ(Rational::root_sign(-3, 1, 9), Sign::zero);
  EXPECT_EQ(Rational::root_sign(-3, 1, Rational(9) + 0x1p-1000), Sign::positive);
  EXPECT_EQ(Rational::root_sign(3, -1, Rational(9) + 0x1p-1000), Sign::negative);
  EXPECT_EQ(Rational::root_sign(0, -1, 2), Sign::negative);
  EXPECT_EQ(Rational::root_sign(-1, 0, 2), Sign::negative);
}

TEST(Rational, SignOfTwoRootsOfWhichSomeAreZero) {
  for (const int s : {-1, 1}) {
    EXPECT_EQ(Rational::two_root_sign(0, s, 0, s, 0), Sign::zero);
    EXPECT_EQ(Rational::two_root_sign(0, s, 0, -s, 0), Sign::zero);
    EXPECT_EQ(Rational::two_root_sign(0, s, 0, -s, 2), static_cast<Sign>(-s));
    EXPECT_EQ(Rational::two_root_sign(0, -s, 2, s, 0), static_cast<Sign>(-s));
    EXPECT_EQ(Rational::two_root_sign(-3, 1, 9, s, 0), Sign::zero);
    EXPECT_EQ(Rational::two_root_sign(s, s, 0, s, 0), static_cast<Sign>(s));
  }
}

// The double x is nearest when p + s sqrt(q) lies between the middles to its neighbours.
TEST(Rational, RootSumIsTheNearestDoubleAlsoWhereItCancels) {
  EXPECT_EQ(Rational::root_sum(0, 1, 2), std::sqrt(2.0));
  EXPECT_EQ(Rational::root_sum(-3, 1, 9), 0);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const double r = unit_double(bits_of(i)) * std::ldexp(1.0, static_cast<int>(i % 40) - 20);
    const Rational p = -r, q = Rational(r) * r * (1 + std::ldexp(1.0, -static_cast<int>(i % 50)));
    const int s = i % 3 == 0 ? -1 : 1;
    const double x = Rational::root_sum(p, s, q);
    const Rational above = (Rational(x) + std::nextafter(x, kInfinity)) / 2;
    const Rational below = (Rational(x) + std::nextafter(x, -kInfinity)) / 2;
    EXPECT_NE(Rational::root_sign(p - above, s, q), Sign::positive);
    EXPECT_NE(Rational::root_sign(p - below, s, q), Sign::negative);
  }
}

TEST(Rational, HasAnExactRootWhereThatIsRational) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Rational root = Rational(std::fabs(any_finite(i))) / Rational(static_cast<double>(i + 1));
    EXPECT_EQ(Rational::exact_root(root * root), root);
    if (root.sign() == Sign::zero) continue;
    for (const double factor : {2.0, 3.0, 0.5})
      EXPECT_FALSE(Rational::exact_root(root * root * factor).has_value());
  }
  EXPECT_EQ(Rational::exact_root(Rational(0)), Rational(0));
}

// The convergents p/q of sqrt(2) lie below and above it in turn, by some 0.35 / q^2: far less than
// what is computed of the root. So the sum lies beside the middle of two doubles, at 1 + 2^-53.
TEST(Rational, RootSumsBesideAMiddleAreRoundedToTheirSide) {
  Rational p = 1, q = 1;
  bool below = true;
  for (int i = 0; i < 120; ++i, below = !below) {
    const Rational next = p + q + q;
    q = p + q;
    p = next;
    if (i < 80) continue;
    const Rational middle = Rational(1) + 0x1p-53;
    const bool is_below = !below;  // of the convergent just made
    EXPECT_EQ(Rational::root_sum(middle - p / q, 1, 2), is_below ? 1 + 0x1p-52 : 1.0) << i;
    EXPECT_EQ(Rational::root_sum(middle + p / q, -1, 2), is_below ? 1.0 : 1 + 0x1p-52) << i;
  }
}

TEST(Rational, RootSumsThatAreAMiddleGoToTheEvenSide) {
  for (const auto& [root, sum] : {std::pair{0x1p-53, 1.0}, {0x3p-53, 1 + 0x1p-51}})
    EXPECT_EQ(Rational::root_sum(1, 1, Rational(root) * root), sum);
}

}  // namespace
}  // namespace flatray
