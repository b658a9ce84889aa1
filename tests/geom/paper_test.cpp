#include <gtest/gtest.h>

#include "geom/clip.h"
#include "geom/exact.h"

// The tables of the paper, recomputed; what it prints otherwise is listed in docs/DEVIATIONS.md.
namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

const Ring kQuad = {{20, 2}, {16, 10}, {10, 10}, {5, 5}};
const Ray kQuadRay{{1, 2}, {22, 10}};
const Ring kBox2 = {{885, 378}, {949, 378}, {949, 506}, {885, 506}};
const Ring kBox1 = {{250, 200}, {314, 200}, {314, 328}, {250, 328}};

Vec2 edge(const Ring& ring, std::size_t i) { return ring[(i + 1) % ring.size()] - ring[i]; }
Vec2 outward_normal(const Vec2& e) { return {e.y(), -e.x()}; }

struct Row {
  double numerator, denominator;
  int kind;
  double t, low, high;
};

void expect_row(const ClipStep& step, const Row& row) {
  EXPECT_EQ(step.numerator, row.numerator) << "edge " << step.edge;
  EXPECT_EQ(step.denominator, row.denominator) << "edge " << step.edge;
  EXPECT_EQ(step.kind, row.kind) << "edge " << step.edge;
  EXPECT_EQ(step.t, row.t) << "edge " << step.edge;
  if (step.candidate.kind == HitClass::miss) return;
  EXPECT_EQ(step.candidate.t_enter, row.low) << "edge " << step.edge;
  EXPECT_EQ(step.candidate.t_exit, row.high) << "edge " << step.edge;
}

TEST(PaperTables, Table2IsRightInBothBlocks) {
  EXPECT_EQ(edge(kQuad, 0), Vec2(-4, 8));
  EXPECT_EQ(outward_normal(edge(kQuad, 0)), Vec2(8, 4));
  EXPECT_EQ(outward_normal(edge(kQuad, 1)), Vec2(0, 6));
  EXPECT_EQ(outward_normal(edge(kQuad, 2)), Vec2(-5, 5));
  EXPECT_EQ(outward_normal(edge(kQuad, 3)), Vec2(-3, -15));
  double twice_area = 0;
  for (std::size_t i = 0; i < 4; ++i) twice_area += cross(kQuad[i], kQuad[(i + 1) % 4]);
  EXPECT_EQ(twice_area, 138);
  EXPECT_EQ(edge(kBox2, 0), Vec2(64, 0));
  EXPECT_EQ(edge(kBox2, 1), Vec2(0, 128));
  EXPECT_EQ(outward_normal(edge(kBox2, 0)), Vec2(0, -64));
  EXPECT_EQ(outward_normal(edge(kBox2, 3)), Vec2(-128, 0));
}

TEST(PaperTables, Table3BlockA) {
  const std::vector<ClipStep> steps = clip_steps(kQuadRay, kQuad, kSegment);
  ASSERT_EQ(steps.size(), 4u);
  expect_row(steps[0], {152, 216, 1, 19.0 / 27, 0, 19.0 / 27});
  expect_row(steps[1], {48, 60, 1, 0.8, 0, 19.0 / 27});
  expect_row(steps[2], {-5, -60, -1, 1.0 / 12, 1.0 / 12, 19.0 / 27});
  expect_row(steps[3], {-57, -216, -1, 19.0 / 72, 19.0 / 72, 19.0 / 27});
  EXPECT_EQ(steps[3].candidate, clip_convex(kQuadRay, kQuad, kSegment));
}

TEST(PaperTables, Table3BlockAInAndOutPoints) {
  const Rational enter = Rational(19) / 72, exit = Rational(19) / 27;
  EXPECT_EQ((enter * 22 + 1).text(), "245/36");
  EXPECT_EQ((enter * 10 + 2).text(), "167/36");
  EXPECT_EQ((exit * 22 + 1).text(), "445/27");
  EXPECT_EQ((exit * 10 + 2).text(), "244/27");
  const HitInterval hit = clip_convex(kQuadRay, kQuad, kSegment);
  EXPECT_EQ(hit.edge_enter, 3);
  EXPECT_EQ(hit.edge_exit, 0);
}

TEST(PaperTables, Table3BlockBStopsAtTheParallelEdgeItIsOutsideOf) {
  const Ray ray{{275, 200}, {39, 0}};
  const std::vector<ClipStep> steps = clip_steps(ray, kBox2, kSegment);
  ASSERT_EQ(steps.size(), 1u);
  expect_row(steps[0], {-11392, 0, 0, 0, 1, 0});
  EXPECT_EQ(steps[0].candidate.kind, HitClass::miss);
}

// The other rows of block b, by starting the list at each edge in turn.
TEST(PaperTables, Table3BlockBRows) {
  const Ray ray{{275, 200}, {39, 0}};
  const Ring from_1 = {kBox2[1], kBox2[2], kBox2[3], kBox2[0]};
  const std::vector<ClipStep> steps = clip_steps(ray, from_1, kLine);
  ASSERT_EQ(steps.size(), 4u);
  expect_row(steps[0], {86272, 4992, 1, 674.0 / 39, -kInfinity, 674.0 / 39});
  expect_row(steps[1], {19584, 0, 0, 0, -kInfinity, 674.0 / 39});
  expect_row(steps[2], {-78080, -4992, -1, 610.0 / 39, 610.0 / 39, 674.0 / 39});
  EXPECT_EQ(steps[3].candidate.kind, HitClass::miss);
  EXPECT_EQ(clip_steps(ray, from_1, kSegment)[2].candidate.kind, HitClass::miss);  // [610/39, 1]
}

// Table 4: pieces of the sides of the boxes.
const Segment kRaysOf1[] = {{{275, 200}, {314, 200}},
                            {{314, 225}, {314, 303}},
                            {{314, 328}, {250, 328}},
                            {{250, 303}, {250, 225}}};
const Segment kRaysOf2[] = {{{910, 378}, {949, 378}},
                            {{949, 403}, {949, 481}},
                            {{949, 506}, {885, 506}},
                            {{885, 481}, {885, 403}}};

TEST(PaperTables, Table4RaysArePiecesOfTheSides) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (const auto& [ring, rays] : {std::pair(kBox1, kRaysOf1), std::pair(kBox2, kRaysOf2)}) {
      const Vec2 e = edge(ring, i), c = rays[i].b - rays[i].a;
      EXPECT_EQ(cross(e, c), 0);
      EXPECT_GT(e.dot(c), 0);
      const HitInterval on_side = clip_convex({rays[i].a, c}, ring, kSegment);
      EXPECT_EQ(on_side.kind, HitClass::along);
      EXPECT_EQ(on_side.t_enter, 0);
      EXPECT_EQ(on_side.t_exit, 1);
    }
  }
}

// Table 5, first ray of box 1 against the pieces of box 2: a convex octagon, begun at each piece in
// turn. The paper prints the numerators -6942, 49530, 11392, -49530 and the denominators 0, 0, 0,
// 0.
TEST(PaperTables, Table5Corrected) {
  const Ray ray{{275, 200}, {39, 0}};
  const Vec2 differences[] = {{635, 178}, {674, 203}, {674, 306}, {610, 281}};
  const Row rows[] = {{-6942, 0, 0, 0, 1, 0},
                      {52572, 3042, 1, 674.0 / 39, -kInfinity, 674.0 / 39},
                      {19584, 0, 0, 0, -kInfinity, kInfinity},
                      {-47580, -3042, -1, 610.0 / 39, 610.0 / 39, kInfinity}};
  for (std::size_t i = 0; i < 4; ++i) {
    Ring octagon;
    for (std::size_t k = i; k < i + 4; ++k) {
      octagon.push_back(kRaysOf2[k % 4].a);
      octagon.push_back(kRaysOf2[k % 4].b);
    }
    EXPECT_EQ(octagon[0] - ray.origin, differences[i]);
    expect_row(clip_steps(ray, octagon, kLine)[0], rows[i]);
  }
}

TEST(PaperTables, CaseTwoAllSixteenPairsMiss) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Ray from_1{kRaysOf1[i].a, kRaysOf1[i].b - kRaysOf1[i].a};
    const Ray from_2{kRaysOf2[i].a, kRaysOf2[i].b - kRaysOf2[i].a};
    EXPECT_FALSE(clip_convex(from_1, kBox2, kSegment));
    EXPECT_FALSE(clip_convex(from_2, kBox1, kSegment));
  }
}

// The natural completion of case II (stiff case D1): box 1 moves by (635, 178), box 2 rests. They
// touch while the motion lies in the difference of the boxes.
TEST(PaperTables, CaseTwoWithAVelocityHasAHitTime) {
  const Vec2 low = kBox2[0] - kBox1[2], high = kBox2[2] - kBox1[0];
  const Ring difference = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  const HitInterval contact = clip_convex({{0, 0}, {635, 178}}, difference);
  EXPECT_EQ(contact.t_enter, 571.0 / 635);
  EXPECT_EQ(contact.t_exit, 699.0 / 635);
}

}  // namespace
}  // namespace flatray
