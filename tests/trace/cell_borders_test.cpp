// Rays along the borders of cells, where rounding tells on which side they are: every tracer against the
// exact code for every wall, bit for bit.
#include <gtest/gtest.h>

#include "trace/cells.h"
#include "trace/crowd.h"

namespace flatray {
namespace {

// Axis-parallel rays along the borders of cells, on a lattice of walls.
TEST(Tracers, AgreesOnALattice) {
  Draws draw(4);
  Case c;
  for (int x = 0; x <= 12; ++x)
    for (int y = 0; y < 12; ++y) {
      if (draw.bits() % 3 == 0) c.walls.add(Segment{Vec2(x, y), Vec2(x, y + 1)});
      if (draw.bits() % 3 == 0) c.walls.add(Segment{Vec2(y, x), Vec2(y + 1, x)});
    }
  for (int i = 0; i < 600; ++i) c.rays.add({0.5 * draw.grid_point(0, 24), draw.grid_point(-2, 2)});
  expect_all_tiers_exact(c);
}

// Found by `stability --families sliver`: just below the middle, a place is a whole cell from the
// corner of its crowded cell, as far as doubles can say.
TEST(Tracers, AgreeJustBelowTheBorderOfACrowdedCell) {
  Case c;
  const double tiny = 0x1p-400;
  for (int i = 0; i < 40; ++i) {
    const double x = i - 20;
    c.walls.add(Segment{{x, -4 * tiny}, {x + 0.75, 4 * tiny}});
    c.walls.add(Segment{{4 * tiny, x}, {-4 * tiny, x + 0.75}});
    for (int k = 0; k < 4; ++k)  // no two the same
      c.walls.add(
          Segment{{-0.25 + 0.1 * k, -3 * tiny}, {-0.2 + 0.1 * k, (3 + i * 0x1p-50) * tiny}});
    for (const double y : {-5 * tiny, -1 * tiny, 1 * tiny, 5 * tiny}) {
      c.rays.add({{x / 40, y}, {0, -y}});
      c.rays.add({{x / 40, y}, {1, -y}});
      c.rays.add({{x / 40, y}, {-1, y}});
      c.rays.add({{y, x / 40}, {-y, 0}});
    }
  }
  const auto grid = CellGrid::build(c.walls);
  ASSERT_TRUE(grid);
  EXPECT_GT(grid->divided(), 0U);
  expect_all_tiers_exact(c);
}

// A long wall that a ray along a border meets late, but that is in the list of its first cell, must not be taken for
// the first. Cells meet in the middle, where walls crowd. Along both axes.
TEST(Tracers, AgreeOnLongWallsAlongTheBordersOfCells) {
  for (const int axis : {0, 1}) {
    Draws draw(18);
    const auto point = [&](double across, double along) {
      return axis == 0 ? Vec2(across, along) : Vec2(along, across);
    };
    const auto little = [&] {
      return std::ldexp(draw.unit() - 0.5, -static_cast<int>(draw.bits() % 64));
    };
    Case c;
    c.walls = crowd(draw, 0, 1);
    for (int i = 0; i < 32; ++i) {
      const double aside = std::ldexp(draw.unit() - 0.5, -i / 2);
      c.walls.add(
          Segment{point(0.5 - aside * draw.unit(), 0), point(0.5 + aside * draw.unit(), 1)});
    }
    for (int i = 0; i < 100; ++i) {
      const Vec2 at = Vec2(0.49, 0.49) + 0.02 * draw.point();
      c.walls.add(Segment{at, at + 0.01 * draw.point()});
    }
    const auto grid = CellGrid::build(c.walls);
    ASSERT_TRUE(grid);
    ASSERT_GT(grid->divided(), 0U);
    const double cell = 1 / grid->scale()[axis];
    for (int i = 0; i < 800; ++i) {
      const double at = 0.5 + std::floor(4 * little()) / 64 * cell, along = draw.unit();
      const Vec2 way = point(little(), i % 2 == 0 ? 1 : -1);
      c.rays.add({point(at, along), way});
      c.rays.add({point(std::nextafter(at, way[axis] > 0 ? 0 : 1), along), way});
      c.rays.add({point(at + little() * cell, along), way});
    }
    expect_all_tiers_exact(c);
  }
}

// Of a crowded cell whose border a ray runs along, rounding may say that it leaves its cells at once.
TEST(Tracers, AgreeOnRaysAlongTheBordersOfCrowdedCells) {
  for (const bool of_curves : {false, true}) {
    Draws draw(19);
    Case c;
    c.walls.add(Circle{{0, 0}, 1});
    c.walls.add(Segment{{-1, -1}, {-1, 1}});
    c.walls.add(Segment{{1, -1}, {1, 1}});
    for (int i = 0; i < 100; ++i) {
      const Vec2 at = (i % 5 == 0 ? 2 : 0.05) * (draw.point() - Vec2(0.5, 0.5));
      if (of_curves)
        c.walls.add(Circle{at, 0.02 * draw.unit() * draw.unit()});
      else
        c.walls.add(Segment{at, at + 0.04 * (draw.point() - Vec2(0.5, 0.5))});
    }
    const auto grid = of_curves ? CellGrid::build_of_curves(c.walls) : CellGrid::build(c.walls);
    ASSERT_TRUE(grid);
    ASSERT_GT(grid->divided(), 0U);
    for (int i = 0; i < 2000; ++i) {
      const auto little = [&] {
        return std::ldexp(draw.unit() - 0.5, -40 - static_cast<int>(draw.bits() % 20));
      };
      const Vec2 from(0.05 * (draw.unit() - 0.5), little()), way(i % 2 == 0 ? 1 : -1, little());
      if (i % 4 < 2)
        c.rays.add({from, way});
      else
        c.rays.add({{from.y(), from.x()}, {way.y(), way.x()}});
    }
    expect_all_tiers_exact(c);
  }
}

}  // namespace
}  // namespace flatray
