#include "geom/curved_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "full_counts.h"
#include "geom/clip.h"
#include "geom/interval_set.h"
#include "trace/random_rays.h"

namespace flatray {
namespace {

Arc between(const Vec2& centre, double radius, const Vec2& from, const Vec2& to) {
  return {Circle{centre, radius}, Arc::Extent::between, from, to};
}

PathEdge straight(const Vec2& from, const Vec2& to, int number) {
  return {from, to, std::nullopt, true, number};
}
PathEdge turning(const Arc& arc, int number) { return {arc.from, arc.to, arc, true, number}; }

// From (0, 0) to (4, 0), radius 1: exact corners.
CurvedPath pill() {
  return {{turning(between({4, 0}, 1, {4, -1}, {4, 1}), 0), straight({4, 1}, {0, 1}, 1),
           turning(between({0, 0}, 1, {0, 1}, {0, -1}), 2), straight({0, -1}, {4, -1}, 3)},
          true};
}

// Three quarters of a disc of radius 5; the ends of the arc and of what goes back through the centre.
CurvedPath three_quarters() {
  return {{turning(between({0, 0}, 5, {5, 0}, {0, -5}), 0), straight({0, -5}, {0, 0}, 1),
           straight({0, 0}, {5, 0}, 2)},
          true};
}

// A quarter of a ring from radius 3 to 5.
CurvedPath quarter_ring() {
  PathEdge inner = turning(between({0, 0}, 3, {3, 0}, {0, 3}), 2);
  std::swap(inner.from, inner.to);
  inner.counter_clockwise = false;
  return {{turning(between({0, 0}, 5, {5, 0}, {0, 5}), 0), straight({0, 5}, {0, 3}, 1), inner,
           straight({3, 0}, {5, 0}, 3)},
          true};
}

CurvedPath reversed(const CurvedPath& path) {
  CurvedPath back{{path.edges.rbegin(), path.edges.rend()}, path.closed};
  for (PathEdge& edge : back.edges) {
    std::swap(edge.from, edge.to);
    edge.counter_clockwise = !edge.counter_clockwise;
  }
  return back;
}

void expect_hit(const HitInterval& hit, HitClass kind, double enter, int edge_enter, double exit,
                int edge_exit) {
  EXPECT_EQ(hit.kind, kind);
  EXPECT_DOUBLE_EQ(hit.t_enter, enter);
  EXPECT_DOUBLE_EQ(hit.t_exit, exit);
  EXPECT_EQ(hit.edge_enter, edge_enter);
  EXPECT_EQ(hit.edge_exit, edge_exit);
}

TEST(CurvedPaths, AreEnteredAndLeftByTheirArcsAndEdges) {
  const auto along = clip_path({{-3, 0}, {1, 0}}, pill());
  ASSERT_EQ(along.size(), 1U);
  expect_hit(along[0], HitClass::through, 2, 2, 8, 0);
  EXPECT_EQ(along[0].start, StartPlace::outside);
  const auto across = clip_path({{2, 3}, {0, -1}}, pill());
  ASSERT_EQ(across.size(), 1U);
  expect_hit(across[0], HitClass::through, 2, 1, 4, 3);
  const auto slanted = clip_path({{4, 0}, {0.6, 0.8}}, pill());
  ASSERT_EQ(slanted.size(), 1U);
  EXPECT_EQ(slanted[0].start, StartPlace::inside);
  EXPECT_NEAR(slanted[0].t_exit, 1, 1e-15);
}

TEST(CurvedPaths, ARayAlongAStraightEdgeMeetsItAndNoMore) {
  const auto side = clip_path({{-1, 1}, {1, 0}}, pill());
  ASSERT_EQ(side.size(), 1U);
  expect_hit(side[0], HitClass::along, 1, 1, 5, 0);
  EXPECT_EQ(clip_path({{2, 1}, {1, 0}}, pill())[0].start, StartPlace::boundary);
}

TEST(CurvedPaths, TangentsAndCornersAreTouches) {
  const auto end = clip_path({{5, -3}, {0, 1}}, pill());
  ASSERT_EQ(end.size(), 1U);
  expect_hit(end[0], HitClass::touch, 3, 0, 3, 0);
  const auto corner = clip_path({{4, -1}, {1, 1}}, quarter_ring());
  ASSERT_EQ(corner.size(), 1U);
  EXPECT_EQ(corner[0].kind, HitClass::touch);
}

TEST(CurvedPaths, WhatIsNotConvexIsMetInParts) {
  const auto mouth = clip_path({{-6, -1}, {1, 0}}, three_quarters());
  ASSERT_EQ(mouth.size(), 1U);
  expect_hit(mouth[0], HitClass::through, 6 - std::sqrt(24.0), 0, 6, 1);
  const auto twice = clip_path({{-3, -4}, {0.5, 0.5}}, three_quarters());
  ASSERT_EQ(twice.size(), 2U);
  expect_hit(twice[0], HitClass::through, 0, kNoEdge, 6, 1);  // from the wall itself
  expect_hit(twice[1], HitClass::through, 8, 2, 14, 0);
  const auto ring = clip_path({{1, 7}, {0, -1}}, quarter_ring());
  ASSERT_EQ(ring.size(), 1U);
  expect_hit(ring[0], HitClass::through, 7 - std::sqrt(24.0), 0, 7 - std::sqrt(8.0), 2);
}

// Along an edge of the mouth, through the centre, into what lies behind it.
TEST(CurvedPaths, APartMayRunAlongTheBoundaryFirst) {
  const auto hit = clip_path({{7, 0}, {-1, 0}}, three_quarters());
  ASSERT_EQ(hit.size(), 1U);
  expect_hit(hit[0], HitClass::through, 2, 0, 12, 0);
  EXPECT_EQ(clip_path({{3, 0}, {-1, 0}}, three_quarters())[0].start, StartPlace::boundary);
  EXPECT_EQ(clip_path({{-3, 0}, {-1, 0}}, three_quarters())[0].start, StartPlace::inside);
}

TEST(CurvedPaths, APointIsTested) {
  EXPECT_EQ(clip_path({{2, 0.5}, {0, 0}}, pill())[0].start, StartPlace::inside);
  EXPECT_EQ(clip_path({{2, 1}, {0, 0}}, pill())[0].kind, HitClass::touch);
  EXPECT_TRUE(clip_path({{-0.75, 0.75}, {0, 0}}, pill()).empty());
  EXPECT_EQ(clip_path({{0, 0}, {0, 0}}, pill())[0].start, StartPlace::inside);
  EXPECT_EQ(clip_path({{0, 0}, {0, 0}}, three_quarters())[0].start, StartPlace::boundary);
}

TEST(CurvedPaths, OpenOnesAreMetInPoints) {
  CurvedPath open = pill();
  open.closed = false;
  open.edges.pop_back();
  const auto points = clip_path({{-3, 0}, {1, 0}}, open);
  ASSERT_EQ(points.size(), 2U);
  expect_hit(points[0], HitClass::touch, 2, 2, 2, 2);
  expect_hit(points[1], HitClass::touch, 8, 0, 8, 0);
  EXPECT_EQ(clip_path({{2, 3}, {0, -1}}, open).size(), 1U);
  const auto side = clip_path({{-1, 1}, {1, 0}}, open);
  ASSERT_EQ(side.size(), 1U);
  EXPECT_EQ(side[0].kind, HitClass::along);
}

// Rays on a grid of halves, so that they run along edges, through corners and centres, and tangent.
class RaysOnAGrid {
 public:
  Ray next() {
    Ray ray;
    do {
      ray.origin = point();
      ray.direction = point() - ray.origin;
    } while (ray.direction == Vec2(0, 0));
    return ray;
  }

 private:
  Vec2 point() { return 0.5 * draws_.grid_point(-16, 16); }
  Draws draws_{91};
};

// The pill is the union of two discs and a box, in exact numbers too.
TEST(CurvedPaths, APillIsTheUnionOfDiscsAndABox) {
  const std::vector<Vec2> box = {{0, -1}, {4, -1}, {4, 1}, {0, 1}};
  RaysOnAGrid rays;
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = rays.next();
    std::vector<Range> parts;
    for (const HitInterval& hit :
         {clip_circle(ray, {{0, 0}, 1}), clip_circle(ray, {{4, 0}, 1}), clip_convex(ray, box)})
      if (hit) parts.push_back({hit.t_enter, hit.t_exit});
    IntervalSet found;
    for (const HitInterval& hit : clip_path(ray, pill()))
      found.push_back({hit.t_enter, hit.t_exit});
    const IntervalSet expected = interval_set(parts);
    ASSERT_EQ(found.size(), expected.size()) << i;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].low, expected[k].low) << i;
      EXPECT_EQ(found[k].high, expected[k].high) << i;
    }
    met += found.empty() ? 0 : 1;
  }
  EXPECT_GT(met, 400);
}

// The two thirds that are not a quarter of the disc: the whole disc is what both are together.
TEST(CurvedPaths, ASectorAndTheRestAreTheDisc) {
  const CurvedPath quarter{{turning(between({0, 0}, 5, {0, -5}, {5, 0}), 0),
                            straight({5, 0}, {0, 0}, 1), straight({0, 0}, {0, -5}, 2)},
                           true};
  RaysOnAGrid rays;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = rays.next();
    std::vector<Range> parts;
    for (const CurvedPath& path : {quarter, three_quarters()})
      for (const HitInterval& hit : clip_path(ray, path))
        parts.push_back({hit.t_enter, hit.t_exit});
    const IntervalSet both = interval_set(parts);
    const HitInterval disc = clip_circle(ray, {{0, 0}, 5});
    ASSERT_EQ(both.size(), disc ? 1U : 0U) << i;
    if (!disc) continue;
    EXPECT_EQ(both[0].low, disc.t_enter) << i;
    EXPECT_EQ(both[0].high, disc.t_exit) << i;
  }
}

TEST(CurvedPaths, TheWayRoundChangesNothing) {
  RaysOnAGrid rays;
  for (std::uint64_t i = 0; i < times(2000); ++i) {
    const Ray ray = rays.next();
    for (const CurvedPath& path : {pill(), three_quarters(), quarter_ring()})
      EXPECT_EQ(clip_path(ray, path), clip_path(ray, reversed(path))) << i;
  }
}

// Ends that the doubles put beside the curve are joined to it: no ray slips through, and parts are
// as many as where the ends are on it.
TEST(CurvedPaths, EndsBesideTheirCurveLeaveNoGap) {
  for (const double off : {1 + 0x1p-52, 1 - 0x1p-53}) {
    const Vec2 from(4 * off, 3 * off), to(-3 * off, 4 * off);
    const CurvedPath slice{{turning(between({0, 0}, 5, from, to), 0), straight(to, {0, 0}, 1),
                            straight({0, 0}, from, 2)},
                           true};
    RaysOnAGrid rays;
    for (int i = 0; i < 2000; ++i) {
      Ray ray = rays.next();
      ray.direction = (i % 2 ? from : to) - ray.origin;
      const auto at_end = clip_path({i % 2 ? from : to, ray.direction}, slice, kLine);
      ASSERT_FALSE(at_end.empty());
      EXPECT_TRUE(std::any_of(at_end.begin(), at_end.end(), [](const HitInterval& hit) {
        return hit.t_enter <= 0 && 0 <= hit.t_exit;
      })) << i;
    }
  }
}

}  // namespace
}  // namespace flatray
