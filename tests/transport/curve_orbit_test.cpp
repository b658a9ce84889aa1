#include <gtest/gtest.h>

#include "anim/timeline.h"
#include "anim/world.h"
#include "base/portable_math.h"
#include "full_counts.h"
#include "oracle/long_orbit.h"
#include "scene/scene_text.h"
#include "trace/random_rays.h"
#include "trace/tracer.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

Surfaces of_ellipse(const Ellipse& curve) {
  Surfaces walls;
  walls.add(Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}});
  return walls;
}

Surfaces stadium() {
  Surfaces walls;
  walls.add(Segment{{-1, -1}, {1, -1}});
  walls.add(Arc{Circle{{1, 0}, 1}, Arc::Extent::half, {1, 0}, {0, 0}});
  walls.add(Segment{{1, 1}, {-1, 1}});
  walls.add(Arc{Circle{{-1, 0}, 1}, Arc::Extent::half, {-1, 0}, {0, 0}});
  return walls;
}

bool in_stadium(const Vec2& p) {
  if (std::fabs(p.x()) <= 1) return std::fabs(p.y()) <= 1;
  return curve_side(p, Circle{{p.x() < 0 ? -1.0 : 1.0, 0}, 1}) != Sign::positive;
}

Vec2 any_direction(Draws& draw) {
  const double angle = 6.283185307179586 * draw.unit();
  return {portable::cos(angle), portable::sin(angle)};
}

// C17: the product of the angular momenta about the foci is the same on every chord.
TEST(StiffCases, C17EllipseKeepsTheProductOfItsMomenta) {
  constexpr int kBounces = 20'000;
  const double focus = std::sqrt(5.0);
  for (const Ellipse& curve : {Ellipse({0, 0}, {3, 0}, {0, 2}), Ellipse({0, 0}, {0, -2}, {3, 0})}) {
    const Surfaces walls = of_ellipse(curve);
    const Orbit orbit = in_mirrors(walls, {{1, 0.5}, {1, 1}}, kBounces);
    ASSERT_EQ(orbit.bounces.size(), static_cast<std::size_t>(kBounces));
    for (std::size_t i = 0; i + 1 < orbit.bounces.size(); ++i) {
      const Vec2 &from = orbit.bounces[i].point, &to = orbit.bounces[i + 1].point;
      ASSERT_NE(curve_side(from, curve), Sign::positive) << i;
      const Vec2 way = (to - from).normalized();
      const double product = cross(from - Vec2(focus, 0), way) * cross(from + Vec2(focus, 0), way);
      ASSERT_NEAR(product, -2.375, kBounces * 9 * 0x1p-50) << i;
    }
  }
}

TEST(EllipseOrbit, ThroughAFocusComesThroughTheOther) {
  const Ellipse curve({0, 0}, {5, 0}, {0, 3});
  const Orbit orbit = in_mirrors(of_ellipse(curve), {{-4, 0}, {3, 4}}, 1);
  ASSERT_EQ(orbit.bounces.size(), 1U);
  const Vec2 to_focus = Vec2(4, 0) - orbit.bounces[0].point;
  EXPECT_NEAR(cross(to_focus, orbit.out), 0, 1e-14);
  EXPECT_GT(to_focus.dot(orbit.out), 0);
}

TEST(EllipseOrbit, ByACircleKeepsItsChord) {
  const Surfaces circle = of_ellipse({{0, 0}, {0, 1}, {-1, 0}});
  const Orbit orbit = in_mirrors(circle, {{0.5, 0.25}, {-1, 2}}, 5'000);
  ASSERT_EQ(orbit.bounces.size(), 5'000U);
  for (std::size_t i = 0; i + 1 < orbit.bounces.size(); ++i)
    ASSERT_NEAR((orbit.bounces[i + 1].point - orbit.bounces[i].point).norm(),
                2 * std::sqrt(1 - 0.3125), 1e4 * 0x1p-50);
}

TEST(StadiumOrbit, NeverLeaks) {
  Draws draw(50);
  const Surfaces walls = stadium();
  std::vector<Ray> rays;
  for (int i = 0; i < 300; ++i)
    rays.push_back(
        {Vec2(1.8, 0.9).cwiseProduct(2 * draw.point() - Vec2(1, 1)), any_direction(draw)});
  std::erase_if(rays, [](const Ray& ray) { return !in_stadium(ray.origin); });
  // Aimed at where a half circle and a side meet, and at the doubles about it.
  for (int i = 0; i < 400; ++i) {
    const Vec2 from = 0.9 * (2 * draw.point() - Vec2(1, 1));
    const Vec2 join(draw.whole(0, 1) == 0 ? -1 : 1, draw.whole(0, 1) == 0 ? -1 : 1);
    rays.push_back({from, join - from + 0x1p-53 * draw.grid_point(-4, 4)});
  }
  const std::vector<Orbit> orbits = trace_orbits(walls, all_mirrors(walls), rays, 200);
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    ASSERT_NE(orbits[i].end, OrbitEnd::escape) << i;
    for (std::size_t k = 0; k < orbits[i].bounces.size(); ++k) {
      const Bounce& bounce = orbits[i].bounces[k];
      ASSERT_TRUE(in_stadium(bounce.point))
          << i << " bounce " << k << " on " << bounce.surface << " at 1 - "
          << (1 - std::fabs(bounce.point.x())) / 0x1p-53 << ", 1 - "
          << (1 - std::fabs(bounce.point.y())) / 0x1p-53 << " units of 2^-53";
    }
  }
}

TEST(StadiumOrbit, AnEndOfAHalfCircleIsACorner) {
  const Orbit orbit = in_mirrors(stadium(), {{0, 0}, {1, 1}}, 10);
  EXPECT_EQ(orbit.end, OrbitEnd::corner);
  EXPECT_EQ(orbit.end_point, Vec2(1, 1));
  EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{1, 2}));
  const Orbit open = in_mirrors(stadium(), {{0, 0}, {3, 0}}, 2);
  EXPECT_EQ(open.bounces.size(), 2U);
  EXPECT_EQ(open.bounces[0].point, Vec2(2, 0));
  EXPECT_EQ(open.bounces[1].point, Vec2(-2, 0));
}

// Found by a reviewer: the arc was passed by where the segment had the lower number, and the point told was its end.
TEST(ArcOrbit, WhatJoinsAnEndOffTheCurveMakesACornerWithWhatCrossesIt) {
  const Arc arc{Circle{{0, 0}, 1}, Arc::Extent::between, {3, 0}, {0, 3}};
  const Segment across{{2, -1}, {2, 1}};
  for (const bool arc_first : {true, false}) {
    Surfaces walls;
    if (arc_first) walls.add(arc);
    walls.add(across);
    if (!arc_first) walls.add(arc);
    const Orbit orbit = in_mirrors(walls, {{4, 1}, {-2, -1}}, 10);
    EXPECT_EQ(orbit.end, OrbitEnd::corner);
    EXPECT_EQ(orbit.bounces.size(), 0U);
    EXPECT_EQ(orbit.end_point, Vec2(2, 0));
    EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{0, 1}));
  }
}

// Found by a reviewer: between the ends of an arc, but where the double to go on from lies on what joins an end that
// rounding moved off the circle.
TEST(ArcOrbit, GoesOnFromBesideAnEnd) {
  Draws draw(61);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 6.28 * draw.unit();
    const Vec2 from(portable::cos(angle), portable::sin(angle)), to(-from.y(), from.x());
    const Vec2 start = 0.5 * draw.point() - Vec2(0.25, 0.25), inward = 1e-17 * (to - from);
    const Ray ray{start, from + inward - start};
    Surfaces walls;
    walls.add(Arc{Circle{{0, 0}, 1}, Arc::Extent::between, from, to});
    const NearestHit hit = find_tracer("exact")->build(walls)->nearest_of_one(ray, {}, false);
    if (!hit || hit.at_end) continue;
    ++hits;
    const Orbit orbit = in_mirrors(walls, ray, 1);
    EXPECT_EQ(orbit.bounces.size(), 1U) << i;
    EXPECT_EQ(orbit.end, OrbitEnd::limit) << i;
    const Orbit on = in_mirrors(walls, ray, 2);
    EXPECT_TRUE(on.end != OrbitEnd::corner || on.end_point != on.bounces[0].point) << i;
  }
  EXPECT_GT(hits, 300);
}

// Found by a reviewer: what another wall meets in an end that is no double was told, or not, by the order of walls.
TEST(ArcOrbit, EndsAreMetInAnyOrderOfWalls) {
  struct Case {
    Arc arc;
    Segment across;
    Ray ray;
    Vec2 point;
  };
  const auto part = [](const Vec2& from, const Vec2& to) {
    return Arc{Circle{{0, 0}, 1}, Arc::Extent::between, from, to};
  };
  const Case cases[] = {
      {part({3, 0}, {0, 3}), {{1, -4}, {1, 4}}, {{-0.5, -0.5}, {1.5, 0.5}}, {1, 0}},
      {part({3, 1}, {-1, 0}), {{1, 0}, {4, 2}}, {{5, 0}, {-9, 2}}, {2, 2.0 / 3}},
      {part({4, 3}, {-4, 3}), {{2, 0}, {0, 1}}, {{0, -1}, {1, 2}}, {0.8, 0.6}},
      {{Circle{{0, 0}, 1}, Arc::Extent::half, {-3, 4}, {0, 0}},
       {{2, 0}, {0, 1}},
       {{0, -1}, {1, 2}},
       {0.8, 0.6}}};
  for (const auto& [arc, across, ray, point] : cases)
    for (const bool arc_first : {true, false}) {
      Surfaces walls;
      if (arc_first) walls.add(arc);
      walls.add(across);
      if (!arc_first) walls.add(arc);
      const Orbit orbit = in_mirrors(walls, ray, 10);
      EXPECT_EQ(orbit.end, OrbitEnd::corner);
      EXPECT_EQ(orbit.end_point, point);
      EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{0, 1})) << arc_first;
      std::vector<Material> with_hole = {Material::mirror, Material::hole};
      if (!arc_first) std::swap(with_hole[0], with_hole[1]);
      EXPECT_EQ(trace_orbit(walls, with_hole, ray, 10).end, OrbitEnd::absorbed) << arc_first;
    }
}

// Found by a reviewer: a disc touched in the end of a wall, and a parabola touched anywhere, are passed by.
TEST(ArcOrbit, WhatIsTouchedMakesNoCorner) {
  Surfaces walls;
  walls.add(Circle{{6, 8}, 5});
  walls.add(Segment{{3, 4}, {3, 9}});
  const std::vector<Material> disc_absorbs = {Material::hole, Material::mirror};
  const Orbit at_end = trace_orbit(walls, disc_absorbs, {{-1, 7}, {4, -3}}, 10);
  EXPECT_EQ(at_end.end, OrbitEnd::corner);
  EXPECT_EQ(at_end.end_surfaces, (std::vector<std::uint32_t>{1}));
  for (const bool upward : {true, false}) {
    Surfaces parabola;
    parabola.add(upward ? Bezier({-1, 1}, {0, -1}, {1, 1}) : Bezier({1, 1}, {0, -1}, {-1, 1}));
    parabola.add(Segment{{1, -1}, {-1, 1}});
    const Orbit orbit = in_mirrors(parabola, {{-3, 0}, {1, 0}}, 1);
    ASSERT_EQ(orbit.bounces.size(), 1U);
    EXPECT_EQ(orbit.bounces[0].surface, 1U);
    EXPECT_LE(orbit.bounces[0].point.y(), 0) << "beyond the parabola";
  }
}

// Found by a reviewer: boxes about halves of a heavy conic are as large as its legs.
TEST(BezierOrbit, AHeavyConicIsNoCornerOfWhatItIsFarFrom) {
  for (const double weight : {100.0, 1e4, 0x1p40}) {
    Surfaces walls;
    walls.add(Bezier({-2, -1}, {1, 2}, {0, 0}, weight));
    walls.add(Circle{{-2, -2}, 2});
    const Orbit orbit = in_mirrors(walls, {{0, -1}, {-1, 0}}, 1);
    ASSERT_EQ(orbit.bounces.size(), 1U) << weight;
    EXPECT_EQ(orbit.bounces[0].surface, 1U);
  }
}

// C23 among curves: the way back meets the same walls.
TEST(StadiumOrbit, IsRetracedBackwards) {
  Draws draw(51);
  const Surfaces walls = stadium();
  for (int i = 0; i < 100; ++i) {
    const Ray start{{0.5 * draw.unit(), 0.5 * draw.unit()}, any_direction(draw)};
    const Orbit there = in_mirrors(walls, start, 12);
    if (there.end != OrbitEnd::limit) continue;
    const Orbit back = in_mirrors(
        walls, {there.bounces[10].point, there.bounces[9].point - there.bounces[10].point}, 10);
    ASSERT_EQ(back.bounces.size(), 10U);
    for (std::size_t k = 0; k < 10; ++k)
      ASSERT_EQ(back.bounces[k].surface, there.bounces[9 - k].surface) << i;
    ASSERT_LT((back.bounces[9].point - there.bounces[0].point).norm(), 1e-5);
  }
}

World world_of(const std::string& shape, const std::string& pose) {
  const Scene scene = loaded(with_shape(shape) + "material = \"mirror\"\n" + pose).scene;
  return build_world(scene, at(Timeline(scene, 0, 1), 1));
}

// Shapes in any pose, whose arcs end at doubles that are not on them: rays from inside are aimed at
// the ends of walls.
TEST(CurvedShapes, NeverLeakInAnyPose) {
  Draws draw(52);
  const struct {
    std::string shape;
    Vec2 inside;
  } shapes[] = {
      {"capsule = { from = [-1, 0], to = [1, 0.5], radius = 0.7 }", {0, 0.25}},
      {"sector = { radius = 2, from = 10, to = 85 }", {0.5, 0.5}},
      {"sector = { radius = 2, from = 40, to = 310 }", {-1, 0}},
      {"sector = { radius = 2, inner = 1.3, from = 20, to = 140 }", {0.3, 1.6}},
      {"arc = { radius = 1.1, from = 30, to = 200, chord = true }", {0, 0.6}},
      {"ellipse = { radii = [1.5, 0.4], angle = 33 }", {0, 0}},
  };
  for (const auto& [shape, inside] : shapes)
    for (const std::string pose :
         {"", "angle = 17.3\nat = [0.1, 0.7]\n", "angle = -111\nat = [1e6, 3e5]\n"}) {
      const World world = world_of(shape, pose);
      const Scene scene = loaded(with_shape(shape) + pose).scene;
      const Vec2 from = entity_pose(at(Timeline(scene, 0, 1), 1), 0)(inside);
      std::vector<Vec2> ends;
      for (const Segment& wall : world.surfaces.segments) ends.insert(ends.end(), {wall.a, wall.b});
      for (const Arc& wall : world.surfaces.arcs) ends.insert(ends.end(), {wall.from, wall.to});
      std::vector<Ray> rays;
      for (int i = 0; i < 150; ++i) rays.push_back({from, any_direction(draw)});
      for (const Vec2& end : ends)
        for (int i = 0; i < 40; ++i) {
          const double ulp = 0x1p-52 * std::max(1.0, end.cwiseAbs().maxCoeff());
          rays.push_back({from, end - from + 0.25 * ulp * draw.grid_point(-8, 8)});
        }
      const std::vector<Orbit> orbits = trace_orbits(world.surfaces, world.materials(), rays, 20);
      for (std::size_t i = 0; i < orbits.size(); ++i)
        ASSERT_NE(orbits[i].end, OrbitEnd::escape)
            << shape << " " << pose << " ray " << i << " after " << orbits[i].bounces.size()
            << " bounces, from " << rays[i].origin.transpose() << " along "
            << rays[i].direction.transpose();
    }
}

// C25 with the inner circle as two halves: into the cusp and out again.
TEST(StiffCases, C25NestedTangentHalves) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  walls.add(Arc{Circle{{0.5, 0}, 0.5}, Arc::Extent::half, {0, 1}, {0, 0}});
  walls.add(Arc{Circle{{0.5, 0}, 0.5}, Arc::Extent::half, {0, -1}, {0, 0}});
  std::vector<Ray> rays;
  for (int k = 0; k < 200; ++k) {
    const double angle = 6.283185307179586 * k / 200;
    rays.push_back({{0, -0.75}, {portable::cos(angle), portable::sin(angle)}});
  }
  for (const Orbit& orbit : trace_orbits(walls, all_mirrors(walls), rays, 100)) {
    ASSERT_NE(orbit.end, OrbitEnd::escape);
    for (const Bounce& bounce : orbit.bounces) {
      ASSERT_NE(side_of(walls.arcs[0], bounce.point), Sign::positive);
      ASSERT_NE(curve_side(bounce.point, walls.arcs[1].curve), Sign::negative);
    }
  }
}

// Parabolas with the focus (0, 0), y = (x^2 - 4) / 4 and y = (4 - x^2) / 4, that meet in (-2, 0) and
// (2, 0): counter-clockwise.
Surfaces lens() {
  Surfaces walls;
  walls.add(Bezier({-2, 0}, {0, -2}, {2, 0}));
  walls.add(Bezier({2, 0}, {0, 2}, {-2, 0}));
  return walls;
}

// From the focus light goes along the axis, meets the other mirror and comes back to the focus.
TEST(BezierOrbit, LightOfTheFocusComesBackToIt) {
  const Orbit orbit = in_mirrors(lens(), {{0, 0}, {0.3, -1}}, 2);
  ASSERT_EQ(orbit.bounces.size(), 2U);
  const Vec2 axis = orbit.bounces[1].point - orbit.bounces[0].point;
  EXPECT_NEAR(axis.x(), 0, 1e-15);
  const Vec2 out = orbit.bounces[1].out;
  EXPECT_NEAR(cross(out, Vec2(0, 0) - orbit.bounces[1].point) / out.norm(), 0, 1e-14);
}

TEST(BezierOrbit, StaysInClosedRoomsAndKeepsItsSpeed) {
  Draws draw(3);
  const Surfaces walls = lens();
  std::size_t bounces = 0;
  for (int i = 0; i < 40; ++i) {
    const double x = draw.unit() - 0.5, y = draw.unit() - 0.5, angle = draw.unit();
    const Orbit orbit = in_mirrors(walls, {{x, y}, {angle - 0.5, draw.unit() - 0.5}}, 200);
    ASSERT_NE(orbit.end, OrbitEnd::escape) << i;
    const double speed = orbit.direction.norm();
    for (const Bounce& bounce : orbit.bounces) {
      for (const Bezier& wall : walls.beziers)
        ASSERT_NE(side_of(wall, bounce.point), Sign::negative) << i;
      ASSERT_NEAR(bounce.out.norm() / speed, 1, 1e-15);
    }
    bounces += orbit.bounces.size();
  }
  EXPECT_GT(bounces, 7000U);
}

// Two sharp turns, whose strands are nearer to each other than fixed steps along them are long.
TEST(BezierOrbit, GoesOnBetweenStrandsThatAreNear) {
  Surfaces walls;
  walls.add(Bezier({0, 0}, {0.7, 30}, {0.1, -0.3}));
  walls.add(Bezier({0.1, -0.3}, {0, -48}, {0, 0}));
  for (int i = 1; i < 20; ++i) {
    const double s = i / 40.0;
    const Vec2 left = point_at(walls.beziers[0], s), right = point_at(walls.beziers[0], 1 - s);
    const Ray outside{{-1, left.y()}, {1, 0}}, inside{0.5 * left + 0.5 * right, {1, 0.3}};
    EXPECT_EQ(in_mirrors(walls, outside, 1).end, OrbitEnd::limit) << i;
    EXPECT_EQ(in_mirrors(walls, inside, 60).end, OrbitEnd::limit) << i;
  }
}

// Each wall as the oracle's long numbers have it, until chaos takes the digits.
TEST(BezierOrbit, FirstBouncesAreThoseOfLongNumbers) {
  Surfaces walls = lens();
  walls.add(Bezier({-0.5, -0.25}, {-0.25, 0.5}, {0.25, -0.5}, {0.5, 0.25}));
  Draws draw(5);
  for (std::uint64_t i = 0; i < times(20); ++i) {
    const Ray start{{0.1 + draw.unit(), 0.3 * draw.unit()}, {draw.unit() - 0.5, 1}};
    const Orbit orbit = in_mirrors(walls, start, 8);
    const oracle::LongOrbit truth = oracle::long_orbit(walls, start, 8, 512);
    ASSERT_EQ(orbit.bounces.size(), truth.bounces.size());
    for (std::size_t k = 0; k < truth.bounces.size(); ++k) {
      ASSERT_EQ(orbit.bounces[k].surface, truth.bounces[k].surface) << i;
      ASSERT_NEAR((orbit.bounces[k].point - truth.bounces[k].point).norm(), 0, 1e-9) << i;
    }
  }
}

}  // namespace
}  // namespace flatray
