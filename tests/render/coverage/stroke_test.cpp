#include "render/coverage/stroke.h"

#include <gtest/gtest.h>

#include "render/coverage/chains.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::Draws;
using Steps = std::vector<std::uint32_t>;

constexpr int kStrokeSide = 20;

Steps stroke_steps(const FillPath& path) {
  Steps steps(kStrokeSide * kStrokeSide);
  scan(path, Coverage::area, {0, 0, kStrokeSide, kStrokeSide},
       [&](int y, int x_begin, int x_end, std::uint32_t s) {
         for (int x = x_begin; x < x_end; ++x)
           steps[static_cast<std::size_t>(y * kStrokeSide + x)] = s;
       });
  return steps;
}

double area_of(const Chain& chain, const LineStyle& style) {
  FillPath path;
  add_line(chain, style, path.edges);
  double sum = 0;
  for (const std::uint32_t s : stroke_steps(path)) sum += s;
  return sum / kFullCoverage;
}

double length_of(const Chain& chain) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < chain.points.size(); ++i)
    sum += (chain.points[i + 1] - chain.points[i]).norm();
  return sum;
}

constexpr double kRound = 0.033;  // a disc of radius 2 by chords: 2/3 sagitta times circumference

const Chain kCorner{{{4, 4}, {14, 4}, {14, 14}}};
const Chain kSquare{{{4, 4}, {14, 4}, {14, 14}, {4, 14}}, true};

// Two legs of 10 and width 4 overlap in a square of 4; the join fills a quarter of the corner's.
TEST(Strokes, JoinsFillTheCornerAsTheirNamesSay) {
  EXPECT_EQ(area_of(kCorner, {2, LineJoin::bevel, LineCap::butt}), 80 - 4 + 2);
  EXPECT_EQ(area_of(kCorner, {2, LineJoin::miter, LineCap::butt}), 80 - 4 + 4);
  EXPECT_NEAR(area_of(kCorner, {2, LineJoin::round, LineCap::butt}), 80 - 4 + 3.14159, kRound);
}

TEST(Strokes, CapsEndALineAsTheirNamesSay) {
  const Chain line{{{4, 10}, {14, 10}}};
  EXPECT_EQ(area_of(line, {2, LineJoin::round, LineCap::butt}), 40);
  EXPECT_EQ(area_of(line, {2, LineJoin::round, LineCap::square}), 56);
  EXPECT_NEAR(area_of(line, {2, LineJoin::round, LineCap::round}), 40 + 4 * 3.14159, kRound);
}

TEST(Strokes, AClosedChainHasAHoleAndNoCaps) {
  for (const LineCap cap : {LineCap::butt, LineCap::round, LineCap::square})
    EXPECT_EQ(area_of(kSquare, {2, LineJoin::miter, cap}), 14 * 14 - 6 * 6);
  EXPECT_EQ(area_of(kSquare, {6, LineJoin::miter, LineCap::butt}), kStrokeSide * kStrokeSide);
}

TEST(Strokes, AMiterOverItsLimitIsABevel) {
  const Chain sharp{{{2, 10}, {12, 10}, {2, 11}}};
  std::vector<Segment> mitred, bevelled;
  add_line(sharp, {1, LineJoin::miter, LineCap::butt, 4}, mitred);
  add_line(sharp, {1, LineJoin::bevel, LineCap::butt, 4}, bevelled);
  EXPECT_EQ(mitred.size(), bevelled.size());
  EXPECT_GT(area_of(sharp, {1, LineJoin::miter, LineCap::butt, 100}),
            area_of(sharp, {1, LineJoin::bevel, LineCap::butt}) + 1);
}

// A turn whose cosine is 7/25 has a miter of 5/4 times the width: 2 = (5/4)^2 (1 + 7/25) in doubles, too.
TEST(Strokes, AMiterAtItsLimitIsKept) {
  const Chain bend{{{2, 4}, {8, 4}, {9.75, 10}}};
  const double bevel = area_of(bend, {1, LineJoin::bevel, LineCap::butt}),
               below = area_of(bend, {1, LineJoin::miter, LineCap::butt, 1.2499999}),
               limit = area_of(bend, {1, LineJoin::miter, LineCap::butt, 1.25});
  EXPECT_EQ(below, bevel);
  // A triangle: two sides of 3/4, the tangent of half the turn, and 24/25, the sine of their angle.
  EXPECT_NEAR(limit - bevel, 0.5 * 0.75 * 0.75 * 0.96, 1e-4);
}

TEST(Strokes, ADotHasItsCapsOrNothing) {
  const Chain dot{{{10, 10}, {10, 10}}};
  EXPECT_EQ(area_of(dot, {2, LineJoin::round, LineCap::butt}), 0);
  EXPECT_EQ(area_of(dot, {2, LineJoin::round, LineCap::square}), 16);
  EXPECT_NEAR(area_of(dot, {2, LineJoin::round, LineCap::round}), 4 * 3.14159, kRound);
}

// However a chain turns, short legs or long ones, its outline covers what its legs cover together.
TEST(Strokes, TheOutlineIsTheUnionOfItsLegs) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    Draws draws(11, item);
    Chain chain;
    const double reach = item % 3 == 0 ? 0.5 : 14;  // many legs shorter than the line is wide
    for (int i = 0; i < 2 + draws.below(8); ++i)
      chain.points.push_back({3 + reach * draws.unit(), 3 + reach * draws.unit()});
    chain.closed = chain.points.size() > 2 && item % 2 == 0;
    const LineStyle style{0.1 + 3 * draws.unit()};
    FillPath whole, legs;
    add_line(chain, style, whole.edges);
    const std::size_t count = chain.points.size();
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i)
      add_line({{chain.points[i], chain.points[(i + 1) % count]}}, style, legs.edges);
    const Steps a = stroke_steps(whole), b = stroke_steps(legs);
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_NEAR(a[i], b[i], kFullCoverage * 0.02) << item << " pixel " << i;  // the chords
  }
}

TEST(Strokes, LinesInTurnAreOneChain) {
  const std::vector<Segment> lines = {{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{5, 5}, {6, 6}}};
  const std::vector<Chain> chains = chained(lines);
  ASSERT_EQ(chains.size(), 2U);
  EXPECT_EQ(chains[0].points.size(), 3U);
  const std::vector<Segment> back = {{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 0}}};
  EXPECT_TRUE(chained(back).front().closed);
}

TEST(Strokes, EdgesInAnyOrderAreRings) {
  const std::vector<Segment> edges = {{{0, 0}, {4, 0}}, {{9, 9}, {8, 9}}, {{4, 4}, {0, 0}},
                                      {{8, 8}, {9, 9}}, {{4, 0}, {4, 4}}, {{8, 9}, {8, 8}}};
  const std::vector<Chain> rings = rings_of(edges);
  ASSERT_EQ(rings.size(), 2U);
  for (const Chain& ring : rings) {
    EXPECT_TRUE(ring.closed);
    EXPECT_EQ(ring.points.size(), 3U);
  }
}

TEST(Strokes, RingsThatShareACornerHaveEachEdgeOnce) {
  std::vector<Segment> edges;
  for (const double at : {0.0, 3.0})
    for (int i = 0; i < 4; ++i) {
      const auto corner = [at](int k) {
        return Vec2(at + 3 * (k % 4 / 2), at + 3 * ((k + 1) % 4 / 2));
      };
      edges.push_back({corner(i), corner(i + 1)});
    }
  std::reverse(edges.begin(), edges.end());
  double twice_area = 0;
  std::size_t count = 0;
  for (const Chain& ring : rings_of(edges)) {
    count += ring.points.size();
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      twice_area += cross(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
  }
  EXPECT_EQ(count, edges.size());
  EXPECT_EQ(std::abs(twice_area), 2 * (9 + 9));
}

TEST(Dashes, LinesAndGapsFollowOneAnotherRoundCorners) {
  const std::vector<double> lengths = {3, 1};
  const std::vector<Chain> dashes = dashed(kCorner, lengths, 0);
  ASSERT_EQ(dashes.size(), 5U);
  for (const Chain& dash : dashes) EXPECT_DOUBLE_EQ(length_of(dash), 3);
  EXPECT_EQ(dashes[2].points, (std::vector<Vec2>{{12, 4}, {14, 4}, {14, 5}}));
}

TEST(Dashes, DotsBeginWhereTheLineDoes) {
  const std::vector<double> lengths = {0, 5};
  const std::vector<Chain> dots = dashed(kCorner, lengths, 0);
  ASSERT_EQ(dots.size(), 5U);
  EXPECT_EQ(dots.front().points.front(), Vec2(4, 4));
  EXPECT_EQ(dots.back().points.back(), Vec2(14, 14));
}

TEST(Dashes, AWholePeriodOfOffsetChangesNothing) {
  const std::vector<double> lengths = {3, 1, 0, 1};
  const std::vector<Chain> here = dashed(kCorner, lengths, 1.5);
  for (const double offset : {6.5, -3.5, 51.5}) {
    const std::vector<Chain> there = dashed(kCorner, lengths, offset);
    ASSERT_EQ(here.size(), there.size()) << offset;
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i].points, there[i].points);
  }
}

TEST(Dashes, AClosedChainHasNoCutWhereItBegins) {
  const std::vector<double> lengths = {3, 1};
  const std::vector<Chain> dashes = dashed(kSquare, lengths, 1);
  ASSERT_EQ(dashes.size(), 10U);
  EXPECT_EQ(dashes[0].points, (std::vector<Vec2>{{4, 5}, {4, 4}, {6, 4}}));
  const std::vector<double> long_line = {100, 1};
  const std::vector<Chain> whole = dashed(kSquare, long_line, 0);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_TRUE(whole[0].closed);
}

TEST(Dashes, MoreThanAMillionAreAWholeLine) {
  const std::vector<double> lengths = {1e-9, 1e-9}, none = {0, 0};
  for (const auto& tiny : {lengths, none}) {
    const std::vector<Chain> dashes = dashed(kCorner, tiny, 0);
    ASSERT_EQ(dashes.size(), 1U);
    EXPECT_EQ(dashes[0].points, kCorner.points);
  }
}

}  // namespace
}  // namespace flatray
