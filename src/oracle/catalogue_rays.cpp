#include <algorithm>
#include <cmath>

#include "oracle/catalogue_parts.h"

namespace flatray::oracle {
namespace {

using Rays = std::vector<StiffRay>;
using T = std::optional<double>;

Rays among(Surfaces walls, const Ray& ray, T t) {
  return {{std::make_shared<const Surfaces>(std::move(walls)), ray, t}};
}

// B7: from every first vertex and in both senses.
Rays of_ring(Ring ring, const Ray& ray, T t) {
  Rays rays;
  for (int reversal = 0; reversal < 2; ++reversal) {
    for (std::size_t first = 0; first < ring.size(); ++first) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      rays = std::move(rays) + among(ring_of(ring), ray, t);
    }
    std::reverse(ring.begin(), ring.end());
  }
  return rays;
}

template <class Curve>
Rays of_curve(const Curve& curve, const Ray& ray, T t) {
  return among(walls_of(curve), ray, t);
}

Rays scaled(double u) { return of_ring(box(-u, -u, u, u), {{-2 * u, 0}, {4 * u, 0}}, 0.25); }

// All points of the grid as walls, then all but those on the line.
Rays near_collinear() {
  Surfaces all, beside;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) {
      const Vec2 point(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      all.add(Segment{point, point});
      if (i != j) beside.add(Segment{point, point});
    }
  const Ray ray{{24, 24}, {-12, -12}};
  const double first = (24 - (0.5 + 255 * 0x1p-53)) / 12;
  return among(std::move(all), ray, first) + among(std::move(beside), ray, {});
}

Rays decimals() {
  return among(walls_of(Segment{{0.2, 0.6}, {0.2, 0.6}}), {{0.1, 0.3}, {0.3 - 0.1, 0.9 - 0.3}}, {});
}

Rays tangent() {
  const Ray ray{{-5, 10}, {4, -3}};
  return of_curve(Circle{{0, 0}, 5}, ray, 2) +
         of_curve(Circle{{0, 0}, std::nextafter(5.0, 0.0)}, ray, {});
}

Rays far_circle() {
  const double half = std::sqrt(0x1p-52 - 0x1p-106);
  return of_curve(Circle{{0, 0}, 1}, {{-1e8, 1 - 0x1p-53}, {1, 0}}, 1e8 - half);
}

Rays shared_edge() {
  Surfaces walls = ring_of({{0, 0}, {1, 0}, {0, 1}});
  add_ring(walls, {{1, 0}, {1, 1}, {0, 1}});
  const auto shared = std::make_shared<const Surfaces>(std::move(walls));
  Rays rays;
  for (int k = 0; k <= 1024; ++k) rays.push_back({shared, {{k / 1024.0, -1}, {0, 1}}, 1});
  return rays;
}

// Spokes alone: what is aimed at the hub from between two of them meets it, where t is 1.
Rays fan() {
  constexpr int kSpokes = 1000;
  const Vec2 hub(1.0 / 3, 1.0 / 3);
  const auto rim = [&](int i) {
    const double angle = kTurn * i / kSpokes;
    return Vec2(hub.x() + portable::cos(angle), hub.y() + portable::sin(angle));
  };
  Surfaces walls;
  for (int i = 0; i < kSpokes; ++i) walls.add(Segment{hub, rim(i)});
  const auto shared = std::make_shared<const Surfaces>(std::move(walls));
  Rays rays;
  for (int i = 0; i < kSpokes; i += 20) {
    const Vec2 from = hub + 0.5 * (rim(i) + rim(i + 1) - 2 * hub);
    const Vec2 way = hub - from;
    // Where origin + direction is the hub to the last bit, that is t; else the oracle has the t.
    if (from.x() + way.x() == hub.x() && from.y() + way.y() == hub.y())
      rays.push_back({shared, {from, way}, kInfinity});
  }
  return rays;
}

Rays duplicates() {
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) {
    ring.insert(ring.end(), 3, kSquare[i]);
    ring.push_back(0.5 * (kSquare[i] + kSquare[(i + 1) % 4]));
  }
  return of_ring(ring, {{-1, 0.25}, {1, 0}}, 1) + of_ring(ring, {{-1, -1}, {1, 1}}, 1) +
         of_ring(ring, {{-1, 0}, {1, 1}}, 1) + of_ring(ring, {{0.5, -1}, {0, 3}}, 1.0 / 3);
}

Rays no_area() {
  return of_ring({{1, 1}, {1, 1}, {1, 1}}, {{0, 0}, {1, 1}}, 1) +
         of_ring({{1, 1}, {1, 1}, {1, 1}}, {{0, 0}, {1, 2}}, {}) +
         of_ring({{0, 0}, {2, 0}}, {{1, -1}, {0, 2}}, 0.5) +
         of_ring({{0, 0}, {2, 0}, {1, 0}}, {{-1, 0}, {1, 0}}, 1) +
         of_ring({{0, 0}, {2, 0}, {1, 0}}, {{-1, 1}, {1, 0}}, {});
}

Rays coincident() {
  Surfaces walls = walls_of(Segment{{0, 1}, {1, 1}});
  for (int i = 0; i < 10'000; ++i) walls.add(Segment{{0, 0}, {1, 0}});
  return among(std::move(walls), {{0.5, -1}, {0, 1}}, 1);
}

Rays odd_circles() {
  return of_curve(Circle{{0, 0}, 0}, {{-1, 0}, {1, 0}}, 1) +
         of_curve(Circle{{0, 0}, 5e-324}, {{-1, 0}, {1, 0}}, 1) +
         of_curve(Circle{{0, 0}, 1e308}, {{0, 0}, {1e308, 0}}, 1);
}

// x - 1/2 = 4 u^3 and y = 3/4 - 3 u^2: it turns back at u = 0.
Rays cusp() {
  const Bezier curve({0, 0}, {1, 1}, {0, 1}, {1, 0});
  return of_curve(curve, {{-1, 0.75}, {1, 0}}, 1.5) +
         of_curve(curve, {{-1, 0.75 + 0x1p-53}, {1, 0}}, {}) +
         of_curve(curve, {{-1, 0.75 - 0x1p-53}, {1, 0}}, 1.5) +
         of_curve(curve, {{0.5, 2}, {0, -1}}, 1.25) + of_curve(curve, {{0.5, -1}, {0, 1}}, 1.75) +
         of_curve(curve, {{0.5 + 0x1p-52, 2}, {0, -1}}, 1.25 + 3 * 0x1p-36);
}

// y = x^2 and, as a cubic, y = x^2 / 3.
Rays double_roots() {
  const Bezier parabola({-1, 1}, {0, -1}, {1, 1}), cubic({-3, 3}, {-1, -1}, {1, -1}, {3, 3});
  return of_curve(parabola, {{-1, 0}, {1, 0}}, 1) +
         of_curve(parabola, {{-1, -5e-324}, {1, 0}}, {}) +
         of_curve(parabola, {{-1, 0x1p-60}, {1, 0}}, 1 - 0x1p-30) +
         of_curve(parabola, {{-1, -1.25}, {1, 1}}, 1.5) +
         of_curve(parabola, {{-1, -1.25 - 0x1p-52}, {1, 1}}, {}) +
         of_curve(parabola, {{-1, -1.25 + 0x1p-52}, {1, 1}}, 1.5 - 0x1p-26) +
         of_curve(cubic, {{-3, -3.75}, {1, 1}}, 4.5) +
         of_curve(cubic, {{-3, -3.75 - 0x1p-51}, {1, 1}}, {});
}

// x y = 25 for x from 2.5 to 10: its tangent at (5, 5), and lines along its asymptotes.
Rays hyperbola() {
  const Bezier curve({2.5, 10}, {4, 4}, {10, 2.5}, 1.25);
  return of_curve(curve, {{0, 0}, {1, 1}}, 5) + of_curve(curve, {{0, 10}, {1, -1}}, 5) +
         of_curve(curve, {{0, 10 - 0x1p-49}, {1, -1}}, {}) +
         of_curve(curve, {{0, 10 + 5 * 0x1p-48}, {1, -1}}, 5 - 5 * 0x1p-24 + 5 * 0x1p-49) +
         of_curve(curve, {{0, 4}, {1, 0}}, 6.25) + of_curve(curve, {{0, 2.5}, {1, 0}}, 10) +
         of_curve(curve, {{0, 2.5 - 0x1p-51}, {1, 0}}, {}) +
         of_curve(curve, {{4, 12}, {0, -1}}, 5.75) + of_curve(curve, {{-9, -9}, {0x1p-50, 1}}, {});
}

// y = x^3 / 27, by lines of slopes 0 and +-3 * 2^-60.
Rays inflection() {
  const Bezier curve({-3, -1}, {-1, 1}, {1, -1}, {3, 1});
  constexpr double kSlope = 3 * 0x1p-60;
  return of_curve(curve, {{-6, 0}, {1, 0}}, 6) +
         of_curve(curve, {{-6, 0x1p-60}, {1, 0}}, 6 + 3 * 0x1p-20) +
         of_curve(curve, {{-6, -0x1p-60}, {1, 0}}, 6 - 3 * 0x1p-20) +
         of_curve(curve, {{-6, -6 * kSlope}, {1, kSlope}}, 6 - 9 * 0x1p-30) +
         of_curve(curve, {{-6, 6 * kSlope}, {1, -kSlope}}, 6);
}

// Two halves of y = x^2 from either side, and two curves that leave (0, 0) along one tangent.
Rays shared_end() {
  const Surfaces halves =
      walls_of(Bezier({-1, 1}, {-0.5, 0}, {0, 0}), Bezier({0, 0}, {0.5, 0}, {1, 1}));
  const Surfaces spike = walls_of(Bezier({0, 0}, {1, 0}, {1, 1}), Bezier({1, -1}, {1, 0}, {0, 0}));
  Rays rays = among(halves, {{-1, 0}, {1, 0}}, 1) + among(halves, {{-1, -5e-324}, {1, 0}}, {}) +
              among(spike, {{-1, 0}, {1, 0}}, 1) + among(spike, {{0, 1}, {0, -1}}, 1) +
              among(spike, {{-5e-324, 1}, {0, -1}}, {}) +
              among(spike, {{0x1p-19 - 0x1p-40, 1}, {0, -1}}, 1 - 0x1p-40);
  const auto shared = std::make_shared<const Surfaces>(halves);
  for (int k = -32; k <= 32; ++k)
    for (const double x : {k / 64.0, k * 0x1p-40})
      rays = std::move(rays) +
             Rays{{shared, {{x, -1}, {0, 1}}, 1 + x * x}, {shared, {{x, 1}, {0, -1}}, 1 - x * x}};
  return rays;
}

// y = x^2 / 4, whose focus is (0, 1), under a lid: what comes down the axis leaves up it, by the focus.
std::vector<StiffOrbits> focus() {
  StiffOrbits orbits{
      walls_of(Bezier({-8, 16}, {0, -16}, {8, 16}), Segment{{8, 16}, {-8, 16}}), {}, 60};
  for (int k = 9; k < 128; k += 7) orbits.starts.push_back({{k / 16.0, 16}, {0, -1}});
  orbits.count = orbits.ordered = orbits.bounces;
  orbits.room = 1;
  return {orbits};
}

std::vector<StiffCase> of_scale() {
  const double x = 1e16, same = 10000000000000001.0;
  const Ray beside_top{{-1, 1 - 0x1p-53}, {1, 1e-17}};
  return {
      {"A1", "huge", "trace.StiffWalls.A1HugeA2TinyAndA3Denormal", scaled(1e300)},
      {"A2", "tiny", "trace.StiffWalls.A1HugeA2TinyAndA3Denormal", scaled(1e-300)},
      {"A3", "denormal", "trace.StiffWalls.A1HugeA2TinyAndA3Denormal", scaled(5e-324)},
      {"A4", "offset 1e15", "trace.StiffWalls.A4Offset1e15",
       of_ring(box(1e15, 1e15, 1e15 + 1, 1e15 + 1), {{1e15 - 1, 1e15 + 0.5}, {3, 0}}, 1.0 / 3)},
      {"A5", "lost feature", "trace.StiffWalls.A5LostFeature",
       of_ring(box(x, 0, same, 1), {{0, 0.5}, {1e16, 0}}, 1) +
           of_ring(box(x, 0, same, 1), {{x, -1}, {0, 1}}, 1)},
      {"A6", "one-ulp ray", "trace.StiffWalls.A6OneUlpRay",
       of_ring(box(1, 0, 2, 1), {{1, 0.5}, {0x1p-52, 0}}, 0)},
      {"A7", "near-parallel, hit", "trace.StiffWalls.A7ToA11NearParallel",
       of_ring(kSquare, {{-1, -1e-17}, {1, 1e-17}}, 1)},
      {"A8", "near-parallel, touch", "trace.StiffWalls.A7ToA11NearParallel",
       of_ring(kSquare, {{-1, -2e-17}, {1, 1e-17}}, 2)},
      {"A9", "near-parallel, miss", "trace.StiffWalls.A7ToA11NearParallel",
       of_ring(kSquare, {{-1, -3e-17}, {1, 1e-17}}, {})},
      {"A10", "top edge", "trace.StiffWalls.A7ToA11NearParallel",
       of_ring(kSquare, {{-1, 1}, {1, 1e-17}}, {}) + of_ring(kSquare, beside_top, 1)},
      {"A11", "denormal slope", "trace.StiffWalls.A7ToA11NearParallel",
       of_ring(kSquare, {{-1, -5e-324}, {2, 5e-324}}, 1)},
      {"A12", "long direction", "trace.StiffWalls.A12LongDirection",
       of_ring(kSquare, {{-1, 0.5}, {0x1p1000, 0}}, 0x1p-1000)},
      {"A13", "near-collinear grid", "trace.StiffWalls.A13NearCollinearGrid", near_collinear()},
      {"A14", "decimals", "trace.StiffWalls.A14DecimalsAreTakenAsTheirDoubles", decimals()},
      {"A15", "tangent of a circle", "trace.StiffWalls.A15TangentOfACircle", tangent()},
      {"A16", "far circle", "trace.StiffWalls.A16FarCircle", far_circle()},
  };
}

std::vector<StiffCase> of_shape() {
  return {
      {"B1", "sliver", "trace.StiffWalls.B1Sliver",
       of_ring({{0, 0}, {1, 0}, {0.5, 5e-324}}, {{0.5, 1}, {0, -1}}, 1)},
      {"B2", "shared edge", "trace.StiffWalls.B2NothingGetsThroughASharedEdge", shared_edge()},
      {"B3", "fan", "trace.StiffWalls.B3FanLeaksNoRayAtItsCentre", fan()},
      {"B4", "along an edge", "trace.StiffWalls.B4ToB6AlongAnEdgeAndAtVertices",
       of_ring(kSquare, {{-1, 1}, {1, 0}}, 1)},
      {"B5", "through a vertex", "trace.StiffWalls.B4ToB6AlongAnEdgeAndAtVertices",
       of_ring(kSquare, {{-1, -1}, {1, 1}}, 1) + of_ring(kSquare, {{2, -1}, {-1, 1}}, 1)},
      {"B6", "vertex touch", "trace.StiffWalls.B4ToB6AlongAnEdgeAndAtVertices",
       of_ring(kSquare, {{-1, 0}, {1, 1}}, 1)},
      {"B7", "clockwise, any start vertex", "trace.StiffWalls.B7OfWallsThatTieTheLowestNumberIsMet",
       of_ring(kSquare, {{2, 2}, {-1, -1}}, 1)},
      {"B8", "duplicates, collinear",
       "trace.StiffWalls.B8DuplicatesAndCollinearVerticesChangeNoTime", duplicates()},
      {"B9", "area zero", "trace.StiffWalls.B9AreaZero", no_area()},
      {"B10", "bow-tie", "trace.StiffWalls.B10BowTie",
       of_ring({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{-1, 0.5}, {1, 0}}, 1)},
      {"B11", "coincident edges", "trace.StiffWalls.B11CoincidentEdgesAreAllMetAtOnce",
       coincident()},
      {"B12", "many-gon", "trace.StiffWalls.B12ManyGon",
       among(ring_of(regular(100'000)), {{-2, 0}, {1, 0}}, 1)},
      {"B13", "odd circles", "trace.StiffWalls.B13OddCircles", odd_circles()},
  };
}

std::vector<StiffCase> of_curves() {
  return {
      {"F1", "cusp of a curve", "trace.StiffWalls.F1CuspOfACurve", cusp()},
      {"F2", "double root of a curve", "trace.StiffWalls.F2DoubleRootOfACurve", double_roots()},
      {"F3", "along an inflection", "trace.StiffWalls.F3AlongAnInflection", inflection()},
      {"F4", "curves that share an end", "trace.StiffWalls.F4CurvesThatShareAnEnd", shared_end()},
      of("F5", "focus of a parabola", "precise.CertifiedOrbit.F5FocusOfAParabola", focus()),
      {"F6", "tangent and asymptotes of a hyperbola", "trace.StiffWalls.F6HyperbolaByItsAsymptotes",
       hyperbola()},
  };
}

}  // namespace

std::vector<StiffCase> stiff_rays() { return of_scale() + of_shape() + of_curves(); }

}  // namespace flatray::oracle
