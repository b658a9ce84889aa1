// What holds for every orbit: nothing leaks, the speed stays, batches change nothing.
#include <gtest/gtest.h>

#include "base/philox.h"
#include "full_counts.h"
#include "geom/exact.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

double draw_of_law(std::uint64_t item, std::uint32_t which) {
  return unit_double(random_bits(7, Stream::test, 0, item, which));
}

bool inside_closed(const std::vector<Vec2>& convex, const Vec2& point) {
  for (std::size_t i = 0; i < convex.size(); ++i)
    if (orientation(convex[i], convex[(i + 1) % convex.size()], point) == Sign::negative)
      return false;
  return true;
}

std::vector<Vec2> placed(std::vector<Vec2> vertices, double scale, const Vec2& offset) {
  for (Vec2& vertex : vertices) vertex = scale * vertex + offset;
  return vertices;
}

// Rays from inside at every vertex, exactly and a few ulps beside it.
std::vector<Ray> rays_at_vertices(const std::vector<Vec2>& vertices, std::size_t count) {
  std::vector<Ray> rays;
  Vec2 middle(0, 0);
  for (const Vec2& vertex : vertices) middle += vertex / static_cast<double>(vertices.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& vertex = vertices[i % vertices.size()];
    const Vec2& other = vertices[(i / vertices.size()) % vertices.size()];
    const Vec2 origin = middle + 0.5 * draw_of_law(i, 0) * (other - middle);
    const double ulp = std::nextafter(vertex.norm(), kInfinity) - vertex.norm();
    const Vec2 beside(4 * ulp * (draw_of_law(i, 1) - 0.5), 4 * ulp * (draw_of_law(i, 2) - 0.5));
    rays.push_back({origin, vertex - origin + (i % 3 == 0 ? Vec2(0, 0) : beside)});
  }
  return rays;
}

void expect_no_leak(const std::vector<Vec2>& vertices, std::size_t count) {
  const Surfaces walls = ring(vertices);
  const std::vector<Ray> rays = rays_at_vertices(vertices, count);
  const std::vector<Orbit> orbits = trace_orbits(walls, all_mirrors(walls), rays, 50);
  std::size_t bounces = 0;
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    ASSERT_TRUE(orbits[i].end == OrbitEnd::limit || orbits[i].end == OrbitEnd::corner)
        << name(orbits[i].end) << " of ray " << i;
    for (const Bounce& bounce : orbits[i].bounces)
      ASSERT_TRUE(inside_closed(vertices, bounce.point)) << "ray " << i;
    bounces += orbits[i].bounces.size();
  }
  EXPECT_GT(bounces, 25 * count);
}

const std::vector<Vec2> kLawPentagon = {
    {1, 0}, {0.31, 0.95}, {-0.81, 0.59}, {-0.81, -0.59}, {0.31, -0.95}};
const std::vector<Vec2> kNeedle = {{0, 0}, {3, 0.001}, {0.7, 0.01}};

struct Placing {
  double scale;
  Vec2 offset;
};
class LeaksAt : public testing::TestWithParam<Placing> {};

TEST_P(LeaksAt, NoneInAPentagon) {
  expect_no_leak(placed(kLawPentagon, GetParam().scale, GetParam().offset), 2'500);
}
TEST_P(LeaksAt, NoneInANeedle) {
  expect_no_leak(placed(kNeedle, GetParam().scale, GetParam().offset), 500);
}
INSTANTIATE_TEST_SUITE_P(EveryScale, LeaksAt,
                         testing::Values(Placing{1, {0, 0}}, Placing{1, {1e6, -1e6}},
                                         Placing{1e-5, {0, 0}}, Placing{1e15, {0, 0}}));

// Rays that pass a corner at half an ulp and less: near (1.5, 1.25) doubles lie 2^-52 apart, and
// the rays reach it, after one length of their direction, a whole number of 2^-53 beside it.
TEST(Leaks, NoneAtFractionsOfAnUlpFromACorner) {
  const Vec2 corner(1.5, 1.25);
  for (const Vec2& next : {Vec2{0.25, 1.5}, Vec2{0.75, 0.875}, Vec2{-1, 1.0625}, Vec2{1.25, 1.5}}) {
    const std::vector<Vec2> vertices = {corner, next, {-2, -1}, {0.5, -1.5}};
    const Surfaces walls = ring(vertices);
    std::vector<Ray> rays;
    for (const Vec2& way : {Vec2{0.75, 0.875}, Vec2{0.5, 0.625}, Vec2{0.5, 0.5}, Vec2{0.625, 0.75}})
      for (int i = -7; i <= 7; ++i)
        for (int j = -7; j <= 7; ++j)
          if (inside_closed(vertices, corner - way))
            rays.push_back({corner - way, way + 0x1p-53 * Vec2(i, j)});
    ASSERT_FALSE(rays.empty());
    const std::vector<Orbit> orbits = trace_orbits(walls, all_mirrors(walls), rays, 20);
    int corners = 0, aimed = 0;
    for (std::size_t i = 0; i < orbits.size(); ++i) {
      corners += orbits[i].end == OrbitEnd::corner ? 1 : 0;
      aimed += side_of_ray(rays[i], corner) == Sign::zero ? 1 : 0;
      ASSERT_NE(orbits[i].end, OrbitEnd::escape) << "ray " << i;
      for (const Bounce& bounce : orbits[i].bounces)
        ASSERT_TRUE(inside_closed(vertices, bounce.point)) << "ray " << i;
    }
    EXPECT_EQ(corners, aimed);  // no other ray was rounded into the corner
  }
}

TEST(CircleOrbit, ReflectsFromOutside) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 5});
  const Orbit orbit = in_mirrors(walls, {{-10, 3}, {1, 0}}, 10);  // meets (-4, 3)
  ASSERT_EQ(orbit.bounces.size(), 1U);
  EXPECT_EQ(orbit.end, OrbitEnd::escape);
  EXPECT_EQ(orbit.bounces[0].point, Vec2(-4, 3));
  EXPECT_NEAR(orbit.bounces[0].normal.x(), -0.8, 0x1p-53);
  EXPECT_NEAR(orbit.bounces[0].normal.y(), 0.6, 0x1p-53);
  EXPECT_NEAR(orbit.out.x(), -0.28, 0x1p-52);  // d - 2 (d.n) n
  EXPECT_NEAR(orbit.out.y(), 0.96, 0x1p-52);
}

// A circle touching the wall of its box: no ray finds a way through the point they share.
TEST(StiffCases, C26NoLeakBetweenCircleAndWall) {
  Surfaces walls = ring({{-2, -1}, {2, -1}, {2, 3}, {-2, 3}});
  walls.add(Circle{{0, 0}, 1});
  const std::vector<Material> mirrors = all_mirrors(walls);
  const auto expect_none = [&](const std::vector<Ray>& rays) {
    for (const Orbit& orbit : trace_orbits(walls, mirrors, rays, 100)) {
      ASSERT_NE(orbit.end, OrbitEnd::escape);
      for (const Bounce& bounce : orbit.bounces) {
        ASSERT_NE(side_of(walls.arcs[0], bounce.point), Sign::negative);
        ASSERT_GE(bounce.point.y(), -1);
      }
    }
  };
  expect_none({{{0, 2.5}, {0, -1}}, {{-1.5, -1 + 0x1p-30}, {1, 0x1p-40}}});
  constexpr std::uint64_t kTogether = 400;
  for (std::uint64_t first = 0; first < times(1'000'000, kTogether); first += kTogether) {
    std::vector<Ray> rays;
    for (std::uint64_t i = first; i < first + kTogether; ++i)
      rays.push_back({{-1.5 + 0.25 * draw_of_law(i, 3), -1 + 0.25 * draw_of_law(i, 4)},
                      Vec2(0, -1) - Vec2(-1.5, -0.9 + 0.01 * draw_of_law(i, 5))});
    expect_none(rays);
  }
}

TEST(Orbits, KeepTheirSpeed) {
  const Surfaces walls = ring(kLawPentagon);
  for (const double length : {1.0, 1e200, 1e-200}) {
    const Vec2 direction = length * Vec2(0.6, 0.35);
    const Orbit orbit = in_mirrors(walls, {{0.1, 0.2}, direction}, 20'000);
    ASSERT_EQ(orbit.bounces.size(), 20'000U);
    Vec2 from = orbit.start;
    for (const Bounce& bounce : orbit.bounces) {
      // t counts lengths of the direction: distance over t is the speed, but for the points'
      // rounding.
      const double distance = (bounce.point - from).norm();
      const double speed = distance / (bounce.t * length) / Vec2(0.6, 0.35).norm();
      ASSERT_NEAR(speed, 1, 0x1p-50 + 0x1p-51 / distance);
      from = bounce.point;
    }
  }
}

TEST(Orbits, OfABatchAreThoseOfSingleRays) {
  const Surfaces walls = ring(kLawPentagon);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < 40; ++i)
    rays.push_back({{0.1, 0.2}, {draw_of_law(i, 6) - 0.5, draw_of_law(i, 7)}});
  rays.push_back({{0.1, 0.2}, kLawPentagon[1] - Vec2(0.1, 0.2)});
  rays.push_back({{5, 0}, {1, 0}});
  const std::vector<Orbit> together = trace_orbits(walls, all_mirrors(walls), rays, 30);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Orbit alone = in_mirrors(walls, rays[i], 30);
    EXPECT_EQ(together[i].end, alone.end);
    EXPECT_EQ(together[i].out, alone.out);
    ASSERT_EQ(together[i].bounces.size(), alone.bounces.size());
    for (std::size_t k = 0; k < alone.bounces.size(); ++k) {
      EXPECT_EQ(together[i].bounces[k].point, alone.bounces[k].point);
      EXPECT_EQ(together[i].bounces[k].path_length, alone.bounces[k].path_length);
    }
  }
}

}  // namespace
}  // namespace flatray
