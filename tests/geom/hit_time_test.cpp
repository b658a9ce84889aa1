#include "geom/hit_time.h"

#include <gtest/gtest.h>

#include "geom/clip_cases.h"

namespace flatray {
namespace {

using Part = SegmentHit::Part;
constexpr double kUlp = 0x1p-52;

TEST(HitSegment, KnowsTheEndsExactly) {
  const Ray ray{{0, 0}, {3, 1}};
  EXPECT_EQ(hit_segment(ray, {{3, 1}, {3, 2}})->part, Part::at_a);
  EXPECT_EQ(hit_segment(ray, {{6, 0}, {6, 2}})->part, Part::at_b);
  EXPECT_EQ(hit_segment(ray, {{6, 0}, {6, std::nextafter(2.0, 3.0)}})->part, Part::inner);
  EXPECT_FALSE(hit_segment(ray, {{6, 0}, {6, std::nextafter(2.0, 0.0)}}));
}

TEST(HitSegment, OfAParallelWallIsNone) {
  EXPECT_FALSE(hit_segment({{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}));
  EXPECT_FALSE(hit_segment({{0, 0}, {1, 0}}, {{1, 1}, {2, 1}}));
}

TEST(HitSegment, APointOnTheLineIsMet) {
  const auto hit = hit_segment({{0, 0}, {0, 2}}, {{0, 3}, {0, 3}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t.nearest().t, 1.5);
  EXPECT_FALSE(hit_segment({{0, 0}, {0, 2}}, {{1, 3}, {1, 3}}));
}

TEST(HitCircle, GivesBothRootsOfTheCurve) {
  const auto hit = hit_curve({{0, 0}, {1, 0}}, Circle{{3, 0}, 2});
  ASSERT_TRUE(hit);
  EXPECT_FALSE(hit->tangent);
  EXPECT_EQ(hit->first.nearest().t, 1);
  EXPECT_EQ(hit->second.nearest().t, 5);
  EXPECT_EQ(hit_curve({{0, 2}, {1, 0}}, Circle{{3, 0}, 2})->tangent, true);
  EXPECT_FALSE(hit_curve({{0, 2 + 2 * kUlp}, {1, 0}}, Circle{{3, 0}, 2}));
}

TEST(HitTime, OneUlpBetweenParallelWallsIsSeen) {
  const Ray ray{{-100, 0.3}, {7, 0.1}};
  const HitTime near = HitTime::on_line(ray, {{1, 0}, {1, 1}});
  const HitTime far = HitTime::on_line(ray, {{1 + kUlp, 0}, {1 + kUlp, 1}});
  EXPECT_EQ(near.nearest().t, far.nearest().t);
  EXPECT_TRUE(compare(near, far) < 0);
}

TEST(HitTime, ACornerOfTwoWallsIsOneTime) {
  const Ray ray{{0.1, 0.2}, {0.3 - 0.1, 0.7 - 0.2}};
  const HitTime one = HitTime::on_line(ray, {{0.3, 0.7}, {5, 1}});
  const HitTime other = HitTime::on_line(ray, {{0.3, 0.7}, {-3, 0.9}});
  // The tip as rounded is not (0.3, 0.7): which comes first must agree with rationals.
  EXPECT_EQ(compare(one, other), one.exact().rational() <=> other.exact().rational());
  const Ray exact{{-1, -1}, {2, 3}};
  EXPECT_TRUE(compare(HitTime::on_line(exact, {{1, 2}, {7, 3}}),
                      HitTime::on_line(exact, {{1, 2}, {1.1, 0}})) == 0);
}

// A circle and its tangent line, a circle and a chord, two circles: equal by construction, and
// apart by one ulp of a radius.
TEST(HitTime, CirclesAndLinesAreComparedExactly) {
  const Ray ray{{-5, 0}, {1, 0}};
  const Circle unit{{0, 0}, 1}, inside{{-0.5, 0}, 0.5};
  const HitTime first = hit_curve(ray, unit)->first;
  EXPECT_TRUE(compare(first, HitTime::on_line(ray, {{-1, -1}, {-1, 1}})) == 0);
  EXPECT_TRUE(compare(first, hit_curve(ray, inside)->first) == 0);
  const Circle larger{{0, 0}, 1 + kUlp};
  EXPECT_TRUE(compare(hit_curve(ray, larger)->first, first) < 0);
  EXPECT_TRUE(compare(hit_curve(ray, larger)->second, hit_curve(ray, unit)->second) > 0);
}

// sqrt(2) + sqrt(3) against sqrt(10): roots that are no rationals, on three circles met by rays of
// their own.
TEST(HitTime, IrrationalRootsThatAreEqualAreFoundEqual) {
  const Ray diagonal{{0, 0}, {1, 1}};
  const HitTime a = hit_curve(diagonal, Circle{{0, 0}, 3})->second;          // 3 / sqrt(2)
  const HitTime b = hit_curve({{0, 0}, {2, 2}}, Circle{{0, 0}, 6})->second;  // the same
  EXPECT_TRUE(compare(a, b) == 0);
  const HitTime c = hit_curve(diagonal, Circle{{1, 1}, 3})->second;  // 1 + 3 / sqrt(2)
  EXPECT_TRUE(compare(c, a) > 0);
  const HitTime d = hit_curve({{-1, -1}, {1, 1}}, Circle{{0, 0}, 3})->second;
  EXPECT_TRUE(compare(c, d) == 0);
}

TEST(HitTime, OneUlpBetweenRadiiIsSeenFromAfar) {
  const Ray ray{{-99, -99}, {1, 1}};
  const HitTime d = hit_curve(ray, Circle{{0, 0}, 3})->second;
  const HitTime e = hit_curve(ray, Circle{{0, 0}, std::nextafter(3.0, 4.0)})->second;
  EXPECT_TRUE(compare(d, e) < 0);
  EXPECT_EQ(d.nearest().t, e.nearest().t);
}

TEST(HitTime, ComparesWithNumbers) {
  const HitTime t = hit_curve({{0, 0}, {1, 1}}, Circle{{0, 0}, 3})->second;  // 2.12...
  const double rounded = t.nearest().t;
  EXPECT_TRUE(t.compare(rounded) != 0);  // irrational
  EXPECT_TRUE(t.compare(std::nextafter(rounded, 3.0)) < 0);
  EXPECT_TRUE(t.compare(std::nextafter(rounded, 0.0)) > 0);
  EXPECT_TRUE(t.compare(kInfinity) < 0);
  EXPECT_TRUE(t.compare(-kInfinity) > 0);
  EXPECT_EQ(HitTime::on_line({{1, 0}, {5, 3}}, {{1, -1}, {1, 1}}).sign(), Sign::zero);
  EXPECT_EQ(HitTime::on_line({{1, 0}, {5e-324, 3}}, {{1 - 0x1p-53, -1}, {1 - 0x1p-53, 1}}).sign(),
            Sign::negative);
}

// Any two hits: as their doubles, where these differ, and antisymmetric.
TEST(HitTime, OrdersGridHitsAsTheirDoubles) {
  for (int item = 0; item < 500; ++item) {
    Draw draw = draw_of(60, item);
    const Case c = grid_case(draw);
    if (c.ray.direction == Vec2(0, 0)) continue;
    std::vector<HitTime> times;
    for (std::size_t i = 0; i + 1 < c.polygon.size(); ++i)
      if (const auto hit = hit_segment(c.ray, {c.polygon[i], c.polygon[i + 1]}))
        times.push_back(hit->t);
    if (const auto hit = hit_curve(c.ray, Circle{c.polygon[0], draw.below(5)})) {
      times.push_back(hit->first);
      times.push_back(hit->second);
    }
    for (const HitTime& a : times) {
      for (const HitTime& b : times) {
        const Sign order = sign_of(compare(a, b)), rounded = sign_of(a.nearest().t - b.nearest().t);
        ASSERT_EQ(order, -sign_of(compare(b, a))) << item;
        ASSERT_TRUE(order == rounded || rounded == Sign::zero) << item;
      }
    }
  }
}

// What joins an arc of radius 4 to an end inside or outside of it, on the way from the centre.
TEST(HitJoint, IsMetBetweenTheCurveAndTheEndAlone) {
  const Ellipse curve = Circle{{1, 2}, 4};
  const auto time = [&](double x, double end) {
    return hit_joint({{1 + x, 0}, {0, 2}}, curve, {1 + end, 2});
  };
  for (const double x : {3.5, 3.0}) {
    ASSERT_TRUE(time(x, 3)) << x;
    EXPECT_EQ(time(x, 3)->nearest().t, 1) << x;
  }
  for (const double x : {2.5, 4.0, 4.5, -3.5}) EXPECT_FALSE(time(x, 3)) << x;
  for (const double x : {4.5, 5.0}) EXPECT_TRUE(time(x, 5)) << x;
  for (const double x : {3.5, 4.0, 5.5, -4.5}) EXPECT_FALSE(time(x, 5)) << x;
  EXPECT_FALSE(time(4, 4)) << "an end on the curve has no joint";
}

}  // namespace
}  // namespace flatray
