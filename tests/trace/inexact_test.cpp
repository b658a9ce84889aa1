// Tracers in single precision: right to its digits where nothing is close, and wrong as it is.
#include <gtest/gtest.h>

#include "trace/all_tracers.h"

namespace flatray {
namespace {

class Inexact : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    tracer = find_tracer(GetParam());
    ASSERT_NE(tracer, nullptr);
    EXPECT_FALSE(tracer->exact);
    if (tracer->missing != nullptr && !tracer->missing().empty()) GTEST_SKIP() << tracer->missing();
  }
  const Tracer* tracer = nullptr;
};

TEST_P(Inexact, MeetsTheSameWallsWhereNoneAreClose) {
  Draws draw(1);
  Case c;
  for (int i = 0; i < 20; ++i) {
    const double x = draw.whole(-40, 40);
    c.walls.add(Segment{{x, 10.0 * i}, {x + 4, 10.0 * i + 3}});
  }
  c.walls.add(Circle{{0, -30}, 12});
  for (int i = 0; i < 500; ++i) c.rays.add({{100 * draw.unit() - 50, -60}, {draw.unit() - 0.5, 1}});
  std::vector<NearestHit> hits(c.rays.size());
  tracer->build(c.walls)->nearest(c.rays, hits);
  int other = 0, met = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const NearestHit truth = exact_hit_of(c, i);
    if (hits[i].surface != truth.surface) ++other;
    if (!truth || hits[i].surface != truth.surface) continue;
    EXPECT_NEAR(hits[i].t, truth.t, 1e-4 * truth.t);
    ++met;
  }
  EXPECT_LE(other, 2);
  EXPECT_GT(met, 200);
}

TEST_P(Inexact, LeavesOutTheWallJustLeft) {
  Case c;
  c.walls.add(Segment{{0, -1}, {0, 1}});
  c.walls.add(Segment{{1, -1}, {1, 1}});
  c.walls.add(Circle{{-2, 0}, 1});
  c.rays.add({{0, 0}, {1, 0}}, {0, Root::none});
  c.rays.add({{-1, 0}, {1, 0}}, {2, Root::second});
  c.rays.add({{3, 0}, {1, 0}});
  std::vector<NearestHit> hits(c.rays.size());
  tracer->build(c.walls)->nearest(c.rays, hits);
  EXPECT_EQ(hits[0].surface, 1U);
  EXPECT_EQ(hits[1].surface, 0U);
  EXPECT_FALSE(hits[2]);
}

// A wall that ends one double short of the ray's line is met in single precision.
TEST_P(Inexact, CannotTellOneDoubleFromTheNext) {
  Case c;
  c.walls.add(Segment{{1, -1}, {1, std::nextafter(0.0, -1.0)}});
  c.walls.add(Segment{{2, -1}, {2, 1}});
  c.rays.add({{0, 0}, {1, 0}});
  EXPECT_EQ(exact_hit_of(c, 0).surface, 1U);
  std::vector<NearestHit> hits(1);
  tracer->build(c.walls)->nearest(c.rays, hits);
  EXPECT_EQ(hits[0].surface, 0U);
}

// Beyond the range of single precision nothing is met, whatever the library's own checks say. To
// Embree directions are given in a length it can take.
TEST_P(Inexact, MeetsNothingBeyondItsRange) {
  Case c;
  c.walls.add(Segment{{1, -1}, {1, 1}});
  for (const double large : {1e39, 1e300}) {
    c.rays.add({{0, 0}, {large, 0}});
    c.rays.add({{-large, 0}, {1, 0}});
    c.rays.add({{-large, large}, {large, -large}});
  }
  std::vector<NearestHit> hits(c.rays.size());
  tracer->build(c.walls)->nearest(c.rays, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(static_cast<bool>(hits[i]), tracer->name == std::string("embree") && i % 3 == 0) << i;
    EXPECT_TRUE(exact_hit_of(c, i)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Tracers, Inexact, testing::Values("float", "embree"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace flatray
