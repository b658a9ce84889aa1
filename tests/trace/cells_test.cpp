// Every tracer against the exact code for every wall, bit for bit, on scenes large enough that
// rays walk through many cells.
#include "trace/cells.h"

#include <gtest/gtest.h>

#include <set>

#include "full_counts.h"
#include "trace/cells_hashes.h"
#include "trace/crowd.h"
#include "trace/kernels/tiers.h"

namespace flatray {
namespace {

void transform(Case& c, double scale, const Vec2& offset) {
  const auto move = [&](Vec2& p) { p = scale * p + offset; };
  for (Segment& s : c.walls.segments) {
    move(s.a);
    move(s.b);
  }
  for (std::size_t i = 0; i < c.rays.size(); ++i) {
    Ray ray = c.rays.ray(i);
    move(ray.origin);
    ray.direction *= scale;
    c.rays.set(i, ray, c.rays.departed[i]);
  }
}

Case random_case(std::uint64_t seed, int shapes, double size, int rays) {
  Draws draw(seed);
  Case c;
  c.walls = crowd(draw, shapes, size);
  for (int i = 0; i < rays; ++i) {
    const DepartedSurface departed{
        i % 4 == 0 ? static_cast<std::uint32_t>(draw.bits() % c.walls.size()) : kNoSurface,
        Root::none};
    const Vec2 origin = draw.point();
    c.rays.add({origin, draw.point() - Vec2(0.5, 0.5)}, departed);
  }
  return c;
}

TEST(Tracers, AgreesOnRandomRays) {
  for (const double size : {0.01, 0.1, 1.0})
    expect_all_tiers_exact(random_case(1, 100, size, 1'500));
}

// From vertex to vertex, through others and past them.
TEST(Tracers, AgreesOnRaysFromVertexToVertex) {
  Draws draw(2);
  Case c;
  c.walls = crowd(draw, 80, 0.1);
  for (int i = 0; i < 600; ++i) {
    const Vec2 from = i % 2 == 0 ? any_end(draw, c.walls) : draw.point();
    c.rays.add({from, any_end(draw, c.walls) - from});
  }
  expect_all_tiers_exact(c);
}

// The wall left is where the ray starts, as after a bounce.
TEST(Tracers, AgreesOnRaysThatLeaveWalls) {
  Draws draw(3);
  Case c;
  c.walls = crowd(draw, 100, 0.1);
  for (int i = 0; i < 1'000; ++i) {
    const auto from = static_cast<std::uint32_t>(draw.bits() % c.walls.size());
    const Segment& s = c.walls.segments[from];
    c.rays.add({s.a + draw.unit() * (s.b - s.a), draw.point() - Vec2(0.5, 0.5)},
               {from, Root::none});
  }
  expect_all_tiers_exact(c);
}

TEST(Tracers, AgreesOnRaysFromOutside) {
  Draws draw(5);
  for (const double away : {2.0, 100.0, 1e5, 1e12, 1e200}) {
    Case c;
    c.walls = crowd(draw, 30, 0.1);
    for (std::uint64_t i = 0; i < times(200); ++i) {
      const Vec2 from = away * (draw.point() - Vec2(0.5, 0.5));
      const Vec2 to = i % 2 == 0 ? draw.point() : any_end(draw, c.walls);
      c.rays.add({from, to - from});
      c.rays.add({from, draw.point() - Vec2(0.5, 0.5)});
    }
    expect_all_tiers_exact(c);
  }
}

TEST(Tracers, AgreesAtAnyScaleAndOffset) {
  for (const double scale : {0x1p-1040, 1e-300, 1e-30, 1e15, 1e280, 0x1p1000}) {
    Case c = random_case(6, 20, 0.2, 150);
    transform(c, scale, {0, 0});
    expect_all_tiers_exact(c);
  }
  for (const Vec2& offset : {Vec2(1e6, -3), Vec2(0x1p52, 0), Vec2(1e10, 1e10)}) {
    Case c = random_case(7, 20, 0.2, 150);
    transform(c, 1, offset);
    expect_all_tiers_exact(c);
  }
}

// Details far below what a float can tell apart.
TEST(Tracers, AgreesOnClustersFinerThanFloat) {
  Draws draw(8);
  for (const double size : {1e-4, 1e-7, 1e-12}) {
    Case c;
    c.walls = crowd(draw, 4, 0.3);
    const Vec2 at = draw.point();
    for (int i = 0; i < 60; ++i)
      c.walls.add(Segment{at + size * draw.point(), at + size * draw.point()});
    for (int i = 0; i < 300; ++i) {
      const Vec2 from = i % 2 == 0 ? draw.point() : Vec2(at + size * draw.point());
      const Vec2 to = at + size * draw.point();
      c.rays.add({from, to - from});
    }
    expect_all_tiers_exact(c);
  }
}

TEST(Tracers, AgreesOnThinScenes) {
  Draws draw(9);
  for (const double height : {0.0, 1e-300, 1e-9, 1e-3}) {
    Case c;
    for (int i = 0; i < 40; ++i) {
      const double x = draw.unit(), y = height * draw.unit();
      c.walls.add(Segment{{x, y}, {x + 0.05 * draw.unit(), height * draw.unit()}});
      c.walls.add(Segment{{x, 0}, {x, height}});
    }
    for (int i = 0; i < 200; ++i) {
      const Vec2 from(draw.unit(), (i % 2 == 0 ? height : 1) * (draw.unit() - 0.5));
      c.rays.add({from, any_end(draw, c.walls) - from});
      c.rays.add({from, {draw.unit() - 0.5, height * (draw.unit() - 0.5)}});
      c.rays.add({from, {1, 0}});
    }
    expect_all_tiers_exact(c);
  }
}

// Long walls across everything: each is in many cells, and crosses all others.
TEST(Tracers, AgreesOnLongWalls) {
  Draws draw(10);
  Case c;
  for (int i = 0; i < 60; ++i) c.walls.add(Segment{draw.point(), draw.point()});
  for (int i = 0; i < 60; ++i) {  // nearly parallel, in one bundle
    const Vec2 a(0, 0.5 + 1e-9 * draw.unit()), b(1, 0.5 + 1e-9 * draw.unit());
    c.walls.add(Segment{a, b});
  }
  for (int i = 0; i < 400; ++i) {
    const Vec2 from = draw.point();
    c.rays.add({from, i % 2 == 0 ? Vec2(1, 1e-9 * (draw.unit() - 0.5)) : draw.point()});
  }
  expect_all_tiers_exact(c);
}

TEST(Tracers, AgreesOnManyCoincidentWalls) {
  Draws draw(11);
  Case c;
  for (int i = 0; i < 50; ++i) c.walls.add(Segment{{0, 0}, {1, 0}});
  for (int i = 0; i < 50; ++i) c.walls.add(Segment{{1, 0}, {0, 0}});
  c.walls.add(Segment{{0, 1}, {1, 1}});
  for (int i = 0; i < 100; ++i) {
    const auto from = static_cast<std::uint32_t>(draw.bits() % c.walls.size());
    c.rays.add({{draw.unit(), 0}, draw.point() - Vec2(0.5, 0.5)}, {from, Root::none});
    c.rays.add({draw.point(), draw.point() - Vec2(0.5, 0.5)});
  }
  expect_all_tiers_exact(c);
}

TEST(Tracers, TakesBatchesOfAnySize) {
  const Case all = random_case(12, 60, 0.1, 40);
  for (std::size_t count = 0; count <= all.rays.size(); ++count) {
    Case c = all;
    c.rays.resize(count);
    expect_all_tiers_exact(c);
  }
}

// Shapes ever smaller and closer towards a corner and a wall, of which many share a cell: these are
// divided, and shapes too small for their parts go one by one.
TEST(Tracers, AgreeWhereWallsCrowd) {
  for (const double power : {2.0, 4.0, 8.0}) {
    Case c = random_case(static_cast<std::uint64_t>(power), 500, 0.05, 300);
    const auto squeeze = [&](Vec2& p) { p = {std::pow(p.x(), power), std::pow(p.y(), 2)}; };
    for (Segment& s : c.walls.segments) {
      squeeze(s.a);
      squeeze(s.b);
    }
    Draws draw(15);
    for (int i = 0; i < 300; ++i) {
      const Vec2 from = any_end(draw, c.walls), to = any_end(draw, c.walls);
      c.rays.add({draw.point(), to - from});
      c.rays.add({from, to - from}, {static_cast<std::uint32_t>(draw.bits() % 4), Root::none});
    }
    const auto grid = CellGrid::build(c.walls);
    ASSERT_TRUE(grid);
    EXPECT_GT(grid->divided(), 0U) << power;
    expect_all_tiers_exact(c);
  }
}

// Where a ray runs along the borders of cells, rounding may say that it changes sides anywhere on its
// way: no wall beside it may be left out, in divided cells neither.
TEST(Tracers, AgreeOnRaysAlongTheBordersOfCells) {
  Case c = random_case(17, 300, 0.05, 0);
  for (Segment& s : c.walls.segments)
    for (Vec2* p : {&s.a, &s.b}) p->x() *= p->x() * p->x();
  const auto grid = CellGrid::build(c.walls);
  ASSERT_TRUE(grid);
  ASSERT_GT(grid->divided(), 0U);
  Draws draw(18);
  const Vec2 cell = grid->scale().cwiseInverse(), middle = -grid->place({0, 0}).cwiseProduct(cell);
  for (int i = 0; i < 400; ++i) {
    const double column = std::floor(grid->place(draw.point()).x() * 4) / 4;
    const double tilt = std::ldexp(draw.unit() - 0.5, -static_cast<int>(draw.bits() % 64));
    const double x = middle.x() + column * cell.x(), turn = i % 2 == 0 ? 1 : -1;
    c.rays.add({{x, draw.unit()}, {tilt, turn}});
    c.rays.add({{std::nextafter(x, 2 * draw.unit() - 1), draw.unit()}, {tilt, turn}});
  }
  expect_all_tiers_exact(c);
}

// Some walls many times over, from either end, and walls that only look alike in floats: rays that
// have left any of them.
TEST(Tracers, AgreeOnCopiesWhicheverTheRayHasLeft) {
  for (const int shapes : {3, 100}) {
    Case c = random_case(23, shapes, 0.3, 0);
    Draws draw(24);
    for (std::size_t i = 0; i < 12; ++i) {
      const Segment wall = c.walls.segments[i];
      for (std::size_t k = 0; k <= i % 4; ++k) {
        c.walls.add(k % 2 == 0 ? Segment{wall.b, wall.a} : wall);
        c.walls.add(Segment{wall.a, wall.b + Vec2(0, 0x1p-50)});
      }
    }
    for (std::uint32_t wall = 0; wall < c.walls.size(); ++wall) {
      const Segment& s = c.walls.segments[wall];
      for (const double place : {0.0, 0.25, 0.5}) {
        const Vec2 from = s.a + place * (s.b - s.a);
        c.rays.add({from, draw.point() - Vec2(0.5, 0.5)}, {wall, Root::none});
        c.rays.add({from, s.a - s.b}, {wall, Root::none});
        const Vec2 origin = draw.point();
        c.rays.add({origin, from - origin}, {wall, Root::none});
        c.rays.add({origin, from - origin});
      }
    }
    const auto grid = CellGrid::build(c.walls);
    ASSERT_TRUE(grid);
    EXPECT_TRUE(grid->is_copy(c.walls.size() - 2));
    EXPECT_FALSE(grid->is_copy(11));
    expect_all_tiers_exact(c);
  }
}

// A pile of copies is as quick as one of them: in lists there is the first alone.
TEST(CellGrid, ListsTheFirstOfCopiesAlone) {
  Surfaces walls;
  for (int i = 0; i < 10'000; ++i)
    walls.add(i % 3 == 0 ? Segment{{1, 0}, {0, -0.0}} : Segment{{0, 0}, {1, 0}});
  walls.add(Segment{{0, 1}, {1, 1}});
  for (const auto& grid : {CellGrid::build(walls), CellGrid::build_list(walls)}) {
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->next_copy(0), 1U);
    EXPECT_EQ(grid->next_copy(9'999), CellGrid::kNoSlot);
    EXPECT_FALSE(grid->is_copy(10'000));
  }
  const auto brute = find_tracer("brute")->build(walls);
  EXPECT_EQ(brute->tested_of_one({{0.5, -1}, {0, 1}}), 2U);
  EXPECT_EQ(brute->nearest_of_one({{0.5, 0}, {0, 1}}, {0, Root::none}).surface, 1U);
}

// Fans whose ends go opposite ways: the sum of their ends, or of words of their ends, is the same.
TEST(CellGrid, TellsSegmentsApartWhoseEndsAddUpToTheSame) {
  const std::size_t kCount = times(10'000);
  const auto up = [](double y) { return Segment{{0, y}, {1, 3 - y}}; };
  const auto across = [](double x) { return Segment{{x, 0}, {3 - x, 1}}; };
  const auto both = [](double x) { return Segment{{x, x}, {3 - x, 3 - x}}; };
  const auto level = [](double y) { return Segment{{0, y}, {1, y}}; };
  for (Segment (*const segment)(double) : {+up, +across, +both, +level}) {
    Case c;
    std::set<std::uint64_t> hashes;
    for (std::size_t i = 0; i < kCount; ++i) {
      c.walls.add(segment(1 + static_cast<double>(i) * 0x1p-15));
      const Segment& s = c.walls.segments.back();
      hashes.insert(hash_of_ends(s));
      ASSERT_EQ(hash_of_ends(s), hash_of_ends({s.b, s.a}));
    }
    EXPECT_EQ(hashes.size(), kCount);
    Draws draw(25);
    for (int i = 0; i < 20; ++i) c.rays.add({3 * draw.point(), draw.point() - Vec2(0.5, 0.5)});
    expect_all_tiers_exact(c);
  }
}

// The first list of the cells that a ray comes through.
std::vector<std::uint32_t> first_list(const CellGrid& cells, const Ray& ray) {
  struct Who {
    const CellGrid& cells;
    std::vector<std::uint32_t> slots{};
  } who{cells};
  const auto list = [](void* asking, unsigned record) {
    Who& of = *static_cast<Who*>(asking);
    do of.slots.push_back(of.cells.slot(record));
    while (!of.cells.last(record++));
  };
  const auto is_settled = [](void*, double) { return true; };
  EXPECT_TRUE(lane_kernels(Isa::portable)
                  .walk.visit_lists(cells.view(), ray.origin.x(), ray.origin.y(), ray.direction.x(),
                                    ray.direction.y(), {&who, list, is_settled}));
  return who.slots;
}

// A segment is listed in every cell it comes near to, whatever its slope: points all along it are
// in cells that have it.
TEST(CellGrid, ListsASegmentInEveryCellItCrosses) {
  Draws draw(13);
  const Surfaces walls = crowd(draw, 200, 0.5);
  const auto grid = CellGrid::build(walls);
  ASSERT_TRUE(grid);
  for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot)
    for (int k = 0; k <= 50 && !grid->is_copy(slot); ++k) {
      const Segment& s = walls.segments[slot];
      const auto listed = first_list(*grid, {s.a + k / 50.0 * (s.b - s.a), {1, 0.3}});
      EXPECT_NE(std::find(listed.begin(), listed.end(), slot), listed.end()) << slot << ' ' << k;
    }
}

// Rows are filled in strips that do not depend on the threads; crowded cells and twins among them.
TEST(CellGrid, HasTheSameBitsForAnyNumberOfThreads) {
  Draws draw(19);
  Surfaces walls = crowd(draw, 30000, 0.01);
  for (int i = 0; i < 3000; ++i) {
    const Vec2 at = 1e-3 * draw.point();
    walls.add(Segment{at, at + 1e-5 * draw.point()});
  }
  const std::size_t own = walls.segments.size();
  for (std::size_t i = 0; i < 50; ++i) {
    const Segment twin = walls.segments[37 * i];
    walls.add(twin);
  }
  const auto alone = CellGrid::build(walls);
  ASSERT_TRUE(alone);
  EXPECT_GT(alone->divided(), 0U);
  EXPECT_TRUE(alone->is_twin(37));
  EXPECT_TRUE(alone->is_twin(own + 1));
  EXPECT_GT(own, 30000U);  // of several strips
  for (const unsigned threads : {2U, 3U, 7U, 16U})
    EXPECT_TRUE(*CellGrid::build(walls, threads) == *alone) << threads;
}

// Found by a reviewer: more words of divided cells than their index counts. Eight million walls.
TEST(CellGrid, CellsAreNotDividedWhereTheirWordsWouldBeTooMany) {
  if (!at_full_counts()) GTEST_SKIP() << "takes half a minute: FLATRAY_FULL_COUNTS";
  constexpr int kClusters = 690, kWalls = 17, kAside = 4000, kStep = (kAside - 40) / kClusters;
  constexpr double kScale = (kAside - 512 * 0x1p-24 * (kAside / 2 + 1)) / 2, kSize = 1e-7 / kScale;
  Draws draw(26);
  Surfaces walls;
  for (const double y : {-1, 1}) walls.add(Segment{{-1, y}, {1, y}});
  // Where four cells meet.
  const auto corner = [](int i) { return (i - kClusters / 2) * kStep / kScale; };
  for (int i = 0; i < kClusters * kClusters; ++i) {
    const Vec2 at(corner(i % kClusters), corner(i / kClusters));
    for (int k = 0; k < kWalls; ++k)
      walls.add(Segment{at + kSize * draw.point(), at - kSize * draw.point()});
  }
  const auto grid = find_tracer("grid")->build(walls);
  for (const int i : {0, 1, kClusters / 2, kClusters - 1}) {
    const Vec2 at(corner(i), corner(kClusters - 1)), way = Vec2(0.5, 0.3) / kScale;
    ExactNearest exact(walls, {at - way, way}, {}, true);
    exact.offer_all();
    EXPECT_EQ(grid->nearest_of_one({at - way, way}, {}, true), exact.hit()) << i;
  }
}

}  // namespace
}  // namespace flatray
