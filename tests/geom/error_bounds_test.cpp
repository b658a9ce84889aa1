#include "geom/error_bounds.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "geom/bounded.h"
#include "geom/clip_cases.h"
#include "geom/decide.h"
#include "geom/quick.h"

namespace flatray {
namespace {

double magnitude(double x) { return x < 0 ? -x : x; }
double size_of(const Rational& x) { return magnitude(x.nearest()); }

// Numbers of all bits, a few binades apart.
double number(Draw& draw) {
  return draw.sign() * std::ldexp(1 + draw.unit(), static_cast<int>(draw.below(6)));
}

// The least and greatest share of a bound that is used, largest over seeded draws.
TEST(ErrorBounds, TheFilterOfADeterminantHolds) {
  double worst = 0;
  for (int item = 0; item < 20000; ++item) {
    Draw draw = draw_of(70, item);
    const Vec2 a(number(draw), number(draw)), b(number(draw), number(draw)),
        d(number(draw), number(draw));
    // Nearly parallel: c - a is b - a stretched, so that the products cancel.
    const Vec2 c = item % 2 == 0 ? Vec2(number(draw), number(draw)) : Vec2(a + 0.7 * (d - b));
    const double left = (b.x() - a.x()) * (d.y() - c.y()),
                 right = (b.y() - a.y()) * (d.x() - c.x());
    const Rational exact = determinant([](double x) { return Rational(x); }, a, b, c, d);
    const double error = size_of(exact - (left - right));
    worst = std::max(worst, error / (kDetFilter * (magnitude(left) + magnitude(right))));
  }
  fmt::print("worst error over bound: {:.3f} of the determinant's filter\n", worst);
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0.25);  // else the draws are too easy to say anything
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

TEST(ErrorBounds, QuickNumbersHoldWhatTheyClaim) {
  double worst[3] = {}, root = 0;
  const auto share = [](const Quick& value, const Rational& exact) {
    return size_of(exact - value.hi() - value.lo()) / value.error();
  };
  for (int item = 0; item < 5000; ++item) {
    Draw draw = draw_of(72, item);
    const double p = number(draw), q = number(draw), r = number(draw), s = number(draw);
    const Quick a = Quick::product(p, q),
                b = Quick::product(r, s);  // without error, but for underflow
    const Rational ea = Rational(p) * q, eb = Rational(r) * s;
    worst[0] = std::max(worst[0], share(a + b, ea + eb));
    worst[1] = std::max(worst[1], share(a * b, ea * eb));
    worst[2] = std::max(worst[2], share(a / b, ea / eb));
    EXPECT_LT(share((a + b) * (a - b) / b, (ea + eb) * (ea - eb) / eb), 1);
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
