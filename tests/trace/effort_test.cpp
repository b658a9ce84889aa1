// How little is looked at, where the answer is the same whatever is.
#include <gtest/gtest.h>

#include <cmath>

#include "trace/random_rays.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

// Short walls and rays among them, in a square of a size.
Surfaces short_walls(int count, double size) {
  Draws draws(1);
  Surfaces walls;
  for (int i = 0; i < count; ++i) {
    const Vec2 a = size * draws.point();
    const Vec2 along = size * 0.05 * draws.point();
    walls.add(Segment{a, a + along});
  }
  return walls;
}
RayBatch rays_within(double size) {
  Draws draws(2);
  RayBatch rays;
  for (int i = 0; i < 4096; ++i) {
    const Vec2 from = size * draws.point();
    rays.add({from, draws.point() - Vec2(0.5, 0.5)});
  }
  return rays;
}
double walls_tested(const Accelerator& walls, const RayBatch& rays) {
  constexpr int kAsked = 256;
  std::size_t tested = 0;
  for (std::size_t i = 0; i < kAsked; ++i) tested += walls.tested_of_one(rays.ray(i));
  return static_cast<double>(tested) / kAsked;
}

TEST(Effort, LanesLeaveNoMoreThanOneRayInAHundredAmongWallsInGeneralPosition) {
  const Surfaces walls = short_walls(200, 1);
  for (const char* name : {"brute", "grid"})
    EXPECT_LE(find_tracer(name)->build(walls)->left_by_lanes(rays_within(1)), 40U) << name;
}

// Circles and parts of them, few in one list and many in cells.
TEST(Effort, LanesLeaveNoMoreThanOneRayInAHundredAmongCurvesInGeneralPosition) {
  for (const int count : {10, 300}) {
    Draws draws(3);
    Surfaces walls;
    for (int i = 0; i < count; ++i) {
      const Vec2 at = draws.point(), u = 0.03 * (draws.point() + Vec2(0.1, 0.1));
      const Circle circle{at, u.norm()};
      if (i % 2 == 0)
        walls.add(circle);
      else
        walls.add(Arc{circle, Arc::Extent::between, at + u, at + Vec2(-u.y(), u.x())});
    }
    const auto ready = find_tracer("grid")->build(walls);
    EXPECT_LE(ready->left_by_lanes(rays_within(1)), 40U) << count;
    EXPECT_EQ(ready->cells() > 0, count > 32);
  }
}

TEST(Effort, CountsTheWallThatIsMet) {
  const Surfaces walls = short_walls(200, 1);
  const RayBatch rays = rays_within(1);
  for (const char* name : {"brute", "grid"}) {
    const auto ready = find_tracer(name)->build(walls);
    std::size_t met = 0;
    for (std::size_t i = 0; i < 256; ++i) {
      if (!ready->nearest_of_one(rays.ray(i))) continue;
      ASSERT_GE(ready->tested_of_one(rays.ray(i)), 1U) << name << ' ' << i;
      ++met;
    }
    EXPECT_GE(met, 64U);
  }
}

// Two walls far off make one cell of all others.
TEST(Effort, ACrowdedCellIsDividedSoThatFewOfItsWallsAreTested) {
  Surfaces walls = short_walls(2000, 0.002);
  walls.add(Segment{{-1, -1}, {-1, 1}});
  walls.add(Segment{{2, -1}, {2, 1}});
  const auto grid = find_tracer("grid")->build(walls);
  EXPECT_LE(walls_tested(*grid, rays_within(0.002)), 200);
  EXPECT_LE(grid->bytes(), 200U * walls.size());
}

// Of a list of curves few are looked at: those whose discs a ray meets.
TEST(Effort, CurvesBesideARayAreNotTested) {
  Draws draws(4);
  Surfaces walls;
  for (int i = 0; i < 24; ++i) walls.add(Circle{draws.point(), 0.02});
  for (int i = 0; i < 4; ++i) {
    const Vec2 at = draws.point();
    const Vec2 end = at + 0.5 * Vec2(std::cos(0.04), std::sin(0.04));
    walls.add(Arc{Circle{at, 0.5}, Arc::Extent::between, at + Vec2(0.5, 0), end});
  }
  EXPECT_LE(walls_tested(*find_tracer("brute")->build(walls), rays_within(1)), 2);
}

TEST(Effort, CurvesHaveACellEachAndNotManyMore) {
  Draws draws(3);
  Surfaces walls;
  for (int i = 0; i < 400; ++i) walls.add(Circle{10 * draws.point(), 0.05});
  const std::size_t cells = find_tracer("grid")->build(walls)->cells();
  EXPECT_GE(cells, 400U);
  EXPECT_LE(cells, 4000U);
}

}  // namespace
}  // namespace flatray
