// Stiff cases of long orbits: closed ones, circles, conserved quantities.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "full_counts.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

constexpr double kPi = std::numbers::pi;

Surfaces unit_circle() {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  return walls;
}

std::vector<Vec2> regular(int sides) {
  std::vector<Vec2> vertices;
  for (int i = 0; i < sides; ++i)
    vertices.emplace_back(std::cos(2 * kPi * i / sides), std::sin(2 * kPi * i / sides));
  return vertices;
}

TEST(StiffCases, C10Fagnano) {
  const Surfaces walls = ring({{0, 0}, {20, 0}, {10, 20}});
  const Vec2 feet[] = {{16, 8}, {4, 8}, {10, 0}};
  std::size_t hit = 0;
  double rounds = 0;
  watch(walls, {{13, 4}, {3, 4}}, 1'000'000, [&](const Bounce& bounce) {
    const Vec2& foot = feet[hit++ % 3];
    ASSERT_NEAR(bounce.point.x(), foot.x(), 1e-9) << hit;
    ASSERT_NEAR(bounce.point.y(), foot.y(), 1e-9) << hit;
    if (hit % 3 == 0) rounds = bounce.path_length / (static_cast<double>(hit) / 3);
  });
  EXPECT_EQ(hit, 1'000'000U);
  EXPECT_NEAR(rounds, 32, 1e-4);  // the first flight is half a side short of its foot
}

TEST(StiffCases, C11Fagnano131415) {
  const Surfaces walls = ring({{0, 0}, {14, 0}, {5, 12}});
  const Vec2 first(5, 0), second(8.96, 6.72);  // feet of the heights
  const Orbit orbit = in_mirrors(walls, {0.5 * first + 0.5 * second, second - first}, 301);
  ASSERT_EQ(orbit.bounces.size(), 301U);
  const double round = 1344.0 / 65;
  const double travelled = orbit.bounces[300].path_length - orbit.bounces[0].path_length;
  EXPECT_NEAR(travelled, 100 * round, 300 * 0x1p-52 * 100 * round);
  EXPECT_NEAR((orbit.bounces[300].point - second).norm(), 0, 300 * 0x1p-52 * 100);
}

TEST(StiffCases, C12CircleCaustic) {
  const Surfaces walls = unit_circle();
  const double caustic = 0.5590169943749474241, turn = 1.9551931012905357;
  const std::uint64_t hits = times(1'000'000, 100'000);
  const double tolerance = static_cast<double>(hits) * 0x1p-50;
  Vec2 last(0, 0);
  std::uint64_t hit = 0;
  watch(walls, {{0.5, 0.25}, {-1, 2}}, hits, [&](const Bounce& bounce) {
    ASSERT_NE(side_of(walls.arcs[0], bounce.point), Sign::positive) << hit;
    ASSERT_NEAR(std::fabs(cross(bounce.point, bounce.out.normalized())), caustic, tolerance);
    if (hit++ > 0) {
      const double angle = std::atan2(cross(last, bounce.point), last.dot(bounce.point));
      ASSERT_NEAR(std::fabs(angle), turn, tolerance) << hit;
    }
    last = bounce.point;
  });
  EXPECT_EQ(hit, hits);
}

TEST(StiffCases, C13CirclePhase) {
  std::uint64_t hit = 0;
  const auto expect = [&](const Bounce& bounce, double x, double y) {
    const double tolerance = static_cast<double>(hit) * 0x1p-50;  // the caustic is held
    EXPECT_NEAR(bounce.point.x(), x, tolerance) << hit;
    EXPECT_NEAR(bounce.point.y(), y, tolerance) << hit;
  };
  watch(unit_circle(), {{0.5, 0.25}, {-1, 2}}, 1'000'000, [&](const Bounce& bounce) {
    ++hit;
    if (hit == 1) expect(bounce, 0.12919007564521686, 0.99161984870956629);
    if (hit == 1'000) expect(bounce, 0.82049392555121482, 0.57165524412320188);
    if (hit == 1'000'000) expect(bounce, -0.91782436414529312, -0.39698669572328034);
  });
}

TEST(StiffCases, C14WhisperingGallery) {
  const Surfaces walls = unit_circle();
  const double caustic = 1 - 0x1p-20;
  Vec2 last(0, 0);
  std::uint64_t hit = 0;
  double off = 0, chord_off = 0;
  watch(walls, {{0, caustic}, {1, 0}}, 1'000'000, [&](const Bounce& bounce) {
    ASSERT_NE(side_of(walls.arcs[0], bounce.point), Sign::positive) << hit;
    off = std::max(
        off, std::fabs(std::fabs(cross(bounce.point, bounce.out)) / bounce.out.norm() - caustic));
    if (hit++ > 0)
      chord_off = std::max(chord_off, std::fabs((bounce.point - last).norm() - 0.0027621352));
    last = bounce.point;
  });
  EXPECT_EQ(hit, 1'000'000U);
  EXPECT_LE(off, 1e-12);
  EXPECT_LE(chord_off, 1e-9);
}

TEST(StiffCases, C15PolygonGallery) {
  const std::vector<Vec2> vertices = regular(1000);
  const Surfaces walls = ring(vertices);
  std::uint64_t hit = 0;
  std::uint32_t last = 0;
  const OrbitStop stop =
      watch(walls, {{0.99, 0}, {0.1, 1}}, times(1'000'000, 100'000), [&](const Bounce& bounce) {
        const Vec2 &a = vertices[bounce.surface], &b = vertices[(bounce.surface + 1) % 1000];
        ASSERT_NE(orientation(a, b, bounce.point), Sign::negative);
        if (hit++ > 0) {
          const std::uint32_t on = (bounce.surface + 1000 - last) % 1000;
          ASSERT_TRUE(0 < on && on < 500) << hit;
        }
        last = bounce.surface;
      });
  EXPECT_EQ(stop.end, OrbitEnd::limit);
}

TEST(StiffCases, C16CircleKeepsTheSpeed) {
  watch(unit_circle(), {{1, 0}, {std::cos(2.0), std::sin(2.0)}}, times(10'000'000, 100'000),
        [&](const Bounce& bounce) { ASSERT_NEAR(bounce.out.norm(), 1, 4 * 0x1p-53); });
}

// How many directions an orbit has, those closer than `apart` taken as one.
std::size_t directions(const Surfaces& walls, const Ray& start, std::uint64_t hits, double apart) {
  std::vector<double> angles;
  watch(walls, start, hits, [&](const Bounce& bounce) {
    const double angle = std::atan2(bounce.out.y(), bounce.out.x());
    angles.push_back(angle < 0 ? angle + 2 * kPi : angle);
  });
  EXPECT_EQ(angles.size(), hits);
  std::sort(angles.begin(), angles.end());
  std::size_t clusters = 1;
  for (std::size_t i = 1; i < angles.size(); ++i)
    clusters += angles[i] - angles[i - 1] > apart ? 1 : 0;
  return clusters;
}

TEST(StiffCases, C18Directions) {
  constexpr std::uint64_t kHits = 100'000;
  const double apart = static_cast<double>(kHits) * 0x1p-52;
  const double h = std::sqrt(3.0);
  const auto count = [&](const std::vector<Vec2>& vertices) {
    Vec2 middle(0, 0);
    for (const Vec2& vertex : vertices) middle += vertex / static_cast<double>(vertices.size());
    return directions(ring(vertices), {middle, {0.71, 0.37}}, kHits, apart);
  };
  EXPECT_LE(count({{0, 0}, {3, 0}, {3, 2}, {0, 2}}), 4U);
  EXPECT_LE(count(regular(3)), 6U);
  EXPECT_LE(count({{0, 0}, {1, 0}, {0, 1}}), 8U);
  EXPECT_LE(count({{0, 0}, {h, 0}, {0, 1}}), 12U);
  EXPECT_LE(count(regular(6)), 6U);
  EXPECT_LE(count(regular(5)), 10U);
}

// From hit k back along the way it came by: the same walls in turn, and the start again.
void expect_reversible(const Surfaces& walls, const Ray& start, std::size_t hits, double loss) {
  const Orbit there = in_mirrors(walls, start, hits);
  ASSERT_EQ(there.bounces.size(), hits);
  const Ray back{there.bounces[hits - 1].point, -there.bounces[hits - 2].out};
  const Orbit again = in_mirrors(walls, back, hits - 1);
  ASSERT_EQ(again.bounces.size(), hits - 1);
  const double allowed = 8 * 0x1p-52 * static_cast<double>(hits) * std::pow(10, loss);
  for (std::size_t i = 0; i + 1 < hits; ++i) {
    ASSERT_EQ(again.bounces[i].surface, there.bounces[hits - 2 - i].surface) << i;
    EXPECT_NEAR((again.bounces[i].point - there.bounces[hits - 2 - i].point).norm(), 0, allowed);
  }
}

TEST(StiffCases, C23Reversal) {
  const double log_hits = std::log10(50.0);
  const Ray start{{0.1, 0.2}, {0.31, 0.77}};
  expect_reversible(ring({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}), start, 50, log_hits);
  expect_reversible(ring(regular(5)), start, 50, log_hits);
  expect_reversible(unit_circle(), start, 50, 2 * log_hits);
  Surfaces sinai = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  sinai.add(Circle{{0.5, 0.5}, 0.25});
  expect_reversible(sinai, start, 20, 20 * 0.78 / std::log(10.0) + 2);
}

// The distance of a point from the line of a wall, in ulps of its largest coordinate.
double ulps_off(const Segment& wall, const Vec2& point) {
  const Vec2 edge = wall.b - wall.a;
  const double distance = std::fabs(cross(edge, Vec2(point - wall.a))) / edge.norm();
  return distance / (point.cwiseAbs().maxCoeff() * 0x1p-52);
}

TEST(StiffCases, C24Conservation) {
  const std::uint64_t all = times(10'000'000, 1'000'000);
  const std::vector<Vec2> vertices = {{0, 0}, {5, -1}, {7, 3}, {3, 6}, {-1, 4}};
  const Surfaces walls = ring(vertices);
  const Vec2 direction(0.6, 0.35);
  Vec2 last(1, 1);
  double flights = 0;
  std::uint64_t hits = 0;
  const OrbitStop stop = watch(walls, {last, direction}, all, [&](const Bounce& bounce) {
    ++hits;
    flights += (bounce.point - last).norm();
    last = bounce.point;
    ASSERT_NEAR(bounce.out.norm() / direction.norm(), 1, 4 * 0x1p-53);
    ASSERT_NEAR(bounce.path_length, flights,
                static_cast<double>(hits) * 0x1p-53 * 16 + flights * 0x1p-40);
    const Segment& wall = walls.segments[bounce.surface];
    ASSERT_LE(ulps_off(wall, bounce.point), 4) << hits;
    ASSERT_NE(orientation(wall.a, wall.b, bounce.point), Sign::negative) << hits;
  });
  EXPECT_EQ(stop.end, OrbitEnd::limit);
  EXPECT_EQ(hits, all);
}

TEST(StiffCases, C25NestedTangentCircles) {
  Surfaces walls = unit_circle();
  walls.add(Circle{{0.5, 0}, 0.5});
  const std::vector<Material> mirrors = all_mirrors(walls);
  std::vector<Ray> rays;
  for (int k = 0; k < 1000; ++k)
    rays.push_back({{0, -0.75}, {std::cos(2 * kPi * k / 1000), std::sin(2 * kPi * k / 1000)}});
  std::size_t corners = 0;
  for (const Orbit& orbit : trace_orbits(walls, mirrors, rays, 200)) {
    ASSERT_NE(orbit.end, OrbitEnd::escape);
    corners += orbit.end == OrbitEnd::corner ? 1 : 0;
    for (const Bounce& bounce : orbit.bounces) {
      ASSERT_NE(side_of(walls.arcs[0], bounce.point), Sign::positive);
      ASSERT_NE(side_of(walls.arcs[1], bounce.point), Sign::negative);
    }
  }
  EXPECT_LE(corners, 1U);
}

}  // namespace
}  // namespace flatray
