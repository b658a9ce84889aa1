// Walls too large or too small for the lanes' bounds: every tracer against the exact code.
#include <gtest/gtest.h>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

Case rooms(double size, std::uint64_t seed) {
  Draws draw(seed);
  Case c;
  for (int i = 0; i < 40; ++i) {
    const Vec2 a = size * draw.grid_point(-9, 9), b = size * draw.grid_point(-9, 9);
    c.walls.add(Segment{a, b});
  }
  for (int i = 0; i < 30; ++i) {
    const Vec2 from = size * draw.grid_point(-12, 12), to = size * draw.grid_point(-9, 9);
    c.rays.add({from, to - from});
    c.rays.add({from, {draw.unit() - 0.5, draw.unit() - 0.5}});
    c.rays.add({{draw.unit(), size}, {0, -size}});
    c.rays.add({c.walls.segments[static_cast<std::size_t>(i % 40)].a, to - from},
               {static_cast<std::uint32_t>(i % 40), Root::none});
    c.rays.add({from, {0, 0}});
  }
  return c;
}

TEST(ExtremeSizes, WallsOfAnySizeAreTracedExactly) {
  std::uint64_t seed = 1;
  for (const double size : {5e-324, 0x1p-1040, 0x1p-1000, 0x1p-905, 0x1p899, 0x1p960, 0x1p1019})
    expect_all_tiers_exact(rooms(size, seed++));
}

// A wall of 2^1000 and one of 2^-1000.
TEST(ExtremeSizes, WallsOfBothExtremesAreTracedExactly) {
  Case c = rooms(0x1p1000, 10);
  c.walls.add(Segment{{0, 0}, {0x1p-1074, 0x1p-1060}});
  expect_all_tiers_exact(c);
}

// More ellipses than are asked one by one without cells, of sizes whose squares are no doubles.
TEST(ExtremeSizes, EllipsesOfAnySizeAreTracedExactly) {
  for (const double size : {1e-119, 1e-110, 1e-85, 1e-75, 1e70, 1e85, 1e119}) {
    Draws draw(7);
    Case c;
    for (int i = 0; i < 40; ++i)
      c.walls.add(
          Arc{Ellipse(10 * size * draw.point(), size * Vec2(0.3, 0.2), size * Vec2(-0.2, 0.1)),
              Arc::Extent::whole,
              {0, 0},
              {0, 0}});
    for (int i = 0; i < 40; ++i) {
      const Vec2 from(-size, 10 * size * draw.unit());
      const Vec2 to = c.walls.arcs[static_cast<std::size_t>(i)].curve.centre;
      c.rays.add({from, to - from});
      c.rays.add({from, (to - from) / size});
    }
    expect_all_tiers_exact(c);
  }
}

// From so far that what lies ahead of the ray is beyond the doubles.
TEST(ExtremeSizes, CurvesAreMetFromTheEndOfTheDoubles) {
  Case c;
  c.walls.add(Segment{{10, -0.5}, {10, 0.5}});
  c.walls.add(Circle{{0, 0}, 1});
  for (const double speed : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    c.rays.add({{-1e300, 0}, {speed, 0}});
    c.rays.add({{1e300, 0}, {-speed, 0}});
  }
  expect_all_tiers_exact(c);
}

}  // namespace
}  // namespace flatray
