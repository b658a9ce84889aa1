// Every tier's kernel against the exact code for every wall, bit for bit.
#include "trace/kernels/tiers.h"

#include <gtest/gtest.h>

#include <limits>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

void add_rays_between(Draws& draw, const std::vector<Vec2>& from, const std::vector<Vec2>& to,
                      int count, Case& c) {
  const auto any = [&](const std::vector<Vec2>& of) { return of[draw.bits() % of.size()]; };
  for (int i = 0; i < count; ++i) {
    const Vec2 origin = any(from);
    const DepartedSurface departed{
        i % 3 == 0 ? static_cast<std::uint32_t>(draw.bits() % c.walls.size()) : kNoSurface,
        Root::none};
    c.rays.add({origin, any(to) - origin}, departed);
  }
}

TEST(Tiers, AgreeOnRandomRays) {
  Draws draw(1);
  Case c;
  std::vector<Vec2> points;
  for (int i = 0; i < 40; ++i) points.push_back(draw.point());
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    c.walls.add(Segment{points[i], points[i] + 0.2 * (points[i + 1] - points[i])});
  for (int i = 0; i < 403; ++i) c.rays.add({draw.point(), draw.point() - Vec2(0.5, 0.5)});
  expect_all_tiers_exact(c);
}

// Rays from vertex to vertex: through ends, along walls, at crossings, from walls.
TEST(Tiers, AgreeOnRaysAimedAtVertices) {
  for (const double scale : {1.0, 0.1, 0x1p-1070, 0x1p-530, 0x1p505, 0x1p1010}) {
    Draws draw(2);
    Case c;
    std::vector<Vec2> points;
    for (int i = 0; i < 16; ++i) points.push_back(scale * draw.grid_point(-4, 4));
    for (std::size_t i = 0; i < points.size(); ++i)
      c.walls.add(Segment{points[i], points[draw.bits() % points.size()]});
    add_rays_between(draw, points, points, 100, c);
    expect_all_tiers_exact(c);
  }
}

// A step of one ulp to either side of a vertex decides between two walls or a miss.
TEST(Tiers, AgreeOneUlpBesideVertices) {
  Draws draw(3);
  Case c;
  std::vector<Vec2> points, beside;
  for (int i = 0; i < 12; ++i) points.push_back(draw.point());
  for (std::size_t i = 0; i < points.size(); ++i)
    c.walls.add(Segment{points[i], points[(i + 1) % points.size()]});
  for (const Vec2& p : points)
    for (const double towards : {-kInfinity, kInfinity})
      beside.emplace_back(std::nextafter(p.x(), towards), p.y());
  std::vector<Vec2> origins;
  for (int i = 0; i < 40; ++i) origins.push_back(draw.point());
  add_rays_between(draw, origins, beside, 300, c);
  expect_all_tiers_exact(c);
}

// A wall that ends on the ray, as far as doubles can say: its side is rounding alone. From an
// origin with more low bits than the wall, plain doubles get one side in twenty wrong.
TEST(Tiers, AgreeOnEndsRoundedOntoTheRay) {
  Draws draw(7);
  for (int i = 0; i < 1'000; ++i) {
    Case c;
    c.rays.add({0.01 * draw.point(), draw.point() - Vec2(0.5, 0.5)});
    const Ray ray = c.rays.ray(0);
    c.walls.add(Segment{ray.origin + (1 + draw.unit()) * ray.direction, draw.point()});
    expect_all_tiers_exact(c);
  }
}

// Coordinates of all sizes at once: products over- and underflow in the lanes.
TEST(Tiers, AgreeOnCoordinatesOfAllSizes) {
  Draws draw(4);
  for (const int most : {30, 300, 1020}) {
    Case c;
    const auto point = [&] {
      const double x = draw.spread(-most, most);
      return Vec2(x, draw.spread(-most, most));
    };
    for (int i = 0; i < 24; ++i) c.walls.add(Segment{point(), point()});
    for (int i = 0; i < 120; ++i) c.rays.add({point(), point()});
    expect_all_tiers_exact(c);
  }
}

TEST(Tiers, AgreeOnSegmentsAndCirclesTogether) {
  Draws draw(5);
  Case c;
  for (int i = 0; i < 6; ++i) {
    c.walls.add(Circle{draw.grid_point(-3, 3), static_cast<double>(draw.whole(0, 2))});
    c.walls.add(Segment{draw.grid_point(-4, 4), draw.grid_point(-4, 4)});
  }
  for (int i = 0; i < 200; ++i) c.rays.add({draw.grid_point(-5, 5), draw.grid_point(-2, 2)});
  expect_all_tiers_exact(c);
}

}  // namespace
}  // namespace flatray
