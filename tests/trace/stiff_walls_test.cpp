// The stiff cases of scale and shape as walls, through every exact tracer: what is met, and at which
// t, in the words of the catalogue, and in every tier the hits of the exact code.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/portable_math.h"
#include "geom/predicates.h"
#include "trace/all_tracers.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;
using Times = std::vector<double>;

const Ring kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
constexpr double kTurn = 2 * 3.14159265358979323846;

void add_ring(Surfaces& walls, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    walls.add(Segment{ring[i], ring[(i + 1) % ring.size()]});
}

Times distinct(const std::vector<NearestHit>& hits) {
  Times times;
  for (const NearestHit& hit : hits)
    if (times.empty() || times.back() != hit.t) times.push_back(hit.t);
  return times;
}

// The t at which a ray meets walls, the same by every tracer: of all hits, and the nearest.
void expect_times(const Surfaces& walls, const Ray& ray, const Times& times) {
  Case c{walls, {}};
  c.rays.add(ray);
  expect_all_tiers_exact(c);
  const NearestHit first = exact_hit_of(c, 0);
  EXPECT_EQ(static_cast<bool>(first), !times.empty());
  EXPECT_EQ(first.t, times.empty() ? kInfinity : times.front());
  for (const Tracer* tracer : exact_tracers())
    EXPECT_EQ(distinct(tracer->build(c.walls)->all_of_one(ray)), times) << tracer->name;
}

// B7: also from every first vertex and in both senses.
void expect_ring(Ring ring, const Ray& ray, const Times& times) {
  for (int reversal = 0; reversal < 2; ++reversal) {
    for (std::size_t first = 0; first < ring.size(); ++first) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      Surfaces walls;
      add_ring(walls, ring);
      expect_times(walls, ray, times);
    }
    std::reverse(ring.begin(), ring.end());
  }
}

void expect_circle(const Circle& circle, const Ray& ray, const Times& times) {
  Surfaces walls;
  walls.add(circle);
  expect_times(walls, ray, times);
}

Ring box(double low_x, double low_y, double high_x, double high_y) {
  return {{low_x, low_y}, {high_x, low_y}, {high_x, high_y}, {low_x, high_y}};
}

TEST(StiffWalls, A1HugeA2TinyAndA3Denormal) {
  for (const double u : {1e300, 1e-300, 5e-324})
    expect_ring(box(-u, -u, u, u), {{-2 * u, 0}, {4 * u, 0}}, {0.25, 0.75});
}

TEST(StiffWalls, A4Offset1e15) {
  expect_ring(box(1e15, 1e15, 1e15 + 1, 1e15 + 1), {{1e15 - 1, 1e15 + 0.5}, {3, 0}},
              {1.0 / 3, 2.0 / 3});
}

TEST(StiffWalls, A5LostFeature) {
  const double x = 1e16, same = 10000000000000001.0;
  expect_ring(box(x, 0, same, 1), {{0, 0.5}, {1e16, 0}}, {1});
  expect_ring(box(x, 0, same, 1), {{x, -1}, {0, 1}}, {1, 2});
}

TEST(StiffWalls, A6OneUlpRay) {
  expect_ring(box(1, 0, 2, 1), {{1, 0.5}, {0x1p-52, 0}}, {0, 0x1p52});
}

TEST(StiffWalls, A7ToA11NearParallel) {
  expect_ring(kSquare, {{-1, -1e-17}, {1, 1e-17}}, {1, 2});
  expect_ring(kSquare, {{-1, -2e-17}, {1, 1e-17}}, {2});
  expect_ring(kSquare, {{-1, -3e-17}, {1, 1e-17}}, {});
  expect_ring(kSquare, {{-1, 1}, {1, 1e-17}}, {});
  expect_ring(kSquare, {{-1, 1 - 0x1p-53}, {1, 1e-17}}, {1, 2});
  expect_ring(kSquare, {{-1, -5e-324}, {2, 5e-324}}, {1});
}

TEST(StiffWalls, A12LongDirection) {
  expect_ring(kSquare, {{-1, 0.5}, {0x1p1000, 0}}, {0x1p-1000, 0x1p-999});
}

// Of 65 536 points 256 lie on the ray; a naive determinant errs on thousands.
TEST(StiffWalls, A13NearCollinearGrid) {
  Surfaces walls;
  std::vector<std::uint32_t> on_the_line;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) {
      const Vec2 point(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      if (point.x() == point.y()) on_the_line.push_back(static_cast<std::uint32_t>(walls.size()));
      walls.add(Segment{point, point});
    }
  for (const Tracer* tracer : exact_tracers()) {
    std::vector<std::uint32_t> met;
    for (const NearestHit& hit : tracer->build(walls)->all_of_one({{24, 24}, {-12, -12}}))
      met.push_back(hit.surface);
    std::sort(met.begin(), met.end());
    EXPECT_EQ(met, on_the_line) << tracer->name;
  }
}

// The ray runs from (0.1, 0.3) through what the sum of doubles makes of (0.3, 0.9).
TEST(StiffWalls, A14DecimalsAreTakenAsTheirDoubles) {
  const Ray ray{{0.1, 0.3}, {0.3 - 0.1, 0.9 - 0.3}};
  ASSERT_NE(side_of_ray(ray, {0.2, 0.6}), Sign::zero);
  Surfaces point;
  point.add(Segment{{0.2, 0.6}, {0.2, 0.6}});
  expect_times(point, ray, {});
}

TEST(StiffWalls, A15TangentOfACircle) {
  const Ray ray{{-5, 10}, {4, -3}};
  expect_circle({{0, 0}, 5}, ray, {2});
  expect_circle({{0, 0}, std::nextafter(5.0, 0.0)}, ray, {});
  Surfaces more;
  more.add(Circle{{0, 0}, std::nextafter(5.0, 6.0)});
  for (const Tracer* tracer : exact_tracers())
    EXPECT_EQ(tracer->build(more)->nearest_of_one(ray).kind, HitClass::through) << tracer->name;
}

// The half chord sqrt(2^-52 - 2^-106) to either side of 1e8, each to the nearest double.
TEST(StiffWalls, A16FarCircle) {
  const double half = std::sqrt(0x1p-52 - 0x1p-106);
  expect_circle({{0, 0}, 1}, {{-1e8, 1 - 0x1p-53}, {1, 0}}, {1e8 - half, 1e8 + half});
}

TEST(StiffWalls, B1Sliver) {
  expect_ring({{0, 0}, {1, 0}, {0.5, 5e-324}}, {{0.5, 1}, {0, -1}}, {1});
}

TEST(StiffWalls, B2NothingGetsThroughASharedEdge) {
  Case c;
  add_ring(c.walls, {{0, 0}, {1, 0}, {0, 1}});
  add_ring(c.walls, {{1, 0}, {1, 1}, {0, 1}});
  for (int k = 0; k <= 1024; ++k) c.rays.add({{k / 1024.0, -1}, {0, 1}});
  expect_all_tiers_exact(c);
  for (std::size_t k = 0; k < c.rays.size(); ++k) EXPECT_EQ(exact_hit_of(c, k).t, 1) << k;
}

// Spokes and a rim; aimed at the hub from outside no ray gets past it.
TEST(StiffWalls, B3FanLeaksNoRayAtItsCentre) {
  constexpr int n = 1000;
  const Vec2 hub(1.0 / 3, 1.0 / 3);
  const auto rim = [&](int i) {
    const double angle = kTurn * i / n;
    return Vec2(hub.x() + portable::cos(angle), hub.y() + portable::sin(angle));
  };
  Case c;
  for (int i = 0; i < n; ++i) {
    c.walls.add(Segment{hub, rim(i)});
    const Vec2 from = hub + 0.5 * (rim(i) + rim(i + 1) - 2 * hub);
    if (i % 20 == 0) c.rays.add({from, hub - from});
  }
  expect_all_tiers_exact(c);
  for (std::size_t i = 0; i < c.rays.size(); ++i) EXPECT_LE(exact_hit_of(c, i).t, 1) << i;
}

TEST(StiffWalls, B4ToB6AlongAnEdgeAndAtVertices) {
  expect_ring(kSquare, {{-1, 1}, {1, 0}}, {1, 2});
  expect_ring(kSquare, {{-1, -1}, {1, 1}}, {1, 2});
  expect_ring(kSquare, {{2, -1}, {-1, 1}}, {1, 2});
  expect_ring(kSquare, {{-1, 0}, {1, 1}}, {1});
}

TEST(StiffWalls, B7OfWallsThatTieTheLowestNumberIsMet) {
  Surfaces walls;
  add_ring(walls, kSquare);
  for (const Tracer* tracer : exact_tracers()) {
    const auto made = tracer->build(walls);
    EXPECT_EQ(made->nearest_of_one({{-1, -1}, {1, 1}}).surface, 0U) << tracer->name;
    EXPECT_EQ(made->nearest_of_one({{2, 2}, {-1, -1}}).surface, 1U) << tracer->name;
  }
}

TEST(StiffWalls, B8DuplicatesAndCollinearVerticesChangeNoTime) {
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) {
    ring.insert(ring.end(), 3, kSquare[i]);
    ring.push_back(0.5 * (kSquare[i] + kSquare[(i + 1) % 4]));
  }
  expect_ring(ring, {{-1, 0.25}, {1, 0}}, {1, 2});
  expect_ring(ring, {{-1, -1}, {1, 1}}, {1, 2});
  expect_ring(ring, {{-1, 0}, {1, 1}}, {1});
  expect_ring(ring, {{0.5, -1}, {0, 3}}, {1.0 / 3, 2.0 / 3});
}

TEST(StiffWalls, B9AreaZero) {
  expect_ring({{1, 1}, {1, 1}, {1, 1}}, {{0, 0}, {1, 1}}, {1});
  expect_ring({{1, 1}, {1, 1}, {1, 1}}, {{0, 0}, {1, 2}}, {});
  expect_ring({{0, 0}, {2, 0}}, {{1, -1}, {0, 2}}, {0.5});
  expect_ring({{0, 0}, {2, 0}, {1, 0}}, {{-1, 0}, {1, 0}}, {1, 2});
  expect_ring({{0, 0}, {2, 0}, {1, 0}}, {{-1, 1}, {1, 0}}, {});
}

// The edges as they are: rays do not ask whether they cross.
TEST(StiffWalls, B10BowTie) {
  expect_ring({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{-1, 0.5}, {1, 0}}, {1, 1.5, 2});
}

TEST(StiffWalls, B11CoincidentEdgesAreAllMetAtOnce) {
  Surfaces walls;
  walls.add(Segment{{0, 1}, {1, 1}});
  for (int i = 0; i < 10'000; ++i) walls.add(Segment{{0, 0}, {1, 0}});
  for (const Tracer* tracer : exact_tracers()) {
    const auto made = tracer->build(walls);
    EXPECT_EQ(made->nearest_of_one({{0.5, -1}, {0, 1}}).surface, 1U) << tracer->name;
    const std::vector<NearestHit> hits = made->all_of_one({{0.5, -1}, {0, 1}});
    ASSERT_EQ(hits.size(), 10'001U) << tracer->name;
    EXPECT_EQ(hits[9999].t, 1) << tracer->name;
    EXPECT_EQ(hits[10'000].t, 2) << tracer->name;
  }
}

TEST(StiffWalls, B12ManyGon) {
  Surfaces walls;
  Ring ring;
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i)
    ring.emplace_back(portable::cos(kTurn * i / n), portable::sin(kTurn * i / n));
  add_ring(walls, ring);
  expect_times(walls, {{-2, 0}, {1, 0}}, {1, 3});
}

TEST(StiffWalls, B13OddCircles) {
  expect_circle({{0, 0}, 0}, {{-1, 0}, {1, 0}}, {1});
  expect_circle({{0, 0}, 5e-324}, {{-1, 0}, {1, 0}}, {1});
  expect_circle({{0, 0}, 1e308}, {{0, 0}, {1e308, 0}}, {1});
}

void expect_curve(const Bezier& curve, const Ray& ray, const Times& times) {
  Surfaces walls;
  walls.add(curve);
  expect_times(walls, ray, times);
  std::vector<Vec2> back(curve.points.begin(), curve.points.begin() + curve.degree + 1);
  std::reverse(back.begin(), back.end());
  Surfaces reversed;
  reversed.add(curve.is_weighted() ? Bezier(back[0], back[1], back[2], curve.weight)
                                   : Bezier(back));
  expect_times(reversed, ray, times);
}

// x - 1/2 = 4 u^3, y = 3/4 - 3 u^2.
TEST(StiffWalls, F1CuspOfACurve) {
  const Bezier curve({0, 0}, {1, 1}, {0, 1}, {1, 0});
  expect_curve(curve, {{-1, 0.75}, {1, 0}}, {1.5});
  expect_curve(curve, {{-1, std::nextafter(0.75, 1)}, {1, 0}}, {});
  expect_curve(curve, {{-1, std::nextafter(0.75, 0)}, {1, 0}}, {1.5});
  expect_curve(curve, {{-1, 0.75 - 3 * 0x1p-20}, {1, 0}}, {1.5 - 0x1p-28, 1.5 + 0x1p-28});
  expect_curve(curve, {{0.5, 2}, {0, -1}}, {1.25});
  expect_curve(curve, {{0.5, -1}, {0, 1}}, {1.75});
  for (const double side : {-1.0, 1.0})
    expect_curve(curve, {{0.5 + side * 0x1p-52, 2}, {0, -1}}, {1.25 + 3 * 0x1p-36});
}

// y = x^2 by its tangents, and an ulp beside them; y = x^2 / 3 as a cubic.
TEST(StiffWalls, F2DoubleRootOfACurve) {
  const Bezier parabola({-1, 1}, {0, -1}, {1, 1});
  expect_curve(parabola, {{-1, 0}, {1, 0}}, {1});
  expect_curve(parabola, {{-1, -5e-324}, {1, 0}}, {});
  expect_curve(parabola, {{-1, 0x1p-60}, {1, 0}}, {1 - 0x1p-30, 1 + 0x1p-30});
  expect_curve(parabola, {{-1, -1.25}, {1, 1}}, {1.5});
  expect_curve(parabola, {{-1, std::nextafter(-1.25, -2)}, {1, 1}}, {});
  expect_curve(parabola, {{-1, std::nextafter(-1.25, 0)}, {1, 1}}, {1.5 - 0x1p-26, 1.5 + 0x1p-26});
  const Bezier cubic({-3, 3}, {-1, -1}, {1, -1}, {3, 3});
  expect_curve(cubic, {{-3, -3.75}, {1, 1}}, {4.5});
  expect_curve(cubic, {{-3, std::nextafter(-3.75, -4)}, {1, 1}}, {});
}

// y = x^3 / 27.
TEST(StiffWalls, F3AlongAnInflection) {
  const Bezier curve({-3, -1}, {-1, 1}, {1, -1}, {3, 1});
  expect_curve(curve, {{-6, 0}, {1, 0}}, {6});
  expect_curve(curve, {{6, 0}, {-1, 0}}, {6});
  for (const double side : {-1.0, 1.0})
    expect_curve(curve, {{-6, side * 0x1p-60}, {1, 0}}, {6 + side * 3 * 0x1p-20});
  const double slope = 3 * 0x1p-60, apart = 9 * 0x1p-30;
  expect_curve(curve, {{-6, -6 * slope}, {1, slope}}, {6 - apart, 6, 6 + apart});
  expect_curve(curve, {{-6, 6 * slope}, {1, -slope}}, {6});
}

// x y = 25: a line along an asymptote meets it once, at its height, and the tangent at (5, 5) touches.
TEST(StiffWalls, F6HyperbolaByItsAsymptotes) {
  const Bezier curve({2.5, 10}, {4, 4}, {10, 2.5}, 1.25);
  expect_curve(curve, {{0, 0}, {1, 1}}, {5});
  expect_curve(curve, {{0, 0}, {1, 2}}, {std::sqrt(12.5)});
  expect_curve(curve, {{0, 10}, {1, -1}}, {5});
  expect_curve(curve, {{0, std::nextafter(10, 0)}, {1, -1}}, {});
  const double apart = 5 * 0x1p-24, later = 5 * 0x1p-49;
  expect_curve(curve, {{0, 10 + 5 * 0x1p-48}, {1, -1}}, {5 - apart + later, 5 + apart + later});
  expect_curve(curve, {{0, 4}, {1, 0}}, {6.25});
  expect_curve(curve, {{4, 12}, {0, -1}}, {5.75});
  expect_curve(curve, {{0, 2.5}, {1, 0}}, {10});
  expect_curve(curve, {{0, std::nextafter(2.5, 0)}, {1, 0}}, {});
  for (const double slope : {5e-324, -5e-324, 0x1p-50})
    expect_curve(curve, {{-1, 0}, {1, slope}}, {});
}

TEST(StiffWalls, F4CurvesThatShareAnEnd) {
  Surfaces halves, spike;  // of y = x^2; and two curves that leave (0, 0) along one tangent
  halves.add(Bezier({-1, 1}, {-0.5, 0}, {0, 0}));
  halves.add(Bezier({0, 0}, {0.5, 0}, {1, 1}));
  expect_times(halves, {{-1, 0}, {1, 0}}, {1});
  expect_times(halves, {{-1, -5e-324}, {1, 0}}, {});
  for (int k = -32; k <= 32; ++k)
    for (const double x : {k / 64.0, k * 0x1p-40}) {
      expect_times(halves, {{x, -1}, {0, 1}}, {1 + x * x});
      expect_times(halves, {{x, 1}, {0, -1}}, {1 - x * x});
    }
  spike.add(Bezier({0, 0}, {1, 0}, {1, 1}));
  spike.add(Bezier({1, -1}, {1, 0}, {0, 0}));
  expect_times(spike, {{-1, 0}, {1, 0}}, {1});
  expect_times(spike, {{0, 1}, {0, -1}}, {1});
  expect_times(spike, {{-5e-324, 1}, {0, -1}}, {});
  expect_times(spike, {{0x1p-19 - 0x1p-40, 1}, {0, -1}}, {1 - 0x1p-40, 1 + 0x1p-40});
}

}  // namespace
}  // namespace flatray
