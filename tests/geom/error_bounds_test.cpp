#include "geom/error_bounds.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "geom/clip_cases.h"
#include "geom/decide.h"
#include "geom/enclosure.h"

namespace flatray {
namespace {

double magnitude(double x) { return x < 0 ? -x : x; }
double size_of(const Rational& x) { return magnitude(x.nearest()); }

// Numbers of all bits, a few binades apart.
double number(Draw& draw) {
  return draw.sign() * std::ldexp(1 + draw.unit(), static_cast<int>(draw.below(6)));
}

// A determinant of few or no common bits, and one that all but cancels: b - a and d - c are then
// parallel but for rounding.
struct Corners {
  Vec2 a, b, c, d;
  Corners(Draw& draw, bool parallel)
      : a(number(draw), number(draw)),
        b(number(draw), number(draw)),
        d(number(draw), number(draw)) {
    c = parallel ? Vec2(d - 0.7 * (b - a)) : Vec2(number(draw), number(draw));
  }
  template <class Make>
  auto determinant(const Make& make) const {
    return flatray::determinant(make, a, b, c, d);
  }
};

// The greatest share of a bound that is used, largest over seeded draws.
TEST(ErrorBounds, TheFilterOfADeterminantHolds) {
  double worst = 0;
  int sure = 0;
  for (int item = 0; item < 20000; ++item) {
    Draw draw = draw_of(70, item);
    const Corners corners(draw, item % 2 == 0);
    const auto terms = corners.determinant(kCounted);
    const Rational exact = corners.determinant(kRational);
    worst = std::max(worst, size_of(exact - terms.value) / Near(terms).error());
    if (terms.sure_sign() == Sign::zero) continue;
    ++sure;
    EXPECT_EQ(terms.sure_sign(), exact.sign());
  }
  fmt::print("worst error over bound: {:.3f} of a determinant of doubles; {} of 20000 signs sure\n",
             worst, sure);
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0.25);  // else the draws are too easy to say anything
  EXPECT_GT(sure, 10000);
}

// t = (a x b) / (d x b - d x a), as SegmentFilter has it.
TEST(ErrorBounds, TheTimeOfASegmentIsWithinItsBounds) {
  double worst = 0;
  const auto time = [](const auto& make, const Vec2& o, const Vec2& d, const Segment& wall) {
    const auto a = pair_of(make, wall.a) - pair_of(make, o);
    const auto b = pair_of(make, wall.b) - pair_of(make, o);
    return std::pair(cross(a, b), cross(pair_of(make, d), b) - cross(pair_of(make, d), a));
  };
  for (int item = 0; item < 20000; ++item) {
    Draw draw = draw_of(73, item);
    const Corners corners(draw, item % 2 == 0);
    const Segment wall{corners.a, corners.c};
    const auto terms = time(kCounted, corners.b, corners.d, wall);
    const auto exact = time(kRational, corners.b, corners.d, wall);
    const Near t = Near(terms.first) / Near(terms.second);
    for (const auto& [near, number] :
         {std::pair(Near(terms.first), exact.first), {Near(terms.second), exact.second}}) {
      EXPECT_LE(size_of(number - near.value()), near.error());
      worst = std::max(worst, size_of(number - near.value()) / near.error());
    }
    if (exact.second.sign() == Sign::zero) continue;
    const Rational quotient = exact.first / exact.second;
    EXPECT_FALSE(quotient < Rational(t.low()) && t.low() > -kInfinity);
    EXPECT_FALSE(quotient > Rational(t.high()) && t.high() < kInfinity);
  }
  fmt::print("worst error over bound: {:.3f} of a segment's numerator and denominator\n", worst);
  EXPECT_GT(worst, 0.15);
}

struct Worst {
  double ratio = 0, size = 0;
  void see(const Bounded& value, const Rational& exact) {
    const double error = size_of(exact - value.hi() - value.lo());
    if (error == 0) return;
    ratio = std::max(ratio, error / value.error());
    size = std::max(size, error / size_of(exact));
  }
};

TEST(ErrorBounds, BoundedNumbersHoldWhatTheyClaim) {
  Worst sum, product, quotient;
  for (int item = 0; item < 5000; ++item) {
    Draw draw = draw_of(71, item);
    // Two numbers of 106 bits with an error of their own.
    const double p = number(draw), q = number(draw), r = number(draw), s = number(draw);
    const Bounded a = Bounded(p) / Bounded(q), b = Bounded(r) / Bounded(s);
    const Rational ea = Rational(p) / q, eb = Rational(r) / s;
    sum.see(a + b, ea + eb);
    product.see(a * b, ea * eb);
    quotient.see(a / b, ea / eb);
    // r = sqrt(a) within e means (r - e)^2 <= a <= (r + e)^2.
    const Bounded w = square_root(a * a + b * b);
    const Rational middle = Rational(w.hi()) + w.lo(), square = ea * ea + eb * eb;
    EXPECT_LE((middle - w.error()) * (middle - w.error()), square);
    EXPECT_GE((middle + w.error()) * (middle + w.error()), square);
  }
  for (const auto& [name, w] :
       {std::pair("sum", sum), {"product", product}, {"quotient", quotient}}) {
    fmt::print("worst error over bound: {:.3f} of a {}; largest relative error 2^{:.1f}\n", w.ratio,
               name, static_cast<double>(std::ilogb(w.size)));
    EXPECT_LT(w.ratio, 1) << name;
    EXPECT_GT(w.ratio, 0) << name;
  }
}

TEST(ErrorBounds, DoublesWithAnErrorHoldWhatTheyClaim) {
  double worst[4] = {};
  const auto share = [](const Near& value, const Rational& exact) {
    EXPECT_GE(exact, Rational(value.low()));
    EXPECT_LE(exact, Rational(value.high()));
    return size_of(exact - value.value()) / value.error();
  };
  for (int item = 0; item < 5000; ++item) {
    Draw draw = draw_of(74, item);
    const double p = number(draw), q = number(draw), r = number(draw), s = number(draw);
    const Rational ep = p, eq = q;
    worst[0] = std::max(worst[0], share(Near(p) + q, ep + eq));
    worst[1] = std::max(worst[1], share(Near(p) * q, ep * eq));
    worst[2] = std::max(worst[2], share(Near(p) / q, ep / eq));
    const Near a = Near(p) * q, b = Near(r) * s;
    const Rational ea = ep * eq, eb = Rational(r) * s;
    EXPECT_LE(share((a + b) * (a - b) / b, (ea + eb) * (ea - eb) / eb), 1);
    // r = sqrt(a) within e means (r - e)^2 <= a <= (r + e)^2; how far it is off, by its square.
    const Near root = square_root(Near(std::fabs(p)));
    const Rational middle = root.value(), error = root.error(), size = std::fabs(p);
    EXPECT_LE((middle - error) * (middle - error), size);
    EXPECT_GE((middle + error) * (middle + error), size);
    worst[3] =
        std::max(worst[3], size_of(size - middle * middle) / (2 * root.value() * root.error()));
  }
  fmt::print(
      "worst error over bound: {:.3f} of a sum of doubles, {:.3f} of a product, {:.3f} of a "
      "quotient, {:.3f} of a root\n",
      worst[0], worst[1], worst[2], worst[3]);
  for (const double share_used : worst) {
    EXPECT_LE(share_used, 1);
    EXPECT_GT(share_used, 0.25);
  }
}

TEST(ErrorBounds, QuickNumbersHoldWhatTheyClaim) {
  double worst[3] = {}, root = 0;
  const auto share = [](const Quick& value, const Rational& exact) {
    return size_of(exact - value.hi() - value.lo()) / value.error();
  };
  for (int item = 0; item < 5000; ++item) {
    Draw draw = draw_of(72, item);
    const double p = number(draw), q = number(draw), r = number(draw), s = number(draw);
    const Quick a = Quick(p) * q,
                b = Quick(r) * s;  // without error, but for underflow
    const Rational ea = Rational(p) * q, eb = Rational(r) * s;
    worst[0] = std::max(worst[0], share(a + b, ea + eb));
    worst[1] = std::max(worst[1], share(a * b, ea * eb));
    worst[2] = std::max(worst[2], share(a / b, ea / eb));
    EXPECT_LT(share((a + b) * (a - b) / b, (ea + eb) * (ea - eb) / eb), 1);
    worst[0] = std::max(worst[0], share(a * b + b, ea * eb + eb));
    const Quick w = square_root(a * a);
    root = std::max(root, size_of(Rational(std::fabs(a.hi())) - w.hi() +
                                  (a.hi() > 0 ? a.lo() : -a.lo()) - w.lo()) /
                              w.error());
  }
  fmt::print(
      "worst error over bound: {:.3f} of a quick sum, {:.3f} of a product, {:.3f} of a "
      "quotient, {:.3f} of a root\n",
      worst[0], worst[1], worst[2], root);
  for (const double share_used : {worst[0], worst[1], worst[2], root}) EXPECT_LT(share_used, 1);
}

TEST(ErrorBounds, DoublesWithAnErrorAreUnsureOfWhatOverflowsOrUnderflows) {
  EXPECT_FALSE((Near(1e200) * 1e200 - Near(2e200) * 1e200).sign());
  EXPECT_FALSE((Near(1e308) + 1e308).sign());
  EXPECT_FALSE((Near(5e-324) * 0.5).sign());
  EXPECT_FALSE((Near(1) / Near(0)).sign());
  EXPECT_FALSE(square_root(Near(-1)).sign());
  const auto sure = [](double size) {
    const Vec2 zero(0, 0), x(size, size / 2), y(size, size);
    return determinant(kCounted, zero, x, zero, y).sure_sign() != Sign::zero;
  };
  EXPECT_TRUE(sure(1) && sure(1e150) && sure(1e-150));
  EXPECT_FALSE(sure(1e155) || sure(1e-162));
}

TEST(ErrorBounds, QuickNumbersAreUnsureOfWhatOverflowsOrUnderflows) {
  EXPECT_FALSE((Quick(1e200) * 1e200 - Quick(2e200) * 1e200).sign());
  EXPECT_FALSE((Quick(1e308) + 1e308).sign());
  EXPECT_FALSE((Quick(5e-324) * 0.5).sign());
  EXPECT_FALSE((Quick(1) / Quick(0)).sign());
  EXPECT_FALSE(square_root(Quick(-1)).sign());
  EXPECT_FALSE((Quick(1) - Quick(1)).sign());
  EXPECT_FALSE((Quick(1e-310) * Quick(1.5)).nearest());
}

TEST(ErrorBounds, BoundedNumbersAreUnsureOfWhatOverflowsOrUnderflows) {
  EXPECT_FALSE((Bounded(1e200) * 1e200 - Bounded(2e200) * 1e200).sign());
  EXPECT_FALSE((Bounded(1e308) + 1e308).sign());
  EXPECT_FALSE((Bounded(5e-324) * 0.5).sign());
  EXPECT_FALSE((Bounded(5e-324) * 0.5).nearest());
  EXPECT_FALSE((Bounded(1) / (Bounded(1e-200) * 1e-200)).sign());
  EXPECT_FALSE(square_root(Bounded(-1)).nearest());
}

TEST(ErrorBounds, BoundedNumbersOfFewBitsAreExact) {
  const Bounded zero = Bounded(3) * 7 - Bounded(21);
  EXPECT_EQ(zero.error(), 0);
  EXPECT_EQ(zero.sign(), Sign::zero);
  EXPECT_EQ((Bounded(1) / 4).error(), 0);
  EXPECT_EQ(square_root(Bounded(49) / 4).nearest(), 3.5);
  EXPECT_EQ((Bounded(0.1) * 0.3 - Bounded(0.3) * 0.1).sign(), Sign::zero);
}

}  // namespace
}  // namespace flatray
