#include "collide/ellipse_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;
using CurveVerdict = CurvedContact::Verdict;

CurvedBody ellipse(const Ellipse& curve, const Vec2& velocity) {
  return {curve, {{{}, velocity}, 0}};
}

void expect_around(const Range& found, double truth, double width) {
  EXPECT_LE(found.low, truth);
  EXPECT_GE(found.high, truth);
  EXPECT_LE(found.high - found.low, width);
}

TEST(EllipseContact, AgainstABoxAndADiscIsWhereTheAxisComes) {
  const std::vector<Vec2> box = {{5, -1}, {6, -1}, {6, 1}, {5, 1}};
  const CurvedBody flying = ellipse({{0, 0}, {2, 0}, {0, 1}}, {1, 0});
  const CurvedContact met = curved_contact(flying, {std::nullopt, {{box, {0, 0}}, 0}});
  ASSERT_EQ(met.verdict, CurveVerdict::meets);
  expect_around(met.enter, 3, 1e-11);
  expect_around(met.exit, 8, 1e-11);
  EXPECT_EQ(met.start, StartPlace::outside);
  EXPECT_LT((met.place.point - Vec2(5, 0)).norm(), 1e-5);
  EXPECT_LT((met.place.normal - Vec2(1, 0)).norm(), 1e-5);
  const std::vector<Vec2> centre = {{5, 0}};
  const CurvedContact disc = curved_contact(flying, {std::nullopt, {{centre, {0, 0}}, 0.5}});
  ASSERT_EQ(disc.verdict, CurveVerdict::meets);
  expect_around(disc.enter, 2.5, 1e-11);
  expect_around(disc.exit, 7.5, 1e-11);
}

// A corner at height y meets x^2 / a^2 + y^2 / b^2 = 1 at x = a sqrt(1 - y^2 / b^2).
TEST(EllipseContact, ACornerMeetsTheCurve) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    Draw draw(51, 1, item);
    const double a = 0.1 + 3 * draw.unit(), b = 0.1 + 3 * draw.unit(), y = 0.99 * b * draw.unit();
    const double speed = 0.5 + draw.unit(), far = 5 + draw.unit();
    const std::vector<Vec2> wedge = {{far, y}, {far + 1, y}, {far + 0.5, y + 0.25}};
    const CurvedContact met = curved_contact(ellipse({{0, 0}, {a, 0}, {0, b}}, {speed, 0}),
                                             {std::nullopt, {{wedge, {0, 0}}, 0}});
    ASSERT_EQ(met.verdict, CurveVerdict::meets) << item;
    const double truth = (far - a * std::sqrt(1 - y * y / (b * b))) / speed;
    EXPECT_LE(met.enter.low, truth + 1e-13) << item;
    EXPECT_GE(met.enter.high, truth - 1e-13) << item;
    EXPECT_LE(met.enter.high - met.enter.low, 1e-9) << item;
  }
}

// A shear or a stretch of both is one of their relative motion: two alike are two circles.
TEST(EllipseContact, TwoAlikeMeetAsCirclesDoOnceBothAreStretched) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    Draw draw(52, 1, item);
    const double angle = 6 * draw.unit(), stretch = 0.2 + 2 * draw.unit();
    const Vec2 u(std::cos(angle), std::sin(angle)), v(-stretch * u.y(), stretch * u.x());
    const double x = 3 + 2 * draw.unit(), y = 1.5 * draw.unit(), r = 0.3 + draw.unit();
    const double vx = -1 - draw.unit(), vy = 0.4 * draw.unit() - 0.2;
    const Vec2 at = x * u + y * v, velocity = vx * u + vy * v;
    const CurvedContact met = curved_contact(ellipse({{0, 0}, u, v}, {0, 0}),
                                             ellipse({at, r * u, r * v}, velocity), {0, 20});
    const double reach = 1 + r, way = vx * vx + vy * vy, ahead = -(x * vx + y * vy) / way;
    const double beside = std::fabs(x * vy - y * vx) / std::sqrt(way);
    if (beside > reach) {
      EXPECT_EQ(met.verdict, CurveVerdict::apart) << item;
      continue;
    }
    ASSERT_EQ(met.verdict, CurveVerdict::meets) << item;
    const double half = std::sqrt((reach * reach - beside * beside) / way);
    EXPECT_LE(met.enter.low, ahead - half + 1e-13) << item;
    EXPECT_GE(met.enter.high, ahead - half - 1e-13) << item;
    EXPECT_LE(met.enter.high - met.enter.low, 1e-8) << item;
    EXPECT_LE(met.exit.low, ahead + half + 1e-13) << item;
    EXPECT_GE(met.exit.high, ahead + half - 1e-13) << item;
  }
}

TEST(EllipseContact, InsideBesideAndBeyondTheDoubles) {
  const std::vector<Vec2> point = {{0.5, 0}}, beside = {{0, 1.5}};
  const Ellipse curve({0, 0}, {2, 0}, {0, 1});
  const CurvedContact inside =
      curved_contact(ellipse(curve, {1, 0}), {std::nullopt, {{point, {0, 0}}, 0}});
  EXPECT_EQ(inside.verdict, CurveVerdict::meets);
  EXPECT_EQ(inside.start, StartPlace::inside);
  EXPECT_EQ(inside.enter.low, 0);
  expect_around(inside.exit, 2.5, 1e-10);
  EXPECT_EQ(curved_contact(ellipse(curve, {1, 0}), {std::nullopt, {{beside, {0, 0}}, 0}}).verdict,
            CurveVerdict::apart);
  // So thin and so far away that its corners are lost in rounding: nothing is known, and said so.
  const std::vector<Vec2> there = {{1e9, 0}};
  EXPECT_EQ(curved_contact(ellipse({{1e9, 0}, {1, 0}, {0, 1e-9}}, {1, 0}),
                           {std::nullopt, {{there, {0, 0}}, 0}}, {0, 1})
                .verdict,
            CurveVerdict::undecided);
}

// Lengths times a power of two: the same times, normals and verdicts.
TEST(EllipseContact, TheSameAtAnyScale) {
  const auto met_at = [](int exponent) {
    const auto n = [exponent](double x) { return std::ldexp(x, exponent); };
    const std::vector<Vec2> box = {{n(5), n(-1)}, {n(6), n(-1)}, {n(6), n(1)}, {n(5), n(1)}};
    return curved_contact(ellipse({{0, n(0.25)}, {n(2), 0}, {0, n(1)}}, {n(1), 0}),
                          {std::nullopt, {{box, {0, 0}}, n(0.125)}}, {0, 10});
  };
  const CurvedContact one = met_at(0);
  ASSERT_EQ(one.verdict, CurveVerdict::meets);
  for (const int exponent : {-1000, -664, -450, 450, 664, 1000}) {
    SCOPED_TRACE(exponent);
    const CurvedContact met = met_at(exponent);
    EXPECT_EQ(met.verdict, CurveVerdict::meets);
    EXPECT_EQ(met.enter.low, one.enter.low);
    EXPECT_EQ(met.enter.high, one.enter.high);
    EXPECT_EQ(met.exit.high, one.exit.high);
    EXPECT_EQ(met.start, one.start);
    EXPECT_EQ(met.place.normal, one.place.normal);
    EXPECT_EQ(std::ldexp(met.place.point.x(), -exponent), one.place.point.x());
  }
}

}  // namespace
}  // namespace flatray
