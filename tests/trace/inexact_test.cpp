// Tracers without bounds: right to their digits where nothing is close; in single precision wrong as it
// is.
#include <gtest/gtest.h>

#include "trace/all_tracers.h"
#include "trace/plain_polygons.h"

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

class InSinglePrecision : public Inexact {};

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
TEST_P(InSinglePrecision, CannotTellOneDoubleFromTheNext) {
  Case c;
  c.walls.add(Segment{{1, -1}, {1, std::nextafter(0.0, -1.0)}});
  c.walls.add(Segment{{2, -1}, {2, 1}});
  c.rays.add({{0, 0}, {1, 0}});
  EXPECT_EQ(exact_hit_of(c, 0).surface, 1U);
  std::vector<NearestHit> hits(1);
  tracer->build(c.walls)->nearest(c.rays, hits);
  EXPECT_EQ(hits[0].surface, 0U);
}

// Beyond the range of single precision nothing is met, whatever the library's own checks say, but: to
// Embree directions are given in a length it can take; the paper's quotient by infinity is 0.
TEST_P(InSinglePrecision, MeetsNothingBeyondItsRange) {
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
    EXPECT_EQ(static_cast<bool>(hits[i]), tracer->name != std::string("float") && i % 3 == 0) << i;
    EXPECT_TRUE(exact_hit_of(c, i)) << i;
  }
}

std::string tracer_name(const testing::TestParamInfo<const char*>& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Tracers, Inexact,
                         testing::Values("cyrus-beck", "cyrus-beck-float", "float", "embree"),
                         tracer_name);
INSTANTIATE_TEST_SUITE_P(Tracers, InSinglePrecision,
                         testing::Values("cyrus-beck-float", "float", "embree"), tracer_name);

// Curves are user geometry of Embree, whose formulas are those of the tracer `float`: where there are
// curves alone, and segments that the lines of rays are far from, both say the same.
TEST(EmbreeCurves, AreMetAsTheTracerFloatMeetsThem) {
  const Tracer* embree = find_tracer("embree");
  if (embree->missing && !embree->missing().empty()) GTEST_SKIP() << embree->missing();
  Draws draw(91);
  Case c;
  c.walls.add(Segment{{1000, 1000}, {1001, 1001}});
  for (int i = 0; i < 60; ++i) {
    const Circle circle{{draw.spread(-2, 4), draw.spread(-2, 4)}, 0.1 + draw.unit()};
    const Vec2 from = circle.centre + draw.point(), to = circle.centre - draw.point();
    if (i % 3 == 0) c.walls.add(circle);
    if (i % 3 == 1) c.walls.add(Arc{circle, Arc::Extent::between, from, to});
    if (i % 3 == 2)
      c.walls.add(Arc{Ellipse(circle.centre, {2, 1}, {-0.5, 0.25}), Arc::Extent::half, {1, 2}, {}});
  }
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const DepartedSurface departed =
        i % 4 == 0 ? DepartedSurface{1 + i % 60, Root::both} : DepartedSurface{};
    c.rays.add(
        {{draw.spread(-2, 4), draw.spread(-2, 4)}, {draw.spread(-30, 30), draw.spread(-30, 30)}},
        departed);
  }
  std::vector<NearestHit> wanted(c.rays.size()), hits(c.rays.size());
  find_tracer("float")->build(c.walls)->nearest(c.rays, wanted);
  embree->build(c.walls)->nearest(c.rays, hits);
  std::size_t met = 0, differ = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    met += hits[i].surface > 0 && hits[i] ? 1 : 0;
    differ += hits[i] == wanted[i] ? 0 : 1;
  }
  EXPECT_GT(met, 1000U);
  EXPECT_EQ(differ, 0U);
}

std::vector<plain::Edge<double>> edges_of(const std::vector<Vec2>& ring) {
  std::vector<plain::Edge<double>> edges;
  for (std::uint32_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    edges.push_back({a.x(), a.y(), edge.y(), -edge.x(), i});
  }
  return edges;
}

// The paper's case I (facts, section 3): the right intervals, not the printed ones.
TEST(CyrusBeckTracer, ClipsAsThePaperHasIt) {
  const auto block_a = edges_of({{20, 2}, {16, 10}, {10, 10}, {5, 5}});
  const auto hit = plain::clip<double>({1, 2, 22, 10}, block_a);
  EXPECT_EQ(hit.t_enter, 19.0 / 72);
  EXPECT_EQ(hit.t_exit, 19.0 / 27);
  EXPECT_EQ(hit.entered, 3U);
  EXPECT_EQ(hit.left, 0U);
  const auto block_b = edges_of({{885, 378}, {949, 378}, {949, 506}, {885, 506}});
  const auto miss = plain::clip<double>({275, 200, 39, 0}, block_b);
  EXPECT_GT(miss.t_enter, miss.t_exit);  // parallel to edge 0, and outside
}

// Rings in both orders, met from inside and outside; an outline with a dent and a star, which winds twice,
// are no convex polygons.
TEST(CyrusBeckTracer, MeetsTheWallsOfPolygonsThatExactTracersMeet) {
  const std::vector<std::vector<Vec2>> rings = {
      {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}},
      {{-20, 10}, {-30, -5}, {-10, -10}},
      {{-20, 20}, {-5, 35}, {-22, 40}, {-35, 30}},
      {{10, 10}, {40, 12}, {25, 20}, {30, 40}, {12, 30}},
      {{20, -10}, {26, -30}, {10, -18}, {30, -18}, {14, -30}}};
  Case c;
  for (const std::vector<Vec2>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      c.walls.add(Segment{ring[i], ring[(i + 1) % ring.size()]});
  Draws draw(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 from = 120 * (draw.point() - Vec2(0.5, 0.5));
    c.rays.add({from, draw.point() - Vec2(0.5, 0.5)});
  }
  for (const char* name : {"cyrus-beck", "cyrus-beck-float"}) {
    std::vector<NearestHit> hits(c.rays.size());
    find_tracer(name)->build(c.walls)->nearest(c.rays, hits);
    int other = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const NearestHit truth = exact_hit_of(c, i);
      other += hits[i].surface != truth.surface ? 1 : 0;
      if (hits[i].surface != truth.surface || !truth) continue;
      EXPECT_NEAR(hits[i].t, truth.t, 1e-3 * truth.t);
    }
    EXPECT_LE(other, name == std::string("cyrus-beck") ? 0 : 2) << name;
  }
}

}  // namespace
}  // namespace flatray
