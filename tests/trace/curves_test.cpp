#include <gtest/gtest.h>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

NearestHit nearest_curve(const Surfaces& walls, const Ray& ray,
                         const DepartedSurface& departed = {}, bool tangents = true) {
  return accelerate(walls)->nearest_of_one(ray, departed, tangents);
}

Arc whole(const Ellipse& curve) { return {curve, Arc::Extent::whole, {0, 0}, {0, 0}}; }
Arc half(const Ellipse& curve, const Vec2& towards) {
  return {curve, Arc::Extent::half, towards, {0, 0}};
}
Arc between(const Ellipse& curve, const Vec2& from, const Vec2& to) {
  return {curve, Arc::Extent::between, from, to};
}

// Whole numbers under a map of whole numbers with determinant > 0.
struct Map {
  double a, b, c, d;
  Vec2 operator()(const Vec2& v) const { return {a * v.x() + b * v.y(), c * v.x() + d * v.y()}; }
};
Map any_map(Draws& draw) {
  for (;;) {
    const Vec2 p = draw.grid_point(-6, 6), q = draw.grid_point(-6, 6);
    if (cross(p, q) > 0) return {p.x(), q.x(), p.y(), q.y()};
  }
}

Arc any_arc_of_a_circle(Draws& draw) {
  const Circle circle{draw.grid_point(-9, 9), static_cast<double>(draw.whole(1, 6))};
  if (draw.whole(0, 2) == 0) return whole(circle);
  const Vec2 from = draw.grid_point(-5, 5), to = draw.grid_point(-5, 5);
  if (cross(from, to) == 0) return whole(circle);
  return between(circle, circle.centre + from, circle.centre + to);
}

Arc mapped(const Arc& arc, const Map& map) {
  const Ellipse& curve = arc.curve;
  return {{map(curve.centre), map(curve.u), map(curve.v)}, arc.extent, map(arc.from), map(arc.to)};
}

// An affine map moves every hit along and leaves its t: the two walls share no coordinate. The arcs
// end off their circles, inside and outside, so that all that joins them to their ends is met too.
TEST(Curves, EllipsesAreMetAsTheCirclesTheyAreImagesOf) {
  Draws draw(40);
  int hits = 0, ends = 0, joints = 0, touches = 0;
  for (int scene = 0; scene < 300; ++scene) {
    Surfaces circles, ellipses;
    const Map map = any_map(draw);
    for (int i = 0; i < 5; ++i) {
      const Arc arc = any_arc_of_a_circle(draw);
      circles.add(arc);
      ellipses.add(mapped(arc, map));
      const Segment wall{draw.grid_point(-9, 9), draw.grid_point(-9, 9)};
      circles.add(wall);
      ellipses.add(Segment{map(wall.a), map(wall.b)});
    }
    for (int k = 0; k < 40; ++k) {
      const Ray ray{draw.grid_point(-12, 12), draw.grid_point(-4, 4)};
      const Ray there{map(ray.origin), map(ray.direction)};
      const bool tangents = k % 2 == 0;
      const NearestHit hit = nearest_curve(circles, ray, {}, tangents);
      ASSERT_EQ(nearest_curve(ellipses, there, {}, tangents), hit) << scene << " " << k;
      const bool curved = hit && circles.segment_slot(hit.surface) == kNoSurface;
      hits += curved ? 1 : 0;
      ends += curved && hit.at_end ? 1 : 0;
      joints += curved && hit.at_end && hit.root == Root::none ? 1 : 0;
      touches += curved && hit.root == Root::both ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(ends, 100);
  EXPECT_GT(joints, 100);
  EXPECT_GT(touches, 20);
}

TEST(Curves, ACircleByHalfDiametersGivesTheCirclesAnswers) {
  Draws draw(41);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const double r = draw.spread(-20, 20);
    const Circle circle{draw.point(), std::fabs(r)};
    Surfaces as_circle, as_ellipse, turned, half_turned;
    as_circle.add(circle);
    as_ellipse.add(whole(circle));
    turned.add(whole({circle.centre, {0, r}, {-r, 0}}));
    half_turned.add(whole({circle.centre, {-r, 0}, {0, -r}}));
    const Vec2 aim = circle.centre + r * (2 * draw.point() - Vec2(1, 1));
    const Vec2 origin = circle.centre + draw.spread(-20, 20) * (2 * draw.point() - Vec2(1, 1));
    const Ray ray{origin, draw.spread(-20, 20) * (aim - origin)};
    const NearestHit hit = nearest_curve(as_circle, ray);
    ASSERT_EQ(nearest_curve(as_ellipse, ray), hit);
    ASSERT_EQ(nearest_curve(turned, ray), hit);
    ASSERT_EQ(nearest_curve(half_turned, ray), hit);
    hits += hit ? 1 : 0;
  }
  EXPECT_GT(hits, 500);
}

Arc any_arc(Draws& draw) {
  const Ellipse curve(draw.point(), draw.point(), Vec2(draw.unit(), -draw.unit()));
  const Vec2 from = 2 * draw.point() - Vec2(1, 1), to = 2 * draw.point() - Vec2(1, 1);
  return between(curve, curve.centre + from, curve.centre + to);
}

Ray any_ray(Draws& draw) {
  const Vec2 origin = 3 * draw.point() - Vec2(1, 1);
  return {origin, 2 * draw.point() - Vec2(0.5, 0.5) - origin};
}

// Cut in two near the curve: what joins the halves there is met by rays aimed at it alone.
TEST(Curves, AnArcCutInTwoIsMetAsItWas) {
  Draws draw(42);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Arc arc = any_arc(draw);
    const Vec2& centre = arc.curve.centre;
    const Vec2 a = arc.from - centre, b = arc.to - centre;
    // In the cone, whatever its angle: the middle, or what lies opposite to it.
    Vec2 way = a.normalized() + b.normalized();
    if (cross(a, b) < 0) way = -way;
    const auto plain = [](double x) { return x; };
    const auto form = curve_form(plain, arc.curve, Pair<double>{way.x(), way.y()});
    const double size = std::fabs(form_size(plain, arc.curve));
    const Vec2 cut = centre + way * (size / std::sqrt(dot(form, form)));  // nearly on the curve
    Surfaces one, two;
    one.add(arc);
    two.add(between(arc.curve, arc.from, cut));
    two.add(between(arc.curve, cut, arc.to));
    for (int k = 0; k < 5; ++k) {
      const Ray ray = any_ray(draw);
      const NearestHit hit = nearest_curve(one, ray), of_two = nearest_curve(two, ray);
      ASSERT_EQ(of_two.surface == kNoSurface, hit.surface == kNoSurface) << i;
      ASSERT_EQ(of_two.t, hit.t) << i;
      ASSERT_EQ(of_two.kind, hit.kind) << i;
      ASSERT_EQ(of_two.root, hit.root) << i;
      hits += hit ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 5000);
}

TEST(Curves, ScaleByPowersOfTwoLeavesTimesAsTheyAre) {
  Draws draw(43);
  for (int i = 0; i < 1000; ++i) {
    const Arc arc = any_arc(draw);
    const Ray ray = any_ray(draw);
    Surfaces walls;
    walls.add(arc);
    const NearestHit hit = nearest_curve(walls, ray);
    for (const double scale : {0x1p900, 0x1p300, 0x1p-300, 0x1p-900}) {
      Surfaces scaled;
      scaled.add(Arc{{scale * arc.curve.centre, scale * arc.curve.u, scale * arc.curve.v},
                     arc.extent,
                     scale * arc.from,
                     scale * arc.to});
      ASSERT_EQ(nearest_curve(scaled, {scale * ray.origin, scale * ray.direction}), hit)
          << i << " " << scale;
    }
  }
}

TEST(Curves, ARayAndItsReverseMeetTheSamePoints) {
  Draws draw(44);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Surfaces walls;
    walls.add(any_arc(draw));
    // Sixteenths: both ends of the ray are doubles, and so is what lies between.
    const Vec2 a = draw.grid_point(-40, 40) / 16, b = draw.grid_point(-40, 40) / 16;
    if (a == b) continue;
    const NearestHit there = nearest_curve(walls, {a, b - a}),
                     back = nearest_curve(walls, {b, a - b});
    if (!there || there.t > 1) {
      ASSERT_TRUE(!back || back.t > 1) << i;
      continue;
    }
    ASSERT_TRUE(back);
    ASSERT_LE(back.t, 1) << i;
    ++hits;
    ASSERT_LE(there.t, 1 - back.t + 0x1p-52);
  }
  EXPECT_GT(hits, 200);
}

TEST(Curves, HalfCirclesAreClosed) {
  Surfaces walls;
  walls.add(half(Circle{{0, 0}, 5}, {0, 2}));
  EXPECT_EQ(nearest_curve(walls, {{0, 0}, {0, 1}}).t, 5);
  EXPECT_FALSE(nearest_curve(walls, {{0, 0}, {0, -1}}));
  EXPECT_EQ(nearest_curve(walls, {{0, -9}, {0, 1}}).t, 14);  // from below, through where it is not
  const NearestHit end = nearest_curve(walls, {{9, 0}, {-1, 0}});
  EXPECT_EQ(end.t, 4);
  EXPECT_TRUE(end.at_end);
  EXPECT_FALSE(nearest_curve(walls, {{9, -0x1p-1074}, {-1, 0}}));
  EXPECT_FALSE(nearest_curve(walls, {{9, 0x1p-1074}, {-1, 0}}).at_end);
  // Ends that are no doubles, on the line with 3 y = x
  Surfaces tilted;
  tilted.add(half(Circle{{0, 0}, 1}, {-1, 3}));
  EXPECT_TRUE(nearest_curve(tilted, {{6, 2}, {-3, -1}}).at_end);
  EXPECT_FALSE(nearest_curve(tilted, {{6, 2 + 0x1p-51}, {-3, -1}}).at_end);
}

// A15: the tangent at (3, 4), where the arc ends, or goes on, or is not.
TEST(StiffCases, A15TangentOfAnArc) {
  const Ray ray{{-5, 10}, {4, -3}};
  const auto meets = [&](const Arc& arc, bool tangents) {
    Surfaces walls;
    walls.add(arc);
    return nearest_curve(walls, ray, {}, tangents);
  };
  const Circle circle{{0, 0}, 5};
  for (const double factor : {1.0, 0x1p-40}) {
    const Circle less{{0, 0}, std::nextafter(5.0, 0.0)}, more{{0, 0}, std::nextafter(5.0, 6.0)};
    const Vec2 right(5 * factor, 0), left(-5 * factor, 0), at(3 * factor, 4 * factor);
    EXPECT_EQ(meets(between(circle, right, left), true).t, 2);
    EXPECT_EQ(meets(between(circle, right, left), true).kind, HitClass::touch);
    EXPECT_FALSE(meets(between(circle, right, left), false));
    EXPECT_FALSE(meets(between(circle, left, right), true));
    EXPECT_FALSE(meets(between(less, right, left), true));
    EXPECT_EQ(meets(between(more, right, left), true).kind, HitClass::through);
    // The end of a wall is met by rays that pass tangents by.
    EXPECT_TRUE(meets(between(circle, at, left), false).at_end);
    EXPECT_TRUE(meets(between(circle, right, at), false).at_end);
  }
}

// A16, from afar: the half that faces the ray, and the one behind it.
TEST(StiffCases, A16FarArc) {
  const Ray ray{{-1e8, 1 - 0x1p-53}, {1, 0}};
  Surfaces circle, near, far;
  circle.add(Circle{{0, 0}, 1});
  near.add(half(Circle{{0, 0}, 1}, {-1, 0}));
  far.add(half(Circle{{0, 0}, 1}, {1, 0}));
  EXPECT_EQ(nearest_curve(near, ray).t, nearest_curve(circle, ray).t);
  EXPECT_LT(nearest_curve(near, ray).t, nearest_curve(far, ray).t);
  EXPECT_NEAR(nearest_curve(far, ray).t - nearest_curve(near, ray).t, 3e-8, 2e-8);
}

TEST(StiffCases, B13ArcsOfOddRadii) {
  for (const double r : {5e-324, 1e-300, 1.0, 1e300}) {
    Surfaces walls;
    walls.add(half(Circle{{0, 0}, r}, {1, 0}));
    walls.add(whole({{0, 0}, {2 * r, 0}, {0, r}}));
    const NearestHit hit = nearest_curve(walls, {{0, 0}, {r, 0}});
    EXPECT_EQ(hit.surface, 0U);
    EXPECT_EQ(hit.t, 1);
    const NearestHit back = nearest_curve(walls, {{0, 0}, {-r, 0}});
    EXPECT_EQ(back.surface, 1U);
    EXPECT_EQ(back.t, 2);
  }
}

TEST(Curves, AZeroDirectionAsksWhatTheOriginLiesOn) {
  Surfaces walls;
  walls.add(between(Circle{{0, 0}, 5}, {5, 0}, {3, 4}));
  EXPECT_TRUE(nearest_curve(walls, {{4, 3}, {0, 0}}));
  EXPECT_FALSE(nearest_curve(walls, {{4, 3}, {0, 0}}).at_end);
  EXPECT_TRUE(nearest_curve(walls, {{3, 4}, {0, 0}}).at_end);
  EXPECT_FALSE(nearest_curve(walls, {{4, -3}, {0, 0}}));
  EXPECT_FALSE(nearest_curve(walls, {{3, 3}, {0, 0}}));
  Surfaces joined;  // ends beyond its circle
  joined.add(between(Circle{{0, 0}, 5}, {7, 0}, {0, 7}));
  EXPECT_TRUE(nearest_curve(joined, {{6, 0}, {0, 0}}).at_end);
  EXPECT_FALSE(nearest_curve(joined, {{8, 0}, {0, 0}}));
  EXPECT_FALSE(nearest_curve(joined, {{4, 0}, {0, 0}}));
}

TEST(Curves, AnArcIsLeftInTheRootStoodOn) {
  Surfaces walls;
  walls.add(half(Circle{{0, 0}, 1}, {0, 1}));
  const Ray ray{{-1, 0.5}, {1, 0}};
  EXPECT_EQ(nearest_curve(walls, ray, {0, Root::first}).root, Root::second);
  EXPECT_FALSE(nearest_curve(walls, ray, {0, Root::both}));
  EXPECT_FALSE(
      nearest_curve(walls, {{0, 1}, {0.5, -1}}, {0, Root::first}));  // out where it is open
}

Case many_curves(int count, double size, std::uint64_t seed) {
  Draws draw(seed);
  Case c;
  for (int i = 0; i < count; ++i) {
    Arc arc = any_arc(draw);
    const Vec2 move = 4 * draw.point();
    arc = {{size * arc.curve.centre + move, size * arc.curve.u, size * arc.curve.v},
           i % 3 == 0 ? Arc::Extent::whole : Arc::Extent::between,
           size * arc.from + move,
           size * arc.to + move};
    c.walls.add(arc);
    if (i % 4 == 0) c.walls.add(Circle{4 * draw.point(), size * draw.unit()});
    if (i % 5 == 0) c.walls.add(Segment{4 * draw.point(), 4 * draw.point()});
  }
  for (int i = 0; i < 300; ++i) {
    const Vec2 origin = 6 * draw.point() - Vec2(1, 1);
    DepartedSurface departed;
    if (i % 7 == 0)
      departed = {static_cast<std::uint32_t>(draw.whole(0, static_cast<int>(c.walls.size()) - 1)),
                  i % 2 == 0 ? Root::first : Root::second};
    const double far = i % 11 == 0 ? draw.spread(0, 60) : 1;
    const Vec2 direction = 4 * draw.point() - origin;
    c.rays.add({origin - far * direction, draw.spread(-30, 30) * direction}, departed);
  }
  for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1), Vec2(0, 0)})
    c.rays.add({4 * draw.point(), axis});
  return c;
}

TEST(Curves, AllTracersAndTiersAgreeBitForBit) {
  expect_all_tiers_exact(many_curves(1, 1, 45));
  expect_all_tiers_exact(many_curves(12, 0.5, 46));
  expect_all_tiers_exact(many_curves(300, 0.1, 47));
}

}  // namespace
}  // namespace flatray
