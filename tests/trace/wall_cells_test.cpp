#include "trace/wall_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

// Short and long walls, and curves of all sizes.
Surfaces crowd(Draws& draw, int count, const Vec2& offset) {
  Surfaces walls;
  for (int i = 0; i < count; ++i) {
    const Vec2 at = draw.point() + offset;
    const double size = i % 8 == 0 ? 1 : 0.01;
    if (i % 4 == 3) {
      walls.add(Circle{at, size * draw.unit()});
    } else {
      const Vec2 way = draw.point() - Vec2(0.5, 0.5);
      walls.add(Segment{at, at + size * way});
    }
  }
  return walls;
}

std::vector<std::uint32_t> near(const WallCells& cells, const Vec2& point) {
  return cells.near(point, [](std::uint32_t) { return true; });
}

TEST(WallCells, KnowEveryWallThatComesNearAPoint) {
  for (const double offset : {0.0, 1e3, 1e9}) {
    Draws draw(1);
    const Surfaces walls = crowd(draw, 4000, Vec2(offset, -3 * offset));
    const WallCells cells(walls);
    std::size_t seen = 0;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      Vec2 on;
      const double part = draw.unit();
      if (walls.segment_slot(i) != kNoSurface) {
        const Segment& wall = walls.segment(i);
        on = wall.a + part * (wall.b - wall.a);
      } else {
        const Circle circle = circle_of(walls.arc(i).curve);
        on = circle.centre + circle.radius * Vec2(std::cos(6.28 * part), std::sin(6.28 * part));
      }
      const std::vector<std::uint32_t> found = near(cells, on);
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i)) << i << " at " << offset;
      EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end());
      seen += found.size();
    }
    EXPECT_LT(seen, walls.size() * 200);
  }
}

TEST(WallCells, HoldAFewCellsAWallHoweverLongWallsAre) {
  Draws draw(2);
  Surfaces walls;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 from = draw.point(), to = draw.point();
    walls.add(Segment{from, to});
  }
  const WallCells cells(walls);
  EXPECT_LT(cells.entries(), 12 * walls.size());
}

TEST(WallCells, OfAFlatSceneAreARow) {
  Surfaces walls;
  for (int i = 0; i < 100; ++i) walls.add(Segment{Vec2(i, 0), Vec2(i + 1, 0)});
  EXPECT_LT(near(WallCells(walls), Vec2(3, 0)).size(), 5U);
}

}  // namespace
}  // namespace flatray
