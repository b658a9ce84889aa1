// Weighted quadratic Bezier curves: arcs of conics.
#include <gtest/gtest.h>

#include "geom/meetings.h"

namespace flatray {
namespace {

const Bezier kHyperbola({2.5, 10}, {4, 4}, {10, 2.5}, 1.25);    // x y = 25
const Bezier kCubic({-18, 12}, {26, -4}, {-26, -4}, {18, 12});  // with a loop

TEST(Conic, IsMetAsTheHyperbolaItIs) {
  const auto met = meetings(kHyperbola, {{0, 0}, {1, 2}});
  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(met[0].time.nearest().t, std::sqrt(12.5));
  EXPECT_EQ(met[0].root, Root::second);  // from the right of the curve
  EXPECT_EQ(point_met(kHyperbola, {{0, 0}, {1, 2}}, Root::second).y(), std::sqrt(50.0));
  const auto touched = meetings(kHyperbola, {{0, 10}, {1, -1}});
  ASSERT_EQ(touched.size(), 1U);
  EXPECT_EQ(touched[0].kind, HitClass::touch);
  EXPECT_EQ(touched[0].time.nearest().t, 5);
  for (const double y : {4.0, 5.0, 6.25}) {
    EXPECT_EQ(side_of(kHyperbola, {25 / y, y}), Sign::zero) << y;
    EXPECT_EQ(place_on(kHyperbola, {25 / y, y}), PlaceOn::inner) << y;
    EXPECT_EQ(side_of(kHyperbola, {std::nextafter(25 / y, 0), y}), Sign::negative) << y;
    EXPECT_EQ(side_of(kHyperbola, {std::nextafter(25 / y, 99), y}), Sign::positive) << y;
  }
}

// Both ends of the range: on either leg of its control polygon, all but.
TEST(Conic, OfTheGreatestWeightIsToldOnEitherLeg) {
  const Bezier sharp({-1, 0}, {0, 1}, {1, 0}, Bezier::kMostWeight);
  for (const double x : {-0.5, 0.5}) {
    EXPECT_EQ(side_of(sharp, {x, 0.4375}), Sign::negative) << x;  // below: it runs to the right
    EXPECT_EQ(side_of(sharp, {x, 0.5625}), Sign::positive) << x;
    const Vec2 tangent = tangent_at(sharp, parameter_near(sharp, {x, 0.5})).normalized();
    EXPECT_NEAR(cross(tangent, Vec2(1, x < 0 ? 1 : -1).normalized()), 0, 1e-3) << x;
  }
  const Bezier flat({-1, 0}, {0, 1}, {1, 0}, Bezier::kLeastWeight);
  EXPECT_EQ(side_of(flat, {0.25, -0x1p-20}), Sign::negative);
  EXPECT_EQ(side_of(flat, {0.25, 0x1p-20}), Sign::positive);
}

TEST(Conic, IsClippedAtTimesThatAreTold) {
  const std::vector<HitInterval> at_one = clip_curve({{0, 4}, {6.25, 0}}, kHyperbola, {0, 1});
  ASSERT_EQ(at_one.size(), 1U);
  EXPECT_EQ(at_one[0].t_enter, 1);
  EXPECT_EQ(clip_curve({{0, 10}, {5, -5}}, kHyperbola, {0, 1}).size(), 1U);
  EXPECT_TRUE(clip_curve({{0, 4}, {6.25, 0}}, kHyperbola, {0, 1 - 0x1p-53}).empty());
}

// Of x y = k the curvature is 2 k (x^2 + y^2)^(-3/2).
TEST(Conic, SpeedsAndCurvaturesAreThoseOfItsPoint) {
  const Bezier ellipse({0, 0}, {3, 1}, {2, 4}, 0.25), flat({0, 0}, {1, 1e-3}, {3, 0}, 7);
  for (const Bezier& curve : {kHyperbola, ellipse, flat, kCubic}) {
    constexpr double h = 1e-5;
    for (const double s : {0.01, 0.2, 0.5, 0.85, 0.99}) {
      const Vec2 before = point_at(curve, s - h), here = point_at(curve, s),
                 after = point_at(curve, s + h);
      const Vec2 rate = (after - before) / (2 * h), bend = (after - 2 * here + before) / (h * h);
      EXPECT_NEAR(speed_at(curve, s), rate.norm(), 1e-6 * rate.norm());
      EXPECT_NEAR(cross(tangent_at(curve, s), rate), 0, 1e-6 * rate.norm());
      EXPECT_NEAR(curvature_at(curve, s), std::fabs(cross(rate, bend)) / std::pow(rate.norm(), 3),
                  1e-4 * curvature_at(curve, s) + 1e-6);
      EXPECT_LE(bend.norm(), most_acceleration(curve) * (1 + 1e-3));
      EXPECT_NEAR(parameter_near(curve, here), s, 1e-7);
    }
  }
  for (const double s : {0.0, 0.3, 0.5, 1.0}) {
    const Vec2 p = point_at(kHyperbola, s);
    EXPECT_NEAR(p.x() * p.y(), 25, 1e-13);
    EXPECT_NEAR(curvature_at(kHyperbola, s), 50 * std::pow(p.squaredNorm(), -1.5), 1e-15);
  }
}

// Light to one focus of a hyperbola leaves towards the other: (sqrt 50, sqrt 50) and its mirror image.
TEST(Conic, NormalsAreThoseOfTheCurve) {
  const double f = std::sqrt(50.0);
  for (const double x : {2.75, 4.0, 5.0, 8.5}) {
    const Ray ray{{x, 0}, {0, 1}};
    const ExactHit hit(ray, kHyperbola, Root::second);
    const Vec2 point = hit.nearest(), normal = hit.normal().normalized();
    EXPECT_EQ(point.y(), 25 / x);
    const Vec2 from = (point - Vec2(f, f)).normalized(), to = (point + Vec2(f, f)).normalized();
    EXPECT_NEAR(cross(from - 2 * from.dot(normal) * normal, to), 0, 1e-15);
  }
}

TEST(Conic, OfTwoOfTheSamePointsTheWeightTells) {
  const Bezier other({2.5, 10}, {4, 4}, {10, 2.5}, 1.5), back({10, 2.5}, {4, 4}, {2.5, 10}, 1.25);
  EXPECT_TRUE(overlap(kHyperbola, back));
  EXPECT_FALSE(overlap(kHyperbola, other));
  EXPECT_TRUE(passes_near(kHyperbola, {5, 5.001}, {0.001, 0.001}));
  EXPECT_FALSE(passes_near(kHyperbola, {5, 5.6}, {0.01, 0.01}));
  EXPECT_TRUE(passes_near(Bezier({-1, 0}, {0, 1}, {1, 0}, 8), {0, 8 / 9.0 + 0.05}, {0.06, 0.06}));
}

}  // namespace
}  // namespace flatray
