#include "study/rooms/wall_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flatray {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

// An ellipse of half-axes 2 and 1, whose perimeter is known, arcs of it and of circles either way
// round, of less and of more than half a turn, and a wall.
Surfaces walls_of_all_kinds() {
  const auto whole = Arc::Extent::whole, between = Arc::Extent::between;
  Surfaces walls;
  walls.add(Arc{Ellipse({1, 2}, {2, 0}, {0, 1}), whole, {0, 0}, {0, 0}});
  walls.add(Arc{Ellipse({1, 2}, {2, 0}, {0, -1}), whole, {0, 0}, {0, 0}});
  walls.add(Arc{Ellipse({1, 2}, {0, 1}, {2, 0}), between, {3, 2}, {1, 3}});
  walls.add(Arc{Ellipse({1, 2}, {2, 0}, {0, 1}), between, {1, 3}, {3, 2}});
  walls.add(Arc{Circle{{-1, 0}, 2}, between, {1, 0}, {-1, 2}});
  walls.add(Arc{Circle{{-1, 0}, 2}, between, {-1, 2}, {1, 0}});
  walls.add(Circle{{3, -1}, 0.5});
  walls.add(Segment{{1, 1}, {4, 5}});
  return walls;
}

TEST(WallPlaces, LengthsAreThoseOfTheCurves) {
  constexpr double kPerimeter = 9.688448220547675;  // 4 a E(e) for 2 and 1
  const Surfaces walls = walls_of_all_kinds();
  EXPECT_NEAR(WallPlaces(walls).length(0), kPerimeter, 1e-9);
  EXPECT_NEAR(WallPlaces(walls).length(1), kPerimeter, 1e-9);
  EXPECT_NEAR(WallPlaces(walls).length(2), 0.25 * kPerimeter, 1e-7);
  EXPECT_NEAR(WallPlaces(walls).length(3), 0.75 * kPerimeter, 1e-7);
  EXPECT_NEAR(WallPlaces(walls).length(4), kHalfTurn, 1e-14);
  EXPECT_NEAR(WallPlaces(walls).length(5), 3 * kHalfTurn, 1e-14);
  EXPECT_NEAR(WallPlaces(walls).length(6), kHalfTurn, 1e-14);
  EXPECT_EQ(WallPlaces(walls).length(7), 5);
}

TEST(WallPlaces, APointByItsPositionHasThatPosition) {
  const Surfaces walls = walls_of_all_kinds();
  for (std::uint32_t wall = 0; wall < walls.size(); ++wall) {
    const double length = WallPlaces(walls).length(wall);
    for (const double share : {0.0, 0.01, 0.2, 0.5, 0.77, 0.99}) {
      const Vec2 point = WallPlaces(walls).point(wall, share * length);
      EXPECT_NEAR(WallPlaces(walls).position(wall, point), share * length, 1e-7)
          << wall << " " << share;
      if (walls.segment_slot(wall) != kNoSurface) continue;
      const Ellipse curve = walls.arc(wall).curve;  // (u, v)-coordinates on the unit circle
      const double area = cross(curve.u, curve.v);
      const Vec2 from = point - curve.centre;
      EXPECT_NEAR(std::hypot(cross(from, curve.v) / area, cross(curve.u, from) / area), 1, 1e-13);
    }
  }
}

// Points a small way apart along a wall are as far from each other; the normal is across that, of
// length 1 and outward; its turn over the way is the curvature, which is positive seen from outside.
TEST(WallPlaces, NormalsAndCurvatureAreThoseOfNeighbours) {
  const Surfaces walls = walls_of_all_kinds();
  constexpr double kStep = 1e-3;
  for (std::uint32_t wall = 0; wall < 7; ++wall)
    for (const double share : {0.1, 0.3, 0.6, 0.8}) {
      const double s = share * WallPlaces(walls).length(wall);
      const Vec2 before = WallPlaces(walls).point(wall, s - kStep),
                 point = WallPlaces(walls).point(wall, s),
                 after = WallPlaces(walls).point(wall, s + kStep), way = after - before;
      EXPECT_NEAR(way.norm(), 2 * kStep, 1e-8);
      const Vec2 normal = wall_normal(walls, wall, point);
      EXPECT_NEAR(normal.norm(), 1, 1e-15);
      EXPECT_NEAR(normal.dot(way), 0, 1e-7);
      EXPECT_GT(normal.dot(point - walls.arc(wall).curve.centre), 0) << wall;
      const Vec2 turned = wall_normal(walls, wall, after) - wall_normal(walls, wall, before);
      const double bend = turned.norm() / (2 * kStep);
      EXPECT_NEAR(curvature(walls, wall, point, normal), bend, 1e-4 * bend) << wall;
      EXPECT_EQ(curvature(walls, wall, point, -normal), -curvature(walls, wall, point, normal));
    }
}

// At the ends of its axes an ellipse bends by a / b^2 and b / a^2.
TEST(WallPlaces, AnEllipseBendsMostWhereItIsLong) {
  const Surfaces walls = walls_of_all_kinds();
  EXPECT_NEAR(curvature(walls, 0, {3, 2}, {1, 0}), 2, 1e-14);
  EXPECT_NEAR(curvature(walls, 0, {1, 3}, {0, 1}), 0.25, 1e-14);
  EXPECT_NEAR(curvature(walls, 1, {1, 3}, {0, -1}), -0.25, 1e-14);
}

TEST(WallPlaces, OutlinesGoFromEndToEndOnTheWall) {
  const Surfaces walls = walls_of_all_kinds();
  EXPECT_EQ(wall_outline(walls, 7), (std::vector<Vec2>{{1, 1}, {4, 5}}));
  for (std::uint32_t wall = 0; wall < 7; ++wall) {
    const std::vector<Vec2> points = wall_outline(walls, wall);
    ASSERT_GT(points.size(), 20U);
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    EXPECT_NEAR(length, WallPlaces(walls).length(wall), 2e-3 * length) << wall;
    EXPECT_LT((points.front() - WallPlaces(walls).point(wall, 0)).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace flatray
