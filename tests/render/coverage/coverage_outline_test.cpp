#include <gtest/gtest.h>

#include "geom/outline.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

bool same(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Segment& p, const Segment& q) { return p.a == q.a && p.b == q.b; });
}

std::vector<Segment> cancel_edges(const std::vector<Segment>& edges) {
  std::vector<Vec2> points;
  std::vector<std::uint32_t> ends;
  for (const Segment& edge : edges) points.push_back(edge.a);
  for (const Segment& edge : edges) {
    ends.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(edge.b);
  }
  std::vector<Segment> left;
  for (const std::uint32_t i : outline_edges(points, ends)) left.push_back(edges[i]);
  return left;
}

TEST(Outline, OppositeEdgesCancelAndTheRestKeepsItsOrder) {
  const Segment ab{{0, 0}, {1, 0}}, ba{{1, 0}, {0, 0}}, bc{{1, 0}, {1, 1}}, point{{3, 3}, {3, 3}};
  EXPECT_TRUE(same(cancel_edges({ab, bc, ba}), {bc}));
  EXPECT_TRUE(same(cancel_edges({ab, ab, ba, bc}), {ab, bc}));
  EXPECT_TRUE(same(cancel_edges({ab, ab}), {ab, ab})) << "copies in one direction stay";
  EXPECT_TRUE(same(cancel_edges({ab, bc, ab, ab, ba, ba}), {ab, bc}));
  EXPECT_TRUE(same(cancel_edges({ab, ab, ba, ba, ba, bc}), {ba, bc}));
  EXPECT_TRUE(same(cancel_edges({point, bc}), {bc}));
  EXPECT_TRUE(cancel_edges({}).empty());
}

TEST(Outline, AGridOfTrianglesIsItsBorderAndCoversTheSame) {
  constexpr int kSide = 8;
  FillPath mesh;
  mesh.rule = FillRule::nonzero;
  const auto at = [](int i, int k) { return Vec2(0.3 + 1.03 * i + 0.1 * k, 0.2 + 0.97 * k); };
  for (int i = 0; i < kSide; ++i)
    for (int k = 0; k < kSide; ++k) {
      coverage_check::add_ring({at(i, k), at(i + 1, k), at(i, k + 1)}, false, mesh);
      coverage_check::add_ring({at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}, false, mesh);
    }
  FillPath outline = mesh;
  outline.edges = cancel_edges(mesh.edges);
  EXPECT_EQ(outline.edges.size(), 4U * kSide);
  EXPECT_EQ(steps_of(outline, {0, 0, 10, 9}), steps_of(mesh, {0, 0, 10, 9}));
}

}  // namespace
}  // namespace flatray
