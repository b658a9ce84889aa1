#include "geom/primitives/bezier.h"

#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/decide.h"
#include "geom/meetings.h"
#include "geom/primitives/bezier_roots.h"
#include "geom/primitives/wall.h"
#include "geom/quick_hit.h"
#include "oracle/families.h"

namespace flatray {
namespace {

const Bezier kParabola({-2, 4}, {0, -4}, {2, 4});  // y = x^2
const Bezier kLoop({-18, 12}, {26, -4}, {-26, -4},
                   {18, 12});  // 3 (u^3 - u), 3 u^2: u = +-1 at (0, 3)
const Bezier kCusp({-24, 12}, {24, -4}, {-24, -4}, {24, 12});      // 3 u^3, 3 u^2
const Bezier kInflection({-6, -24}, {-2, 24}, {2, -24}, {6, 24});  // 3 u, 3 u^3

TEST(Bezier, ReachesToItsExtent) {
  oracle::Draw draw(7, 0, 0);
  const auto between = [&](double low, double high) { return low + (high - low) * draw.unit(); };
  for (std::uint64_t i = 0; i < times(600); ++i) {
    const auto point = [&] {
      const double x = between(-9, 9);
      return Vec2(x, between(-9, 9));
    };
    const Vec2 a = point(), b = point(), c = point(), d = point();
    const double weight = std::exp2(between(-8, 8));
    const Bezier curve = i % 3 == 0   ? Bezier(a, b, c)
                         : i % 3 == 1 ? Bezier(a, b, c, weight)
                                      : Bezier(a, b, c, d);
    Bounds seen;
    for (int k = 0; k <= 20000; ++k) seen.add(point_at(curve, k / 20000.0));
    const Bounds box = extent_of(curve);
    const Vec2 beyond(1e-12, 1e-12), near(1e-4, 1e-4);
    EXPECT_TRUE((Bounds{box.low - beyond, box.high + beyond}.contains(seen.low))) << i;
    EXPECT_TRUE((Bounds{box.low - beyond, box.high + beyond}.contains(seen.high))) << i;
    EXPECT_TRUE((Bounds{seen.low - near, seen.high + near}.contains(box.low))) << i;
    EXPECT_TRUE((Bounds{seen.low - near, seen.high + near}.contains(box.high))) << i;
  }
  // Half a circle, whose middle control point is far away.
  const Bounds arch = extent_of(Bezier({-1, 0}, {0, 1e9}, {1, 0}, 1e-9));
  EXPECT_NEAR(arch.high.y(), 1 / (1 + 1e-9), 1e-15);
  EXPECT_EQ(arch.low.y(), 0);
  EXPECT_EQ(extent_of(kParabola).low, Vec2(-2, 0));
}

TEST(RealRoot, IsTheSquareRootOfTwo) {
  const Polynomial p{-2, 0, 1};
  const std::vector<RealRoot> both = RealRoot::all(p, -2, 2);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].nearest(), std::sqrt(2.0));
  EXPECT_EQ(both[0].nearest(), -std::sqrt(2.0));
  EXPECT_EQ(both[1].sign_of({-4, 0, 2}), Sign::zero);
  EXPECT_EQ(both[1].sign_of({-1.4142135623730951, 1}), Sign::negative);  // that double is above it
  EXPECT_EQ(compare(both[1].value_of({0, 0, 1}), RealRoot(2)), std::strong_ordering::equal);
  EXPECT_EQ(compare(both[0].value_of({0, -1}), both[1]), std::strong_ordering::equal);
  EXPECT_EQ(compare(both[0], both[1]), std::strong_ordering::less);
}

// Of x^3 = 2 and x^3 = 2 + 2^-17184: a bit at a time would be 17 184 halvings.
TEST(RealRoot, IsToldFromOneThatIsNearlyTheSame) {
  Rational tiny = 0x1p-1074;
  for (int i = 0; i < 4; ++i) tiny *= tiny;
  const RealRoot one = RealRoot::all({-2, 0, 0, 1}, 1, 2)[0];
  EXPECT_EQ(compare(one, RealRoot::all({-2 - tiny, 0, 0, 1}, 1, 2)[0]), std::strong_ordering::less);
  EXPECT_EQ(compare(one, RealRoot::all({tiny - 2, 0, 0, 1}, 1, 2)[0]),
            std::strong_ordering::greater);
  EXPECT_EQ(one.sign_of({-2 - tiny, 0, 0, 1}), Sign::negative);
  // One that is known without error, as the root of x^3 = 8, and the other within an interval.
  const RealRoot two = RealRoot::all({-8, 0, 0, 1}, 1, 3)[0];
  EXPECT_EQ(compare(two, RealRoot::all({-8 - tiny, 0, 0, 1}, 1, 3)[0]), std::strong_ordering::less);
  EXPECT_EQ(compare(RealRoot::all({tiny - 8, 0, 0, 1}, 1, 3)[0], two), std::strong_ordering::less);
}

TEST(RealRoot, TellsEachRootOnceWhateverItsMultiplicity) {
  // x (x - 1)^2 (x^2 - 3) has the roots 0, 1, sqrt(3) in [0, 2].
  const std::vector<RealRoot> all = RealRoot::all({0, -3, 6, -2, -2, 1}, 0, 2);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].nearest(), 0);
  EXPECT_EQ(all[1].nearest(), 1);
  EXPECT_EQ(all[2].nearest(), std::sqrt(3.0));
}

// A root of x^3 - 2 by the powers of which 2^(1/3) x 2^(2/3) = 2, where doubles are far from enough.
TEST(RealRoot, ValuesAreAlgebraicToo) {
  const RealRoot root = RealRoot::all({-2, 0, 0, 1}, 1, 2)[0];
  const double near = root.nearest();
  for (const double side : {-9.0, 9.0}) {
    const Rational middle = (Rational(near) + Rational(std::nextafter(near, side))) / 2;
    EXPECT_EQ(root.sign_of({-middle, 1}), side < 0 ? Sign::positive : Sign::negative);
  }
  EXPECT_EQ(root.value_of({0, 0, 1}).sign_of({-4, 0, 0, 1}), Sign::zero);
  EXPECT_DOUBLE_EQ(root.value_of({1, 1, 1}).nearest(), 3.8473221018630728);
}

TEST(RealRoot, ValuesOfConstantsAreTheConstants) {
  const RealRoot root = RealRoot::all({-2, 0, 1}, 1, 2)[0];
  EXPECT_EQ(compare(root.value_of({7}), RealRoot(7)), std::strong_ordering::equal);
}

TEST(Bezier, IsMetAsTheParabolaItIs) {
  const auto level = meetings(kParabola, {{-5, 2}, {1, 0}});
  ASSERT_EQ(level.size(), 2U);
  EXPECT_EQ(level[0].time.nearest().t, 5 - std::sqrt(2.0));
  EXPECT_EQ(level[1].time.nearest().t, 5 + std::sqrt(2.0));
  EXPECT_EQ(level[0].kind, HitClass::through);
  EXPECT_EQ(level[0].root, Root::second);  // x falls on the way there: its left is outside
  EXPECT_EQ(level[1].root, Root::first);
  EXPECT_EQ(point_met(kParabola, {{-5, 2}, {1, 0}}, Root::first), Vec2(std::sqrt(2.0), 2));
  EXPECT_TRUE(meetings(kParabola, {{-5, 5}, {1, 0}}).empty());
  EXPECT_TRUE(meetings(kParabola, {{3, 2}, {1, 0}}).empty());  // behind
}

TEST(Bezier, TangentsTouchAndAnUlpDecides) {
  const auto touched = meetings(kParabola, {{-1, -3}, {1, 2}});  // y = 2 x - 1 at (1, 1)
  ASSERT_EQ(touched.size(), 1U);
  EXPECT_EQ(touched[0].kind, HitClass::touch);
  EXPECT_EQ(touched[0].root, Root::both);
  EXPECT_EQ(touched[0].time.nearest().t, 2);
  EXPECT_FALSE(touched[0].at_end);
  EXPECT_TRUE(meetings(kParabola, {{-1, -3}, {1, 2}}, {Root::none, false, true}).empty());
  EXPECT_TRUE(meetings(kParabola, {{-1, std::nextafter(-3.0, -4.0)}, {1, 2}}).empty());
  EXPECT_EQ(meetings(kParabola, {{-1, std::nextafter(-3.0, 0.0)}, {1, 2}}).size(), 2U);
}

// y = x^2 as x = 3 s, touched at s = 1/3: bounds leave that open, and no double is a third.
TEST(Bezier, ParametersOfTangentsAreKnownBeyondDoubles) {
  const auto roots = roots_of(Bezier({0, 0}, {1.5, 0}, {3, 9}), {{0, -1}, {1, 2}});
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].multiplicity, 2);
  const Bounded s = roots[0].s;
  const Rational off = Rational(s.hi()) + s.lo() - Rational(1) / 3;
  EXPECT_LT(s.error(), 0x1p-100);
  EXPECT_LE(off, Rational(s.error()));
  EXPECT_GE(off, Rational(-s.error()));
}

// Lines that nearly touch y = x^2 and a cubic, so that roots are badly told apart: the polynomial changes its
// sign from one bound of each to the other.
TEST(Bezier, RootsLieBetweenTheirBounds) {
  const Bezier cubic({-1.3, 2.9}, {0.7, -4.1}, {-0.2, 3.3}, {1.9, -0.6});
  int roots = 0;
  for (const Bezier& curve : {kParabola, cubic})
    for (int k = 0; k < 50; ++k)
      for (double off = 1; off > 0x1p-30; off *= 0.125) {
        const double place = (k + 0.37) / 50;
        const Vec2 at = point_at(curve, place), along = tangent_at(curve, place);
        const Vec2 beside(-off * along.y(), off * along.x());
        const Ray ray{at + 0.01 * beside - 0.3 * along, along};
        const Polynomial f = powers_of(beside_ray(kRational, curve, ray));
        for (const BezierRoot& root : roots_of(curve, ray)) {
          const Rational s = Rational(root.s.hi()) + root.s.lo(), error = root.s.error();
          EXPECT_LT(root.s.error(), 0x1p-60);
          EXPECT_EQ(value_at(f, s - error).sign(), -value_at(f, s + error).sign())
              << place << ' ' << off;
          ++roots;
        }
      }
  EXPECT_GT(roots, 1000);
}

// Found by a reviewer: beside these roots another lies just before 0 or just beyond 1, to which Newton's method leads first.
TEST(Bezier, RootsAreFoundBesideOthersJustOutside) {
  const Bernstein<double> beyond{0.128, -6.6e-9, -0.0727, -3.7e-14};
  EXPECT_NEAR(only_root_near(beyond), 0.434, 1e-3);
  Bernstein<double> before = beyond;
  std::reverse(before.begin(), before.end());
  EXPECT_NEAR(only_root_near(before), 0.566, 1e-3);
}

TEST(Bezier, EndsBelongToIt) {
  const auto both = meetings(kParabola, {{-5, 4}, {1, 0}});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_TRUE(both[0].at_end && both[1].at_end);
  EXPECT_EQ(both[0].time.nearest().t, 3);
  EXPECT_EQ(end_met(kParabola, {{-5, 4}, {1, 0}}, both[0].root), Vec2(-2, 4));
  EXPECT_EQ(end_met(kParabola, {{-5, 4}, {1, 0}}, both[1].root), Vec2(2, 4));
  EXPECT_TRUE(meetings(kParabola, {{-5, std::nextafter(4.0, 5.0)}, {1, 0}}).empty());
}

// Where it crosses itself, in a cusp and on the tangent of an inflection.
TEST(Bezier, SpecialPointsAreTold) {
  const auto node = meetings(kLoop, {{0, -5}, {0, 1}});
  ASSERT_EQ(node.size(), 2U);  // at u = 0, and at u = 1 and -1 together
  EXPECT_EQ(node[0].time.nearest().t, 5);
  EXPECT_FALSE(node[0].at_end);
  EXPECT_EQ(node[1].time.nearest().t, 8);
  EXPECT_TRUE(node[1].at_end);
  const auto beside = meetings(kLoop, {{std::nextafter(0.0, 1.0), -5}, {0, 1}});
  EXPECT_EQ(beside.size(), 3U);
  const auto cusp = meetings(kCusp, {{-7, 0}, {1, 0}});
  ASSERT_EQ(cusp.size(), 1U);
  EXPECT_TRUE(cusp[0].at_end);
  EXPECT_EQ(cusp[0].kind, HitClass::touch);
  const auto along = meetings(kInflection, {{-9, 0}, {3, 0}});
  ASSERT_EQ(along.size(), 1U);
  EXPECT_EQ(along[0].kind, HitClass::through);
  EXPECT_EQ(along[0].time.nearest().t, 3);
}

// x = 3 u, y = 3 u^3 on y = x / 4: u^3 = u / 4, so that u = -1/2, 0, 1/2.
TEST(Bezier, RootsAreNamedByTheirDirectionAndTheirNumber) {
  const Ray ray{{-6, -1.5}, {4, 1}};
  const auto met = meetings(kInflection, ray);
  ASSERT_EQ(met.size(), 3U);
  EXPECT_EQ(met[0].root, Root::first);  // the curve comes from below and turns less than the ray
  EXPECT_EQ(met[1].root, Root::second);
  EXPECT_EQ(met[2].root, Root::third);
  EXPECT_EQ(point_met(kInflection, ray, Root::first), Vec2(-1.5, -0.375));
  EXPECT_EQ(point_met(kInflection, ray, Root::second), Vec2(0, 0));
  EXPECT_EQ(point_met(kInflection, ray, Root::third), Vec2(1.5, 0.375));
  EXPECT_EQ(time_met(kInflection, ray, Root::third).nearest().t, 1.875);
}

TEST(Bezier, SidesAndPlacesAreExact) {
  for (const double x : {-1.5, -0.3, 0.0, 0.7, 1.9}) {
    const double y = x * x;
    const Vec2 above(x, std::nextafter(y, 9.0)), below(x, std::nextafter(y, -9.0));
    EXPECT_EQ(side_of(kParabola, above), Sign::positive) << x;
    EXPECT_EQ(side_of(kParabola, below), Sign::negative) << x;
    EXPECT_EQ(place_on(kParabola, above), PlaceOn::outside) << x;
  }
  EXPECT_EQ(side_of(kParabola, {1.5, 2.25}), Sign::zero);
  EXPECT_EQ(place_on(kParabola, {1.5, 2.25}), PlaceOn::inner);
  EXPECT_EQ(place_on(kParabola, {2, 4}), PlaceOn::at_end);
  EXPECT_EQ(place_on(kParabola, {3, 9}), PlaceOn::outside);  // of the parabola, beyond its end
  EXPECT_EQ(place_on(kLoop, {0, 3}), PlaceOn::at_end);
  EXPECT_EQ(place_on(kCusp, {0, 0}), PlaceOn::at_end);
  EXPECT_TRUE(leads_away(kParabola, Sign::positive, {{1, 1}, {1, 2.0000000000000004}}));
  EXPECT_FALSE(leads_away(kParabola, Sign::positive, {{1, 1}, {1, 2}}));
  EXPECT_TRUE(leads_away(kParabola, Sign::negative, {{1, 1}, {1, 1.9999999999999998}}));
}

// Light along the axis of a parabola goes through its focus.
TEST(Bezier, NormalsAreThoseOfTheCurve) {
  for (const double x : {-1.75, -0.3, 0.6, 1.1}) {
    const Ray ray{{x, 10}, {0, -1}};
    const ExactHit hit(ray, kParabola, Root::first);
    const Vec2 point = hit.nearest(), normal = hit.normal().normalized();
    EXPECT_EQ(point.x(), x);
    EXPECT_NEAR(point.y(), x * x, 1e-15);
    const Vec2 out = ray.direction - 2 * ray.direction.dot(normal) * normal;
    EXPECT_NEAR(cross(out, Vec2(0, 0.25) - point), 0, 1e-15);
  }
}

TEST(ExactHit, KnowsSidesOfABezierCurve) {
  const ExactHit on({{-5, 2}, {1, 0}}, Segment{{-1, 0}, {-1, 5}});  // (-1, 2), above the parabola
  EXPECT_EQ(on.side_of(kParabola), Sign::positive);
  EXPECT_EQ(on.place_on(kParabola), PlaceOn::outside);
  const ExactHit there({{-5, 1}, {1, 0}}, Segment{{-1, 0}, {-1, 5}});  // (-1, 1), on it
  EXPECT_EQ(there.side_of(kParabola), Sign::zero);
  EXPECT_EQ(there.place_on(kParabola), PlaceOn::inner);
  const ExactHit curved({{-5, 2}, {1, 0}}, kParabola, Root::second);  // (-sqrt 2, 2)
  EXPECT_EQ(curved.side_of(Segment{{-2, 2}, {0, 2}}), Sign::zero);
  EXPECT_EQ(curved.side_of(Segment{{-1.4142135623730951, 0}, {-1.4142135623730951, 4}}),
            Sign::negative);  // that double is beyond
  EXPECT_EQ(curved.side_of(Arc{Circle{{0, 2}, 1}, Arc::Extent::whole, {0, 0}, {0, 0}}),
            Sign::positive);
}

// By a chord from x = 1 to 1 + 2^-51 of the parabola, at x = 1 +- 2^-80: some 2^-131 away.
TEST(ExactHit, KnowsSidesOfABezierCurveNearerThanBoundsTell) {
  const Ray chord{{0, -1 - 0x1p-51}, {1, 2 + 0x1p-51}};
  const auto side_at = [&](const Vec2& end) {
    return ExactHit(chord, Segment{{1, 0}, end}).side_of(kParabola);
  };
  EXPECT_EQ(side_at({0, 0x1p80}), Sign::negative);
  EXPECT_EQ(side_at({1, 5}), Sign::zero);
  EXPECT_EQ(side_at({2, 0x1p80}), Sign::positive);
}

// A root of x^2 - 2 under polynomials, and where other roots of its polynomial are roots of the divisor.
TEST(RealRoot, QuotientsAreAlgebraicToo) {
  const RealRoot root = RealRoot::all({-2, 0, 1}, 1, 2)[0];
  EXPECT_EQ(compare(root.value_of({1}, {1, 1}), root.value_of({-1, 1})),
            std::strong_ordering::equal);
  EXPECT_EQ(root.value_of({1, 2}, {3, 1, 1}).sign_of({-7, -2, 23}), Sign::zero);
  const RealRoot other = RealRoot::all({6, -2, -3, 1}, 1, 2)[0];  // (x - 3) (x^2 - 2)
  EXPECT_EQ(compare(other.value_of({2}, {-3, 1}), root.value_of({-6, -2}, {7})),
            std::strong_ordering::equal);
  EXPECT_EQ(compare(RealRoot(5).value_of({1, 1}, {1, 2}), RealRoot(Rational(6) / 11)),
            std::strong_ordering::equal);
}

// A needle whose two sides are nearer to each other than any fixed steps along it are long.
TEST(Bezier, ThePlaceOfAPointIsOnItsOwnStrand) {
  for (const double height : {1.0, 0.1, 0.01}) {
    const Bezier needle({0, 0}, {8, 0.5 * height}, {1, height});
    for (int i = 0; i <= 200; ++i) {
      const double s = i / 200.0;
      ASSERT_NEAR(parameter_near(needle, point_at(needle, s)), s, 1e-8) << height;
    }
  }
  for (const double s : {0.1, 0.45, 0.78, 0.8})  // about the crossing of a loop with itself
    EXPECT_NEAR(parameter_near(kLoop, point_at(kLoop, s)), s, 1e-12);
}

// s = 1e-30 / 2 is no end, and s below the least double neither.
TEST(Bezier, RootsBesideAnEndAreNoEnds) {
  const Bezier tall({0, 0}, {1e299, 1e299}, {2e299, 0});
  const auto met = meetings(tall, {{-1, 1e-30}, {1, 0}});
  ASSERT_EQ(met.size(), 2U);
  EXPECT_FALSE(met[0].at_end);
  EXPECT_EQ(met[0].time.nearest().t, 1);
  const auto beside =
      roots_of(Bezier({30, 19}, {23, 19}, {27, 26}), {{30, 19}, {-7.000000000000001, 5e-324}});
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_TRUE(beside[0].is_end());
  EXPECT_EQ(beside[0].root, Root::first);
  EXPECT_FALSE(beside[1].is_end());
  EXPECT_EQ(beside[1].root, Root::second);
}

// Where it crosses itself, also of a ray that is tangent to one of the two strands.
TEST(Bezier, ACrossingIsACornerForTangentsToo) {
  const Bezier loop({-18, 12}, {26, -4}, {-26, -4}, {18, 12});
  const auto met = meetings(loop, {{0, 3}, {1, 1}}, {Root::none, false, true});
  const auto corner = std::find_if(
      met.begin(), met.end(), [](const WallMeeting& one) { return one.time.sign() == Sign::zero; });
  ASSERT_NE(corner, met.end());
  EXPECT_TRUE(corner->at_end);
}

TEST(Bezier, OnOneLineItIsTheStretchThatItCovers) {
  const Bezier folded({0, 1}, {8, 1}, {1, 1});  // turns at s = 8/15
  EXPECT_TRUE(is_on_one_line(folded));
  const Segment stretch = stretch_of(folded);
  EXPECT_EQ(stretch.a, Vec2(0, 1));
  EXPECT_NEAR(stretch.b.x(), 64.0 / 15, 1e-14);
  EXPECT_EQ(stretch.b.y(), 1);
}

TEST(Bezier, OnOneLineItReachesToItsLastPoint) {
  for (const double end : {-4.0, 4.0}) {  // the way there is monotone, so no turn is farther
    const Segment stretch = stretch_of(Bezier({0, 1}, {0.25 * end, 1}, {end, 1}));
    EXPECT_EQ(stretch.a, Vec2(std::min(end, 0.0), 1));
    EXPECT_EQ(stretch.b, Vec2(std::max(end, 0.0), 1));
  }
}

TEST(Bezier, OverlapsItselfFromEitherEnd) {
  const Bezier back({18, 12}, {-26, -4}, {26, -4}, {-18, 12});
  EXPECT_TRUE(overlap(kLoop, back));
  EXPECT_FALSE(overlap(kLoop, kCusp));
}

// A cap of a parabola, closed by its chord: the parity of what a half line crosses.
TEST(Bezier, CrossingsToTheRightTellTheInside) {
  const Segment chord{{2, 4}, {-2, 4}};
  int inside = 0;
  for (double x = -2.5; x <= 2.5; x += 0.25)
    for (double y = -1; y <= 5; y += 0.125) {
      const Vec2 point(x, y);
      if (place_on(kParabola, point) != PlaceOn::outside || y == 4) continue;
      const bool odd = crosses_to_right(kParabola, point) != crosses_to_right(chord, point);
      ASSERT_EQ(odd, y > x * x && y < 4) << x << ' ' << y;
      inside += odd ? 1 : 0;
    }
  EXPECT_GT(inside, 200);
}

// A box is told far only where the curve passes none of it.
TEST(Bezier, IsNearWhereItIs) {
  for (double x = -2; x <= 2; x += 0.0625) {
    EXPECT_TRUE(passes_near(kParabola, {x, x * x}, {1e-9, 1e-9})) << x;
    EXPECT_FALSE(passes_near(kParabola, {x, x * x + 0.25}, {1e-3, 1e-3})) << x;
  }
}

// What lies on a curve by an unscaled decision does so in any unit, also where no double-double holds it.
TEST(Bezier, IsTheSameInAnyUnit) {
  for (const double unit : {0x1p-900, 0x1p-300, 0x1p300, 0x1p700}) {
    const Bezier small({-2 * unit, 4 * unit}, {0, -4 * unit}, {2 * unit, 4 * unit});
    const auto met = meetings(small, {{-5 * unit, 2 * unit}, {unit, 0}});
    ASSERT_EQ(met.size(), 2U) << unit;
    EXPECT_EQ(met[0].time.nearest().t, 5 - std::sqrt(2.0));
    const auto touched = meetings(small, {{-unit, -3 * unit}, {unit, 2 * unit}});
    ASSERT_EQ(touched.size(), 1U) << unit;
    EXPECT_EQ(touched[0].root, Root::both);
  }
}

}  // namespace
}  // namespace flatray
