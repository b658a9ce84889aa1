#include <gtest/gtest.h>

#include <cmath>

#include "collide/outline_contact.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;
struct Moving {
  ShapePart part;
  Vec2 velocity;
};

Moving ellipse(const Ellipse& curve, const Vec2& velocity) { return {{{}, 0, curve}, velocity}; }
Moving at_rest(const std::vector<Vec2>& core, double radius = 0) {
  return {{core, radius}, {0, 0}};
}
std::optional<MeetingPart> meeting(const Moving& a, const Moving& b, Range within = kRay) {
  return curved_parts_meet(a.part, a.velocity, b.part, b.velocity, within);
}

void expect_entry(const MeetingPart& met, double truth, double width) {
  EXPECT_LE(met.times.low, truth);
  EXPECT_GE(met.times.low + met.width, truth);
  EXPECT_LE(met.width, width);
}
void expect_exit(const MeetingPart& met, double truth, double width) {
  EXPECT_GE(met.times.high, truth);
  EXPECT_LE(met.times.high, truth + width);
}

TEST(CurvedContact, AgainstABoxAndADiscIsWhereTheAxisComes) {
  const std::vector<Vec2> box = {{5, -1}, {6, -1}, {6, 1}, {5, 1}};
  const Moving flying = ellipse({{0, 0}, {2, 0}, {0, 1}}, {1, 0});
  const auto met = meeting(flying, at_rest(box));
  ASSERT_TRUE(met && met->certain);
  expect_entry(*met, 3, 1e-11);
  expect_exit(*met, 8, 1e-11);
  EXPECT_EQ(met->start, StartPlace::outside);
  EXPECT_EQ(met->kind, HitClass::through);
  EXPECT_LT((met->point - Vec2(5, 0)).norm(), 1e-5);
  EXPECT_LT((met->normal - Vec2(1, 0)).norm(), 1e-5);
  const std::vector<Vec2> centre = {{5, 0}};
  const auto disc = meeting(flying, at_rest(centre, 0.5));
  ASSERT_TRUE(disc && disc->certain);
  expect_entry(*disc, 2.5, 1e-11);
  expect_exit(*disc, 7.5, 1e-11);
}

// A corner at height y meets x^2 / a^2 + y^2 / b^2 = 1 at x = a sqrt(1 - y^2 / b^2).
TEST(CurvedContact, ACornerMeetsTheCurve) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    Draw draw(51, 1, item);
    const double a = 0.1 + 3 * draw.unit(), b = 0.1 + 3 * draw.unit(), y = 0.99 * b * draw.unit();
    const double speed = 0.5 + draw.unit(), far = 5 + draw.unit();
    const std::vector<Vec2> wedge = {{far, y}, {far + 1, y}, {far + 0.5, y + 0.25}};
    const auto met = meeting(ellipse({{0, 0}, {a, 0}, {0, b}}, {speed, 0}), at_rest(wedge));
    ASSERT_TRUE(met && met->certain) << item;
    const double truth = (far - a * std::sqrt(1 - y * y / (b * b))) / speed;
    EXPECT_LE(met->times.low, truth + 1e-13) << item;
    EXPECT_GE(met->times.low + met->width, truth - 1e-13) << item;
    EXPECT_LE(met->width, 1e-9) << item;
  }
}

// A shear or a stretch of both is one of their relative motion: two alike are two circles.
TEST(CurvedContact, TwoAlikeMeetAsCirclesDoOnceBothAreStretched) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    Draw draw(52, 1, item);
    const double angle = 6 * draw.unit(), stretch = 0.2 + 2 * draw.unit();
    const Vec2 u(std::cos(angle), std::sin(angle)), v(-stretch * u.y(), stretch * u.x());
    const double x = 3 + 2 * draw.unit(), y = 1.5 * draw.unit(), r = 0.3 + draw.unit();
    const double vx = -1 - draw.unit(), vy = 0.4 * draw.unit() - 0.2;
    const Vec2 at = x * u + y * v, velocity = vx * u + vy * v;
    const auto met =
        meeting(ellipse({{0, 0}, u, v}, {0, 0}), ellipse({at, r * u, r * v}, velocity), {0, 20});
    const double reach = 1 + r, way = vx * vx + vy * vy, ahead = -(x * vx + y * vy) / way;
    const double beside = std::fabs(x * vy - y * vx) / std::sqrt(way);
    if (beside > reach) {
      EXPECT_FALSE(met) << item;
      continue;
    }
    ASSERT_TRUE(met && met->certain) << item;
    const double half = std::sqrt((reach * reach - beside * beside) / way);
    EXPECT_LE(met->times.low, ahead - half + 1e-13) << item;
    EXPECT_GE(met->times.low + met->width, ahead - half - 1e-13) << item;
    EXPECT_LE(met->width, 1e-8) << item;
    EXPECT_LE(met->times.high, ahead + half + 1e-8) << item;
    EXPECT_GE(met->times.high, ahead + half - 1e-13) << item;
  }
}

TEST(CurvedContact, InsideBesideAndBeyondTheDoubles) {
  const std::vector<Vec2> point = {{0.5, 0}}, beside = {{0, 1.5}};
  const Ellipse curve({0, 0}, {2, 0}, {0, 1});
  const auto inside = meeting(ellipse(curve, {1, 0}), at_rest(point));
  ASSERT_TRUE(inside && inside->certain);
  EXPECT_EQ(inside->start, StartPlace::inside);
  EXPECT_EQ(inside->times.low, 0);
  expect_exit(*inside, 2.5, 1e-10);
  EXPECT_FALSE(meeting(ellipse(curve, {1, 0}), at_rest(beside)));
  // So thin and so far away that its corners are lost in rounding: nothing is known, and said so.
  const auto lost =
      meeting(ellipse({{1e9, 0}, {1, 0}, {0, 1e-9}}, {1, 0}), at_rest({{1e9, 0}}), {0, 1});
  ASSERT_TRUE(lost);
  EXPECT_FALSE(lost->certain);
  EXPECT_EQ(lost->width, 1);
  EXPECT_EQ(lost->start, StartPlace::boundary);
}

// Lengths times a power of two: the same times, normals and verdicts.
TEST(CurvedContact, TheSameAtAnyScale) {
  const auto met_at = [](int exponent) {
    const auto n = [exponent](double x) { return std::ldexp(x, exponent); };
    const std::vector<Vec2> box = {{n(5), n(-1)}, {n(6), n(-1)}, {n(6), n(1)}, {n(5), n(1)}};
    return meeting(ellipse({{0, n(0.25)}, {n(2), 0}, {0, n(1)}}, {n(1), 0}), at_rest(box, n(0.125)),
                   {0, 10});
  };
  const auto one = met_at(0);
  ASSERT_TRUE(one && one->certain);
  for (const int exponent : {-1000, -664, -450, 450, 664, 1000}) {
    SCOPED_TRACE(exponent);
    const auto met = met_at(exponent);
    ASSERT_TRUE(met && met->certain);
    EXPECT_EQ(met->times.low, one->times.low);
    EXPECT_EQ(met->times.high, one->times.high);
    EXPECT_EQ(met->width, one->width);
    EXPECT_EQ(met->start, one->start);
    EXPECT_EQ(met->normal, one->normal);
    EXPECT_EQ(std::ldexp(met->point.x(), -exponent), one->point.x());
  }
  // Where doubles lose digits of the corners, less is told, and nothing that is wrong.
  for (const int exponent : {-1010, -1030, -1050, -1071}) {
    SCOPED_TRACE(exponent);
    const auto met = met_at(exponent);
    ASSERT_TRUE(met);
    EXPECT_LE(met->times.low, one->times.low + one->width);
    EXPECT_GE(met->times.low + met->width, one->times.low);
  }
}

}  // namespace
}  // namespace flatray
