#include "oracle/bezier.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "base/hash.h"
#include "oracle/families.h"

namespace flatray::oracle {
namespace {

using Points = std::vector<Vec2>;

const Bezier kParabola({-1, 1}, {1, -3}, {3, 9});              // (x, x^2), x from -1 to 3
const Bezier kCubic({-6, -24}, {-2, 24}, {2, -24}, {6, 24});   // (3 u, 3 u^3), |u| <= 2
const Bezier kLoop({-18, 12}, {26, -4}, {-26, -4}, {18, 12});  // (3 u^3 - 3 u, 3 u^2)
const Bezier kCusp({-24, 12}, {24, -4}, {-24, -4}, {24, 12});  // (3 u^3, 3 u^2)

Points points_of(const Bezier& curve) {
  return {curve.points.begin(), curve.points.begin() + curve.degree + 1};
}

Algebraic number(const Rational& p, int s = 0, const Rational& q = 0) {
  return Algebraic(Surd{p, s, q});
}

TEST(Algebraic, RootsAreFoundOnceEachInOrder) {
  // (x - 1)^2 (x + 2) (x^2 - 2)
  const Polynomial p = {-4, 6, 2, -5, 0, 1};
  const auto all = Algebraic::roots(p, -3, 3);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0], number(-2));
  EXPECT_EQ(all[1], number(0, -1, 2));
  EXPECT_EQ(all[2], number(1));
  EXPECT_EQ(all[3], number(0, 1, 2));
  EXPECT_EQ(Algebraic::roots(p, -2, 1).size(), 3U);  // both ends are roots
  EXPECT_EQ(Algebraic::roots(p, -1.75, 0.75).size(), 1U);
}

TEST(Algebraic, NeighboursAreTwoRoots) {
  const Rational apart = 0x1p-40;
  // u (u - apart) for u = 3 x - 1
  const auto both = Algebraic::roots({apart + 1, -(apart * 3 + 6), 9}, 0, 1);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0], number(Rational(1) / 3));
  EXPECT_EQ(both[1], number((apart + 1) / 3));
  EXPECT_LT(both[0], both[1]);
  EXPECT_EQ(both[1].value_of({-1, 3}), number(apart));
  EXPECT_LT(both[0].value_of({-1, 3}), both[1].value_of({-1, 3}));
}

TEST(Algebraic, ValuesAndSignsAreThoseOfPolynomials) {
  const Algebraic root = Algebraic::roots({-2, 0, 0, 1}, 0, 2)[0];    // the cube root of 2
  const Algebraic square = Algebraic::roots({-4, 0, 0, 1}, 0, 2)[0];  // of 4
  EXPECT_EQ(root.value_of({0, 0, 1}), square);
  EXPECT_EQ(root.value_of({7}), number(7));
  EXPECT_EQ(root.sign_of({-2, 0, 0, 1}), Sign::zero);
  EXPECT_EQ(root.sign_of({-1.2599210498948732, 1}), Sign::negative);  // the double nearest is above
  EXPECT_EQ(root.nearest(), 1.2599210498948732);
  EXPECT_LT(root, square);
  EXPECT_LT(number(0, 1, 2), square);
  EXPECT_GT(number(-3, 1, 20), number(0, 1, 2));
  EXPECT_LT(number(1, -1, 0x1p-300), number(1, 1, 0x1p-300));  // one nearest double
}

TEST(Algebraic, HalvesGoToEven) {
  for (const double even : {1.0, 1 + 0x1p-51}) {
    const Rational middle = middle_to(even, even == 1 ? 2 : 0);
    // (x - middle) (x^2 - 3)
    const auto roots = Algebraic::roots({middle * 3, -3, -middle, 1}, 1, 1.5);
    ASSERT_EQ(roots.size(), 1U);
    EXPECT_EQ(roots[0].nearest(), even);
  }
}

TEST(Bezier, AParabolaIsMetWhereItsEquationSays) {
  const auto level = [](double y) { return first_wall_hit({{-5, y}, {1, 0}}, kParabola); };
  EXPECT_EQ(level(4)->t, number(7));
  EXPECT_EQ(level(4)->kind, HitClass::through);
  EXPECT_FALSE(level(4)->at_end);
  EXPECT_EQ(level(2)->t, number(5, 1, 2));  // the root at -sqrt(2) is beyond the end
  EXPECT_EQ(level(0.5)->t, number(5, -1, 0.5));
  EXPECT_EQ(level(0.5)->t.nearest(), (Surd{5, -1, 0.5}).nearest());
  EXPECT_EQ(first_wall_hit({{2, -1}, {0, 1}}, kParabola)->t, number(5));
  EXPECT_FALSE(first_wall_hit({{2, 5}, {0, 1}}, kParabola));  // behind
}

TEST(Bezier, ATangentTouchesAndAnUlpBesideItMisses) {
  const auto touch = first_wall_hit({{-5, 0}, {1, 0}}, kParabola);
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->kind, HitClass::touch);
  EXPECT_EQ(touch->t.nearest(), 5);
  EXPECT_FALSE(first_wall_hit({{-5, -5e-324}, {1, 0}}, kParabola));
  EXPECT_EQ(meetings_with_bezier({{-5, 5e-324}, {1, 0}}, kParabola).size(), 2U);
}

TEST(Bezier, EndsBelongToTheCurve) {
  const auto first = first_wall_hit({{-5, 1}, {1, 0}}, kParabola);
  EXPECT_EQ(first->t, number(4));
  EXPECT_TRUE(first->at_end);
  EXPECT_FALSE(first_wall_hit({{9, 9}, {-1, 0x1p-40}}, kParabola));
  const auto last = first_wall_hit({{9, 9}, {-1, 0}}, kParabola);
  EXPECT_TRUE(last->at_end);
  EXPECT_EQ(last->t, number(6));
  const auto leaving = first_wall_hit({{3, 9}, {1, 1}}, kParabola);
  EXPECT_EQ(leaving->t.sign(), Sign::zero);
}

TEST(Bezier, ACubicIsMetThriceAndItsInflectionTangentCrosses) {
  const auto thrice = meetings_with_bezier({{-6, -6}, {3, 3}}, kCubic);
  ASSERT_EQ(thrice.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(thrice[i].t, number(1.0 + static_cast<double>(i)));
    EXPECT_EQ(thrice[i].multiplicity, 1);
  }
  const auto flat = meetings_with_bezier({{-9, 0}, {3, 0}}, kCubic);
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_EQ(flat[0].multiplicity, 3);
  EXPECT_EQ(flat[0].s, number(0.5));
  EXPECT_EQ(first_wall_hit({{-9, 0}, {3, 0}}, kCubic)->kind, HitClass::through);
  // 3 u^3 = 6 at t = 10 + 3 u, whose cube less 10 is 54.
  const double t = first_wall_hit({{-10, 6}, {1, 0}}, kCubic)->t.nearest();
  const auto cube = [](const Rational& x) { return (x - 10) * (x - 10) * (x - 10); };
  EXPECT_LT(cube(middle_to(t, 0)), 54);
  EXPECT_GT(cube(middle_to(t, 20)), 54);
}

TEST(Bezier, WhereItCrossesItselfItIsMetTwiceAtOnce) {
  const auto all = meetings_with_bezier({{0, -5}, {0, 1}}, kLoop);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].t, number(5));
  EXPECT_EQ(all[1].t, number(8));
  EXPECT_EQ(all[2].t, number(8));
  EXPECT_EQ(all[1].s, number(0.25));
  EXPECT_EQ(all[2].s, number(0.75));
  // The tangent of one branch crosses the other.
  EXPECT_EQ(first_wall_hit({{-1, 2}, {1, 1}}, kLoop)->kind, HitClass::through);
  EXPECT_EQ(meetings_with_bezier({{0, 3}, {0, 0}}, kLoop).size(), 2U);
}

TEST(Bezier, ACuspIsTouchedButAlongItsTangentCrossed) {
  EXPECT_EQ(first_wall_hit({{-9, 0}, {1, 0}}, kCusp)->kind, HitClass::touch);
  EXPECT_EQ(first_wall_hit({{0, -9}, {0, 1}}, kCusp)->kind, HitClass::through);
  EXPECT_EQ(meetings_with_bezier({{0, -9}, {0, 1}}, kCusp)[0].multiplicity, 3);
}

TEST(Bezier, WithoutADirectionIsWhatTheOriginLiesOn) {
  EXPECT_TRUE(first_wall_hit({{2, 4}, {0, 0}}, kParabola));
  EXPECT_FALSE(first_wall_hit({{2, std::nextafter(4, 5)}, {0, 0}}, kParabola));
  EXPECT_FALSE(first_wall_hit({{-2, 4}, {0, 0}}, kParabola));
  EXPECT_TRUE(first_wall_hit({{3, 9}, {0, 0}}, kParabola)->at_end);
}

// Both halves, by de Casteljau. Exact where the control points are whole.
std::pair<Bezier, Bezier> halves(Points points) {
  Points low, high;
  while (!points.empty()) {
    low.push_back(points.front());
    high.insert(high.begin(), points.back());
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = 0.5 * (points[i] + points[i + 1]);
    points.pop_back();
  }
  return {Bezier(low), Bezier(high)};
}

// The curve from its other end, and the nearer of its halves, are met at the same time.
TEST(Bezier, PartsAndTheReverseOfACurveAreMetAsTheCurve) {
  int ends = 0, touches = 0, crossings = 0, misses = 0, ties = 0;
  for (std::uint64_t item = 0; item < 2; ++item) {
    Draw draw(5, 0, item);
    const AimedScene scene = make_scene(bezier_families()[0], draw);
    for (const Ray& ray : scene.rays)
      for (const Bezier& curve : scene.beziers) {
        const Points points = points_of(curve);
        const auto all = meetings_with_bezier(ray, curve);
        const auto [low, high] = halves(points);
        const auto reversed =
            meetings_with_bezier(ray, Bezier(Points(points.rbegin(), points.rend())));
        ASSERT_EQ(all.size(), reversed.size());
        for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].t, reversed[i].t);
        const auto first = first_wall_hit(ray, curve), in_low = first_wall_hit(ray, low),
                   in_high = first_wall_hit(ray, high);
        ASSERT_EQ(first.has_value(), in_low || in_high);
        misses += first ? 0 : 1;
        if (!first) continue;
        EXPECT_EQ(first->t,
                  !in_high || (in_low && in_low->t < in_high->t) ? in_low->t : in_high->t);
        ends += first->at_end ? 1 : 0;
        (first->kind == HitClass::touch ? touches : crossings) += 1;
        ties += all.size() > 1 && all[0].t == all[1].t ? 1 : 0;
      }
  }
  for (const int count : {ends, touches, crossings, misses, ties}) EXPECT_GE(count, 4);
}

// Times are those of the curve in any unit.
TEST(Bezier, ScaledCurvesAreMetAtTheSameTimes) {
  Draw draw(6, 0, 0);
  const AimedScene scene = make_scene(bezier_families()[0], draw);
  const double far = 0x1p-900;
  for (std::size_t i = 0; i < scene.rays.size(); ++i) {
    const Bezier& curve = scene.beziers[i % scene.beziers.size()];
    const Ray &ray = scene.rays[i], scaled{far * ray.origin, far * ray.direction};
    const Bezier small = mapped(curve, [&](const Vec2& p) { return Vec2(far * p); });
    const auto one = first_wall_hit(ray, curve), other = first_wall_hit(scaled, small);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    EXPECT_EQ(one->t, other->t);
    EXPECT_EQ(one->t.nearest(), other->t.nearest());
  }
}

TEST(BezierFamilies, AreTheSameForEveryCompiler) {
  Hash hash;
  const auto add = [&](const Vec2& v) {
    hash.add(std::bit_cast<std::uint64_t>(v.x())).add(std::bit_cast<std::uint64_t>(v.y()));
  };
  for (const Family& family : bezier_families())
    for (std::uint64_t item = 0; item < 4; ++item) {
      Draw draw(1, 0, item);
      const AimedScene scene = make_scene(family, draw);
      for (const Bezier& curve : scene.beziers) {
        for (const Vec2& p : points_of(curve)) add(p);
        if (curve.is_weighted()) hash.add(std::bit_cast<std::uint64_t>(curve.weight));
      }
      for (const Ray& ray : scene.rays) add(ray.origin), add(ray.direction);
    }
  EXPECT_EQ(hash.hex(), "50c9c8e4463f2f13");
}

}  // namespace
}  // namespace flatray::oracle
