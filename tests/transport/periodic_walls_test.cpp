#include "transport/periodic_walls.h"

#include <gtest/gtest.h>

#include "geom/primitives/wall.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

// A box of periodic walls and discs in it.
struct Torus {
  Surfaces walls;
  std::vector<Material> materials;

  explicit Torus(const std::vector<Circle>& discs,
                 const std::vector<Vec2>& cell = {{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      : walls(ring(cell)), materials(cell.size(), Material::periodic) {
    for (const Circle& disc : discs) walls.add(disc);
    materials.resize(walls.size(), Material::mirror);
  }
  Orbit orbit(const Ray& start, std::uint64_t bounces) const {
    return trace_orbit(walls, materials, start, bounces);
  }
};

TEST(PeriodicWalls, AreCrossedToThePlaceOpposite) {
  const Orbit orbit = Torus({{{0.5, 0.5}, 0.125}}).orbit({{0.75, 0.25}, {1, 0.25}}, 1);
  // (1, 5/16), (0, 5/16), and on to the disc.
  ASSERT_EQ(orbit.crossings.size(), 1U);
  EXPECT_EQ(orbit.crossings[0].from, Vec2(1, 0.3125));
  EXPECT_EQ(orbit.crossings[0].to, Vec2(0, 0.3125));
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_EQ(orbit.bounces[0].surface, 4U);
  const double from_wall = (orbit.bounces[0].point - Vec2(0, 0.3125)).x();
  EXPECT_NEAR(orbit.bounces[0].t, 0.25 + from_wall, 1e-15);
}

// The same discs in the plane, without walls: the orbit there, taken back into the box.
TEST(PeriodicWalls, MakeTheOrbitOfThePlaneUnfolded) {
  const Torus torus({{{0.5, 0.5}, 0.25}});
  constexpr int kReach = 40;
  Surfaces plane;
  for (int y = -kReach; y <= kReach; ++y)
    for (int x = -kReach; x <= kReach; ++x) plane.add(Circle{{x + 0.5, y + 0.5}, 0.25});
  for (int i = 0; i < 20; ++i) {
    const Ray start{{0.1, 0.1 + 0.01 * i}, {1, 0.3}};
    const Orbit there = in_mirrors(plane, start, 4), here = torus.orbit(start, 4);
    ASSERT_EQ(there.bounces.size(), here.bounces.size());
    for (std::size_t k = 0; k < here.bounces.size(); ++k) {
      const Vec2 cell = plane.arcs[there.bounces[k].surface].curve.centre - Vec2(0.5, 0.5);
      EXPECT_LT((there.bounces[k].point - cell - here.bounces[k].point).norm(), 1e-9);
      EXPECT_NEAR(there.bounces[k].path_length, here.bounces[k].path_length, 1e-9);
    }
  }
}

TEST(PeriodicWalls, AreCrossedTwoAtATimeInACornerOfTheBox) {
  const Orbit orbit = Torus({{{0.375, 0.375}, 0.125}}).orbit({{0.625, 0.625}, {1, 1}}, 1);
  ASSERT_EQ(orbit.crossings.size(), 1U);
  EXPECT_EQ(orbit.crossings[0].from, Vec2(1, 1));
  EXPECT_EQ(orbit.crossings[0].to, Vec2(0, 0));
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_NEAR(orbit.bounces[0].point.x(), 0.375 - 0.125 * std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(orbit.bounces[0].point.y(), orbit.bounces[0].point.x(), 1e-15);
}

TEST(PeriodicWalls, LetARayThatComesBackGo) {
  const Orbit orbit = Torus({{{0.5, 0.5}, 0.25}}).orbit({{0.125, 0.5}, {0, 1}}, 1);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  ASSERT_EQ(orbit.crossings.size(), 2U);
  EXPECT_EQ(orbit.crossings.back().to, Vec2(0.125, 0));
}

TEST(PeriodicWalls, LetARayThatMeetsNothingGoAfterManyCrossings) {
  const Orbit orbit = Torus({}).orbit({{0.125, 0.5}, {1, 0.6180339887498949}}, 1);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  EXPECT_EQ(orbit.crossings.size(), std::size_t{1} << 18);
}

TEST(PeriodicWalls, StartedOnAreCrossedOrEnteredBy) {
  const Torus torus({{{0.5, 0.5}, 0.25}});
  const Orbit out = torus.orbit({{1, 0.5}, {1, 0}}, 1), in = torus.orbit({{0, 0.5}, {1, 0}}, 1);
  EXPECT_EQ(out.crossings.size(), 1U);
  EXPECT_EQ(in.crossings.size(), 0U);
  EXPECT_EQ(out.bounces.at(0).point, Vec2(0.25, 0.5));
  EXPECT_EQ(in.bounces.at(0).point, Vec2(0.25, 0.5));
}

// Discs in the corners, all copies of one, so that crossing walls end on it.
TEST(PeriodicWalls, StopWhereAMirrorMeetsThem) {
  const Torus torus({{{0, 0}, 0.25}, {{1, 0}, 0.25}, {{0, 1}, 0.25}, {{1, 1}, 0.25}});
  EXPECT_EQ(torus.orbit({{0.5, 0.5}, {0.5, -0.25}}, 1).end, OrbitEnd::corner);
  EXPECT_EQ(torus.orbit({{0.5, 0.5}, {0.5, 0.3125}}, 50).end, OrbitEnd::limit);
}

// Cells of the triangular lattice a, b, with a disc of radius 1 about each of its points.
constexpr double kSpacing = 2.2;
const Vec2 kA(kSpacing, 0), kB(1.1, 1.905255888325765);

Torus hexagon() {
  const double x = 0.5 * kSpacing, y = 0.6350852961085884;
  return Torus({{{0, 0}, 1}}, {{0, -2 * y}, {x, -y}, {x, y}, {0, 2 * y}, {-x, y}, {-x, -y}});
}
Torus rhombus() {
  const std::vector<Vec2> at = {-0.5 * kA - 0.5 * kB, 0.5 * kA - 0.5 * kB, 0.5 * kA + 0.5 * kB,
                                0.5 * kB - 0.5 * kA};
  return Torus({{at[0], 1}, {at[1], 1}, {at[2], 1}, {at[3], 1}}, at);
}

// `origin` is where a disc stands.
void expect_orbit_of_plane(const Torus& torus, const Vec2& origin) {
  constexpr int kReach = 20;
  Surfaces plane;
  for (int j = -kReach; j <= kReach; ++j)
    for (int i = -kReach; i <= kReach; ++i) plane.add(Circle{origin + i * kA + j * kB, 1});
  const PeriodicWalls walls(torus.walls, torus.materials);
  const Vec2 a = walls.lattice()[0], b = walls.lattice()[1];
  EXPECT_LT((a - kA).norm() + (b - kB).norm(), 1e-15);
  for (int k = 0; k < 40; ++k) {
    const double angle = 0.37 + 0.41 * k;
    const Ray start{origin + (kA + kB) / 3, {std::cos(angle), std::sin(angle)}};
    const Orbit there = in_mirrors(plane, start, 6);
    const Orbit here = torus.orbit(start, 6);
    ASSERT_EQ(here.bounces.size(), there.bounces.size()) << k;
    for (std::size_t i = 0; i < here.bounces.size(); ++i) {
      const CellIndex& cell = here.bounces[i].cell;
      const Vec2 unfolded =
          here.bounces[i].point + static_cast<double>(cell.a) * a + static_cast<double>(cell.b) * b;
      EXPECT_LT((unfolded - there.bounces[i].point).norm(), 1e-8);
    }
  }
}

TEST(PeriodicWalls, OfAHexagonMakeTheOrbitOfThePlaneByTheCellOfEachBounce) {
  expect_orbit_of_plane(hexagon(), {0, 0});
}
TEST(PeriodicWalls, CarryDiscsOverTheCornersOfAnObliqueCell) {
  expect_orbit_of_plane(rhombus(), -0.5 * kA - 0.5 * kB);
}

// Exact: no start of a flight lies in a disc, or outside the cell.
TEST(PeriodicWalls, LetNoOrbitIntoADiscOrOutOfTheCell) {
  for (const Torus& torus : {hexagon(), rhombus()}) {
    const auto expect_free = [&](const Vec2& point) {
      for (std::uint32_t i = 0; i < torus.walls.size(); ++i)
        torus.walls.visit(i, [&](const auto& wall) {
          EXPECT_NE(side_of(wall, point),
                    torus.materials[i] == Material::periodic ? Sign::negative : inside_of(wall));
        });
    };
    for (int k = 0; k < 5; ++k) {
      const Orbit orbit =
          torus.orbit({{0, torus.walls.size() == 8 ? 0.0 : 1.1}, {1, 0.3 * k}}, 400);
      EXPECT_EQ(orbit.end, OrbitEnd::limit);
      for (const Bounce& bounce : orbit.bounces) expect_free(bounce.point);
      for (const Crossing& crossing : orbit.crossings) {
        expect_free(crossing.from);
        expect_free(crossing.to);
      }
    }
  }
}

// A disc on the walls, seen from within: as in the disc alone, however often the walls are crossed.
TEST(PeriodicWalls, KeepAnOrbitInTheDiscItStartsIn) {
  const Torus torus({{{0, 0.5}, 0.25}, {{1, 0.5}, 0.25}});
  Surfaces disc;
  disc.add(Circle{{0, 0.5}, 0.25});
  for (int k = 0; k < 20; ++k) {
    const Ray start{{0.125, 0.5 + 0.003 * k}, {-1, 0.0625 * k}};
    const Orbit here = torus.orbit(start, 10), alone = in_mirrors(disc, start, 10);
    ASSERT_EQ(here.bounces.size(), 10U);
    EXPECT_GT(here.crossings.size(), 5U);
    for (std::size_t i = 0; i < 10; ++i) {
      const Vec2 place = here.bounces[i].point -
                         torus.walls.arcs[here.bounces[i].surface - 4].curve.centre + Vec2(0, 0.5);
      EXPECT_LT((place - alone.bounces[i].point).norm(), 1e-12);
    }
  }
}

// The corner (0, 2) belongs to three cells: what goes up to the left there is led through two of them.
TEST(PeriodicWalls, AreCrossedInACornerOfAHexagon) {
  const Torus torus({{{0, 0}, 1}}, {{0, -2}, {2, -1}, {2, 1}, {0, 2}, {-2, 1}, {-2, -1}});
  const Orbit right = torus.orbit({{-0.25, 1.25}, {1, 3}}, 1);
  const Orbit left = torus.orbit({{0.25, 1.25}, {-1, 3}}, 1);
  EXPECT_EQ(right.crossings.at(0).from, Vec2(0, 2));
  EXPECT_EQ(right.crossings.at(0).to, Vec2(-2, -1));
  EXPECT_EQ(right.crossings.at(0).step, (CellIndex{0, 1}));
  EXPECT_EQ(left.crossings.at(0).from, Vec2(0, 2));
  EXPECT_EQ(left.crossings.at(0).to, Vec2(2, -1));
  EXPECT_EQ(left.crossings.at(0).step, (CellIndex{-1, 1}));
  EXPECT_NE(left.bounces.at(0).cell, right.bounces.at(0).cell);
}

TEST(OrbitLines, EndAtBouncesAndCrossings) {
  const Orbit orbit = Torus({{{0.5, 0.5}, 0.125}}).orbit({{0.75, 0.25}, {1, 0.25}}, 1);
  const std::vector<OrbitLine> lines = orbit_lines(orbit);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_FALSE(lines[0].reflected);
  EXPECT_EQ(lines[0].line.b, Vec2(1, 0.3125));
  EXPECT_TRUE(lines[1].reflected);
  EXPECT_EQ(lines[1].line.a, Vec2(0, 0.3125));
  EXPECT_EQ(lines[1].line.b, orbit.bounces[0].point);
}

}  // namespace
}  // namespace flatray
