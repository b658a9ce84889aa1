// What must hold of any exact answer, whatever finds it: every tracer, on scenes of a few and of
// many walls.
#include <gtest/gtest.h>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

class Laws : public testing::TestWithParam<const Tracer*> {
 protected:
  static std::vector<NearestHit> hits(const Case& c) {
    std::vector<NearestHit> met(c.rays.size());
    GetParam()->build(c.walls)->nearest(c.rays, met);
    return met;
  }
};

// Whole numbers throughout: rays meet ends, run along walls and start on them.
Case whole_numbers(std::uint64_t seed, int walls, int size) {
  Draws draw(seed);
  Case c;
  for (int i = 0; i < walls; ++i)
    c.walls.add(Segment{draw.grid_point(-size, size), draw.grid_point(-size, size)});
  for (int i = 0; i < 200; ++i) {
    Ray ray{draw.grid_point(-size, size), draw.grid_point(-3, 3)};
    while (ray.direction == Vec2(0, 0)) ray.direction = draw.grid_point(-3, 3);
    c.rays.add(ray);
  }
  return c;
}
std::vector<Case> cases() { return {whole_numbers(1, 12, 6), whole_numbers(2, 150, 40)}; }

template <class Move>
Case moved(const Case& c, const Move& move, double turns = 1) {
  Case other;
  for (const Segment& s : c.walls.segments) other.walls.add(Segment{move(s.a), move(s.b)});
  for (std::size_t i = 0; i < c.rays.size(); ++i) {
    const Ray ray = c.rays.ray(i);
    const Vec2 tip = move(ray.origin + ray.direction), from = move(ray.origin);
    other.rays.add({from, turns * (tip - from)}, c.rays.departed[i]);
  }
  return other;
}

TEST_P(Laws, ScaleByAPowerOfTwoChangesNothing) {
  for (const Case& c : cases())
    for (const int power : {-900, -60, 1, 60, 800})
      EXPECT_EQ(hits(moved(c,
                           [&](const Vec2& p) {
                             return Vec2(std::ldexp(p.x(), power), std::ldexp(p.y(), power));
                           })),
                hits(c));
}

TEST_P(Laws, ShiftByWhatDoublesHoldChangesNothing) {
  for (const Case& c : cases())
    for (const Vec2& by : {Vec2(3, -7), Vec2(0x1p40, 0), Vec2(-0x1p45, 0x1p44)})
      EXPECT_EQ(hits(moved(c, [&](const Vec2& p) { return Vec2(p + by); })), hits(c));
}

TEST_P(Laws, MirrorsAndQuarterTurnsChangeNothing) {
  for (const Case& c : cases()) {
    EXPECT_EQ(hits(moved(c, [](const Vec2& p) { return Vec2(-p.x(), p.y()); })), hits(c));
    EXPECT_EQ(hits(moved(c, [](const Vec2& p) { return Vec2(-p.y(), p.x()); })), hits(c));
  }
}

TEST_P(Laws, ALongerDirectionShortensT) {
  for (const Case& c : cases()) {
    std::vector<NearestHit> truth = hits(c);
    for (NearestHit& hit : truth) hit.t /= 4;
    EXPECT_EQ(hits(moved(
                  c, [](const Vec2& p) { return p; }, 4)),
              truth);
  }
}

TEST_P(Laws, ReversedWallsChangeNothing) {
  for (const Case& c : cases()) {
    Case other;
    other.rays = c.rays;
    for (const Segment& s : c.walls.segments) other.walls.add(Segment{s.b, s.a});
    EXPECT_EQ(hits(other), hits(c));
  }
}

// By another order the same t; another wall only where several are met together.
TEST_P(Laws, ReorderedWallsAreMetAtTheSameT) {
  for (const Case& c : cases()) {
    const auto count = static_cast<std::uint32_t>(c.walls.size());
    Case other;
    other.rays = c.rays;
    for (std::uint32_t i = count; i-- > 0;) other.walls.add(c.walls.segments[i]);
    const auto met = hits(c), of_other = hits(other);
    for (std::size_t i = 0; i < met.size(); ++i) {
      ASSERT_EQ(met[i].t, of_other[i].t);
      ASSERT_EQ(static_cast<bool>(met[i]), static_cast<bool>(of_other[i]));
      if (!met[i] || count - 1 - of_other[i].surface == met[i].surface) continue;
      ExactNearest again(c.walls, c.rays.ray(i), {}, true);
      again.offer(count - 1 - of_other[i].surface);
      ASSERT_EQ(again.hit().t, met[i].t);
      ASSERT_LT(met[i].surface, count - 1 - of_other[i].surface);
    }
  }
}

// A wall cut at a point of it that doubles hold is met where it was; the cut may now be an end.
TEST_P(Laws, ASplitWallIsMetAtTheSameT) {
  for (const Case& c : cases()) {
    Case other;
    other.rays = c.rays;
    for (const Segment& s : c.walls.segments) {
      const Vec2 middle = 0.5 * (s.a + s.b);
      other.walls.add(Segment{s.a, middle});
      other.walls.add(Segment{middle, s.b});
    }
    const auto met = hits(c), of_other = hits(other);
    for (std::size_t i = 0; i < met.size(); ++i) {
      ASSERT_EQ(met[i].t, of_other[i].t);
      if (met[i]) {
        ASSERT_EQ(of_other[i].surface / 2, met[i].surface);
      }
    }
  }
}

// Back from beyond all walls the last of all hits is the first, and those together are the same.
TEST_P(Laws, AReversedRayMeetsTheSameWalls) {
  for (const Case& c : cases()) {
    const auto walls = GetParam()->build(c.walls);
    for (std::size_t i = 0; i < c.rays.size(); ++i) {
      const Ray ray = c.rays.ray(i);
      const Ray ahead{ray.origin - 1024 * ray.direction, ray.direction};
      const Ray back{ray.origin + 1024 * ray.direction, -ray.direction};
      const auto there = walls->all_of_one(ahead), again = walls->all_of_one(back);
      ASSERT_EQ(there.size(), again.size());
      std::vector<std::uint32_t> a, b;
      for (const NearestHit& hit : there) a.push_back(hit.surface);
      for (const NearestHit& hit : again) b.push_back(hit.surface);
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      ASSERT_EQ(a, b);
      if (there.empty() || again.front().kind == HitClass::along) continue;
      EXPECT_NEAR(again.front().t, 2048 - there.back().t, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tracers, Laws, testing::ValuesIn(exact_tracers()),
                         [](const auto& one) { return std::string(one.param->name); });

}  // namespace
}  // namespace flatray
