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

}  // namespace
}  // namespace flatray
