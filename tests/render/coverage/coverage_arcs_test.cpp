#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "full_counts.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::Draws;

constexpr double kPi = std::numbers::pi;
constexpr int kArcsSide = 12;
constexpr PixelBox kBox{0, 0, kArcsSide, kArcsSide};

FillArcs whole(const Vec2& centre, const Vec2& u, const Vec2& v) {
  return {ArcPath{{EllipseArc{centre, u, v}}, true}};
}

void expect_near(const Steps& a, const Steps& b, std::uint32_t most) {
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_LE(std::max(a[i], b[i]) - std::min(a[i], b[i]), most) << "pixel " << i;
}

FillArcs random_ellipse(Draws& draws) {
  const Vec2 centre(2 + 8 * draws.unit(), 2 + 8 * draws.unit());
  const double angle = 2 * kPi * draws.unit(), a = 0.3 + 6 * draws.unit(),
               b = a * std::max(draws.unit(), 0.01);
  const Vec2 axis(portable::cos(angle), portable::sin(angle));
  return whole(centre, a * axis, b * Vec2(-axis.y(), axis.x()));
}

// Sign of the ellipse's equation: negative inside.
double outside(const EllipseArc& e, const Vec2& p) {
  const Vec2 d = p - e.centre;
  const double a = cross(d, e.v), b = cross(e.u, d), det = cross(e.u, e.v);
  return a * a + b * b - det * det;
}

// Length of [x0, x1] inside at height y, by bisection from the row's middle point of the ellipse:
// shares no formula with the engine.
double inside_length(const EllipseArc& e, double y, double x0, double x1) {
  const auto f = [&](double x) { return outside(e, {x, y}); };
  double left = -100, right = 100;  // the equation is convex in x: its least value by thirds
  for (int i = 0; i < 90; ++i) {
    const double a = left + (right - left) / 3, b = right - (right - left) / 3;
    (f(a) < f(b) ? right : left) = f(a) < f(b) ? b : a;
  }
  const double middle = 0.5 * (left + right);
  if (!(f(middle) < 0)) return 0;
  const auto border = [&](double out) {
    double in = middle;
    for (int i = 0; i < 50; ++i) {
      const double half = 0.5 * (in + out);
      (f(half) < 0 ? in : out) = half;
    }
    return in;
  };
  return std::max(0.0, std::min(x1, border(100)) - std::max(x0, border(-100)));
}

TEST(ArcCoverage, ATurnedEllipseIsWithinAFewStepsOfItsSampledEquation) {
  constexpr int kParts = 400;
  for (std::uint64_t item = 0; item < times(6); ++item) {
    Draws draws(3, item);
    const FillArcs arcs = random_ellipse(draws);
    const Steps steps = steps_of(arcs, kBox);
    for (int y = 3; y < kArcsSide; y += kSanitized ? 9 : 3)
      for (int x = 0; x < kArcsSide; ++x) {
        double sum = 0;
        for (int i = 0; i < kParts; ++i)
          sum += inside_length(arcs.path.arcs[0], y + (i + 0.5) / kParts, x, x + 1);
        // The middle rule errs by some kParts^-1.5 where the ellipse ends, far less elsewhere.
        EXPECT_NEAR(steps[static_cast<std::size_t>(y * kArcsSide + x)] / double{kFullCoverage},
                    sum / kParts, 2e-4)
            << item << " at " << x << ", " << y;
      }
  }
}

TEST(ArcCoverage, ACircleIsTheDiscWithinAStep) {
  for (std::uint64_t item = 0; item < 200; ++item) {
    Draws draws(4, item);
    const Vec2 centre(12 * draws.unit(), 12 * draws.unit());
    const double r = 7 * draws.unit();
    expect_near(steps_of(whole(centre, {r, 0}, {0, r}), kBox), steps_of(FillRing{centre, r}, kBox),
                1);
  }
}

TEST(ArcCoverage, AnyConjugateHalfDiametersGiveTheSameEllipse) {
  for (std::uint64_t item = 0; item < 100; ++item) {
    Draws draws(5, item);
    const FillArcs arcs = random_ellipse(draws);
    const EllipseArc& e = arcs.path.arcs[0];
    const double t = 6 * draws.unit(), c = portable::cos(t), s = portable::sin(t);
    const Vec2 u = c * e.u + s * e.v, v = c * e.v - s * e.u;
    expect_near(steps_of(arcs, kBox), steps_of(whole(e.centre, u, v), kBox), 1);
    expect_near(steps_of(arcs, kBox), steps_of(whole(e.centre, v, u), kBox), 1);  // the other way
  }
}

TEST(ArcCoverage, ThePixelsSumToTheArea) {
  const auto expect_area = [](const FillArcs& arcs, double wanted) {
    EXPECT_NEAR(covered_area(steps_of(arcs, {0, 0, 40, 40})), wanted, 400.0 / kFullCoverage);
  };
  expect_area(whole({20.3, 19.1}, {9, 4}, {-2, 7}), kPi * 71);
  const Vec2 u(8.25, 0), v(0, 8.25);
  const EllipseArc third{{20.1, 20.2}, u, v, 1, 2};
  expect_area({ArcPath{{third, EllipseArc{{20.1, 20.2}, {0, 0}, {0, 0}}}, true}},
              8.25 * 8.25);  // a sector of 2 radians: r^2 * 2 / 2
  expect_area({ArcPath{{third}, true}}, 8.25 * 8.25 * (2 - portable::sin(2)) / 2);
  const EllipseArc back{{20.1, 20.2}, 0.5 * u, 0.5 * v, 3, -2};
  expect_area({ArcPath{{third, back}, true}}, 0.75 * 8.25 * 8.25);
  const Vec2 right(4, -3), ahead(3, 4);
  expect_area(
      {ArcPath{{{{24, 26}, right, ahead, 0, kPi}, {{15, 14}, -right, -ahead, 0, kPi}}, true}},
      25 * kPi + 10 * 15);  // a capsule of radius 5 and length 15
}

TEST(ArcCoverage, AnyCropGivesTheSamePixels) {
  for (std::uint64_t item = 0; item < 50; ++item) {
    Draws draws(6, item);
    const FillArcs arcs = random_ellipse(draws);
    for (const Coverage mode : {Coverage::area, Coverage::centre}) {
      const Steps all = steps_of(arcs, kBox, mode), part = steps_of(arcs, {3, 4, 5, 6}, mode);
      for (std::size_t y = 0; y < 6; ++y)
        for (std::size_t x = 0; x < 5; ++x)
          ASSERT_EQ(part[y * 5 + x], all[(y + 4) * kArcsSide + x + 3]) << item;
    }
  }
}

TEST(ArcCoverage, ByCentresAPixelIsFullWhereItsCentreIsInside) {
  for (std::uint64_t item = 0; item < 200; ++item) {
    Draws draws(7, item);
    const FillArcs arcs = random_ellipse(draws);
    const Steps steps = steps_of(arcs, kBox, Coverage::centre);
    for (int y = 0; y < kArcsSide; ++y)
      for (int x = 0; x < kArcsSide; ++x) {
        const bool inside = outside(arcs.path.arcs[0], {x + 0.5, y + 0.5}) < 0;
        ASSERT_EQ(steps[static_cast<std::size_t>(y * kArcsSide + x)], inside ? kFullCoverage : 0U);
      }
  }
}

TEST(StiffCases, B13OddEllipsesAreDrawnOrNothing) {
  const double huge = 0x1p500, tiny = 5e-324;
  for (const Vec2& u : {Vec2(0, 0), Vec2(tiny, 0), Vec2(3, 3), Vec2(huge, -huge)})
    for (const Vec2& v : {Vec2(0, 0), Vec2(0, tiny), Vec2(3, 3), Vec2(huge, huge)})
      for (const Vec2& centre : {Vec2(4, 4), Vec2(-huge, huge)})
        for (const Coverage mode : {Coverage::area, Coverage::centre})
          for (const std::uint32_t s : steps_of(whole(centre, u, v), {0, 0, 9, 9}, mode))
            ASSERT_LE(s, kFullCoverage);
  EXPECT_EQ(covered_area(steps_of(whole({4, 4}, {3, 3}, {3, 3}), kBox)), 0);
  EXPECT_EQ(covered_area(steps_of(whole({4, 4}, {1e9, 0}, {0, 1e9}), kBox)), kArcsSide * kArcsSide);
}

}  // namespace
}  // namespace flatray
