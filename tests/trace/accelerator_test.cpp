// Any wall up to t, and all walls in order, by every tracer.
#include <gtest/gtest.h>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

std::vector<std::uint32_t> numbers(const std::vector<NearestHit>& hits) {
  std::vector<std::uint32_t> of;
  for (const NearestHit& hit : hits) of.push_back(hit.surface);
  return of;
}

class EachTracer : public testing::TestWithParam<const Tracer*> {
 protected:
  std::vector<NearestHit> all(const Ray& ray, const DepartedSurface& departed = {}) const {
    return GetParam()->build(walls)->all_of_one(ray, departed);
  }
  bool any(const Ray& ray, double up_to, const DepartedSurface& departed = {}) const {
    return GetParam()->build(walls)->any_of_one(ray, up_to, departed);
  }
  Surfaces walls;
};

using AllHits = EachTracer;
using AnyHit = EachTracer;

TEST_P(AllHits, ComeInOrderOfT) {
  for (const double x : {3.0, 1.0, 40.0, 2.0, -1.0}) walls.add(Segment{{x, -1}, {x, 1}});
  const auto hits = all({{0, 0}, {1, 0}});
  EXPECT_EQ(numbers(hits), (std::vector<std::uint32_t>{1, 3, 0, 2}));
  EXPECT_EQ(hits.back().t, 40);
}

// Stiff case B11: 10 000 copies of one segment are 10 000 hits at one t, by number.
TEST_P(AllHits, B11_CopiesAreHitTogetherInOrderOfTheirNumbers) {
  walls.add(Segment{{0, 1}, {1, 1}});
  for (int i = 0; i < 10'000; ++i) walls.add(Segment{{0, 0}, {1, 0}});
  const auto hits = all({{0.5, -1}, {0, 1}});
  ASSERT_EQ(hits.size(), 10'001U);
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    ASSERT_EQ(hits[i].surface, i + 1);
    ASSERT_EQ(hits[i].t, 1);
  }
  EXPECT_EQ(hits.back().t, 2);
}

TEST_P(AllHits, HaveACircleAtBothRootsAndATangentOnce) {
  walls.add(Circle{{2, 0}, 1});
  walls.add(Circle{{6, 1}, 1});
  const auto hits = all({{0, 0}, {1, 0}});
  ASSERT_EQ(hits.size(), 3U);
  EXPECT_EQ(hits[0].t, 1);
  EXPECT_EQ(hits[0].root, Root::first);
  EXPECT_EQ(hits[1].t, 3);
  EXPECT_EQ(hits[1].root, Root::second);
  EXPECT_EQ(hits[2].kind, HitClass::touch);
  EXPECT_EQ(hits[2].t, 6);
}

TEST_P(AllHits, LeaveOutWhatTheRayHasJustLeft) {
  walls.add(Segment{{0, -1}, {0, 1}});
  walls.add(Segment{{1, -1}, {1, 1}});
  EXPECT_EQ(numbers(all({{0, 0}, {1, 0}}, {0, Root::none})), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(numbers(all({{0, 0}, {1, 0}})), (std::vector<std::uint32_t>{0, 1}));
}

TEST_P(AllHits, OfAPointAreAllWallsItLiesOn) {
  walls.add(Segment{{-1, 0}, {1, 0}});
  walls.add(Segment{{0, 1}, {1, 1}});
  walls.add(Circle{{1, 0}, 1});
  EXPECT_EQ(numbers(all({{0, 0}, {0, 0}})), (std::vector<std::uint32_t>{0, 2}));
}

// Random walls: what is hit is what each wall alone is hit at, and the first is the nearest.
TEST_P(AllHits, AreThoseOfEachWallAlone) {
  Draws draw(1);
  for (int i = 0; i < 60; ++i) walls.add(Segment{draw.grid_point(-9, 9), draw.grid_point(-9, 9)});
  const auto accelerator = GetParam()->build(walls);
  std::size_t met = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray ray{draw.grid_point(-9, 9), draw.grid_point(-4, 4)};
    const auto hits = accelerator->all_of_one(ray);
    std::vector<std::uint32_t> alone;
    for (std::uint32_t number = 0; number < walls.size(); ++number) {
      ExactNearest search(walls, ray, {}, true);
      search.offer(number);
      if (search.hit()) alone.push_back(number);
    }
    std::vector<std::uint32_t> found = numbers(hits);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, alone);
    met += found.size();
    if (hits.empty()) continue;
    EXPECT_EQ(hits.front(), accelerator->nearest_of_one(ray));
    for (std::size_t k = 1; k < hits.size(); ++k)
      EXPECT_TRUE(hits[k - 1].t < hits[k].t ||
                  (hits[k - 1].t == hits[k].t && hits[k - 1].surface < hits[k].surface));
  }
  EXPECT_GT(met, 500U);
}

// The same of so many circles that they are in cells; some are tangents.
TEST_P(AllHits, OfCirclesAreThoseOfEachAlone) {
  Draws draw(2);
  for (int i = 0; i < 60; ++i)
    walls.add(Circle{draw.grid_point(-9, 9), std::fabs(draw.grid_point(1, 3).x())});
  const auto accelerator = GetParam()->build(walls);
  std::size_t met = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray ray{draw.grid_point(-9, 9), draw.grid_point(-4, 4)};
    std::vector<std::uint32_t> alone;
    for (std::uint32_t number = 0; number < walls.size(); ++number) {
      ExactNearest search(walls, ray, {}, true, true);
      search.offer(number);
      for (const NearestHit& hit : search.hits()) alone.push_back(hit.surface);
    }
    std::vector<std::uint32_t> found = numbers(accelerator->all_of_one(ray));
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, alone);
    met += found.size();
  }
  EXPECT_GT(met, 1000U);
}

TEST_P(AllHits, AreThoseAheadInOrderOfTime) {
  walls.add(Segment{{1, -1}, {1, 1}});
  walls.add(Segment{{2, -1}, {2, 1}});
  const auto accelerator = GetParam()->build(walls);
  EXPECT_EQ(accelerator->all_of_one({{0, 0}, {1, 0}}).size(), 2U);
  EXPECT_TRUE(accelerator->all_of_one({{0, 0}, {-1, 0}}).empty());
  const std::vector<NearestHit> hits = accelerator->all_of_one({{0, 0}, {2, 0}});
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[1].t, 1);
}

TEST_P(AnyHit, CountsTheWallAtTheLimitItself) {
  walls.add(Segment{{3, -1}, {3, 1}});
  EXPECT_TRUE(any({{0, 0}, {1, 0}}, 3));
  EXPECT_FALSE(any({{0, 0}, {1, 0}}, std::nextafter(3.0, 0.0)));
  EXPECT_FALSE(any({{0, 0}, {-1, 0}}, 1e300));
  EXPECT_FALSE(any({{0, 0}, {1, 0}}, 5, {0, Root::none}));
}

// 1 / 3 lies above its nearest double, 1 / 10 below.
TEST_P(AnyHit, IsDecidedForTheExactTime) {
  walls.add(Segment{{1, -1}, {1, 1}});
  EXPECT_FALSE(any({{0, 0}, {3, 0}}, 1.0 / 3));
  EXPECT_TRUE(any({{0, 0}, {3, 0}}, std::nextafter(1.0 / 3, 1.0)));
  EXPECT_TRUE(any({{0, 0}, {10, 0}}, 0.1));
  EXPECT_FALSE(any({{0, 0}, {10, 0}}, std::nextafter(0.1, 0.0)));
}

TEST_P(AnyHit, OfABatchIsThatOfEachRay) {
  Draws draw(2);
  for (int i = 0; i < 40; ++i) walls.add(Segment{draw.grid_point(-5, 5), draw.grid_point(-5, 5)});
  RayBatch rays;
  std::vector<double> up_to;
  for (int i = 0; i < 300; ++i) {
    rays.add({draw.grid_point(-5, 5), draw.grid_point(-3, 3)});
    up_to.push_back(draw.whole(0, 3));
  }
  const auto accelerator = GetParam()->build(walls);
  std::vector<std::uint8_t> met(rays.size());
  accelerator->any(rays, up_to, met);
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(met[i] == 1, accelerator->any_of_one(rays.ray(i), up_to[i]));
    const auto hits = accelerator->all_of_one(rays.ray(i));
    EXPECT_EQ(met[i] == 1, !hits.empty() && hits.front().t <= up_to[i]);
    blocked += met[i];
  }
  EXPECT_GT(blocked, 50U);
  EXPECT_LT(blocked, 290U);
}

// From within and from far outside, to an end before, between and beyond the walls, at a wall, behind
// the start, nowhere.
TEST_P(AnyHit, OfManyWallsIsThatOfTheFirst) {
  Draws draw(3);
  const auto place = [&] { return Vec2(draw.point() * 20 - Vec2(10, 10)); };
  for (int i = 0; i < 600; ++i) {
    const Vec2 from = place();
    walls.add(Segment{from, from + 0.1 * place()});
  }
  if (std::string(GetParam()->name) != "brute") walls.add(Circle{{3, 3}, 0.25});
  const auto accelerator = GetParam()->build(walls);
  RayBatch rays;
  for (int i = 0; i < 1500; ++i) {
    const Vec2 from = (i % 3 == 0 ? 50.0 : 1.0) * place();
    rays.add({from, i % 2 == 0 ? Vec2(place() - from) : 1e-3 * place()});
  }
  std::vector<NearestHit> first(rays.size());
  accelerator->nearest(rays, first);
  std::vector<double> up_to;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double t = first[i] ? first[i].t : 1, share = 2 * draw.unit();
    const double ends[] = {t * share, t, std::nextafter(t, 0), kInfinity, -share, 0, t * 1.0001};
    up_to.push_back(ends[draw.bits() % std::size(ends)]);
  }
  std::vector<std::uint8_t> met(rays.size());
  accelerator->any(rays, up_to, met);
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (first[i] && first[i].t == up_to[i])
      EXPECT_EQ(met[i] == 1, accelerator->any_of_one(rays.ray(i), up_to[i])) << i;
    else
      EXPECT_EQ(met[i] == 1, first[i] && first[i].t < up_to[i]) << i;
    blocked += met[i];
  }
  EXPECT_GT(blocked, 300U);
  EXPECT_LT(blocked, 1000U);
}

std::string name_of(const testing::TestParamInfo<const Tracer*>& info) { return info.param->name; }
INSTANTIATE_TEST_SUITE_P(Tracers, AllHits, testing::ValuesIn(exact_tracers()), name_of);
INSTANTIATE_TEST_SUITE_P(Tracers, AnyHit, testing::ValuesIn(exact_tracers()), name_of);

}  // namespace
}  // namespace flatray
