#include <gtest/gtest.h>

#include "geom/clip.h"
#include "geom/polygon.h"
#include "oracle/families.h"
#include "trace/hit_intervals.h"

namespace flatray {
namespace {

// Points of a parabola on whole numbers, closed by its chord: convex without rounding.
std::vector<Vec2> parabola(int count) {
  std::vector<Vec2> ring;
  for (int i = 0; i < count; ++i) ring.push_back({double(i), double(i) * i});
  return ring;
}

// Directions of a circle on whole numbers by their angles: a convex ring of many exact edges, with
// edges of every direction.
std::vector<Vec2> whole_ring() {
  std::vector<Vec2> ring;
  Vec2 here(0, 0);
  const std::vector<Vec2> quarter = {{1, 0}, {5, 1}, {3, 1}, {2, 1}, {3, 2},
                                     {1, 1}, {2, 3}, {1, 2}, {1, 3}, {1, 5}};
  for (int turn = 0; turn < 4; ++turn)
    for (Vec2 step : quarter) {
      for (int k = 0; k < turn; ++k) step = Vec2(-step.y(), step.x());
      ring.push_back(here);
      here += step;
    }
  EXPECT_EQ(here, Vec2(0, 0));
  return ring;
}

// The same ring with every edge halved and every third vertex given twice.
std::vector<Vec2> with_more_vertices(const std::vector<Vec2>& ring) {
  std::vector<Vec2> more;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    more.push_back(ring[i]);
    if (i % 3 == 0) more.push_back(ring[i]);
    more.push_back(0.5 * (ring[i] + ring[(i + 1) % ring.size()]));
  }
  return more;
}

void expect_equal_answers(const std::vector<Vec2>& ring, const Ray& ray) {
  RayBatch batch;
  batch.add(ray);
  for (const Range& within : {kRay, kLine, kSegment}) {
    HitInterval hit;
    clip_convex_batch(batch, ring, within, {&hit, 1});
    ASSERT_EQ(hit, clip_convex(ray, ring, within))
        << ring.size() << " vertices, from " << ray.origin.transpose() << " along "
        << ray.direction.transpose();
  }
}

void expect_equal_answers(std::vector<Vec2> ring, std::uint64_t family) {
  ASSERT_FALSE(non_convex_vertex(ring));
  for (std::uint64_t item = 0; item < 400; ++item) {
    oracle::Draw draw(20181123, family, item);
    const auto any = [&] {
      return ring[static_cast<std::size_t>(draw.below(static_cast<int>(ring.size())))];
    };
    const Vec2 a = any(), b = any(), middle = 0.5 * (a + b);
    const Vec2 origin = any() + Vec2(draw.below(9) - 4, draw.below(9) - 4);
    expect_equal_answers(ring, {origin, a - origin});  // at a vertex
    expect_equal_answers(ring, {a, b - a});            // along an edge or a chord
    expect_equal_answers(ring, {a - 2 * (b - a), b - a});
    expect_equal_answers(ring,
                         {oracle::nudge(origin, draw), oracle::nudge(Vec2(b - origin), draw)});
    expect_equal_answers(ring, {middle, {draw.below(5) - 2, draw.below(5) - 2}});
    expect_equal_answers(ring, {origin, {draw.unit() - 0.5, draw.unit() - 0.5}});
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    if (item % 7 == 0) std::reverse(ring.begin(), ring.end());
  }
}

TEST(ConvexBatch, AnswersAsTheLoopOverAllEdges) {
  expect_equal_answers(whole_ring(), 90);
  expect_equal_answers(with_more_vertices(whole_ring()), 91);
  expect_equal_answers(parabola(100), 92);
  expect_equal_answers(with_more_vertices(parabola(40)), 93);
}

TEST(ConvexBatch, AnswersAsTheLoopAtAnyScale) {
  for (const double scale : {0x1p-1060, 0x1p900}) {
    std::vector<Vec2> ring = with_more_vertices(whole_ring());
    for (Vec2& vertex : ring) vertex *= scale;
    for (std::size_t i = 0; i < ring.size(); ++i)
      expect_equal_answers(ring, {ring[i], ring[(i + 7) % ring.size()] - ring[i]});
  }
}

TEST(ConvexBatch, WithoutAreaItIsTheSegmentOrPointItIs) {
  std::vector<Vec2> line;
  for (int i = 0; i < 40; ++i) line.push_back({double(i), 2.0 * i});
  expect_equal_answers(line, {{0, 0}, {1, 2}});
  expect_equal_answers(line, {{0, 4}, {1, 0}});
  expect_equal_answers(std::vector<Vec2>(40, Vec2(1, 1)), {{0, 0}, {1, 1}});
}

TEST(ConvexBatch, ADirectionOfZeroIsAPointTest) {
  const std::vector<Vec2> ring = whole_ring();
  expect_equal_answers(ring, {ring[3], {0, 0}});
  expect_equal_answers(ring, {{2, 5}, {0, 0}});
}

}  // namespace
}  // namespace flatray
