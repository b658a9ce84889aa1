#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/coverage/chains.h"
#include "render/coverage/strokes.h"

namespace flatray {
namespace {

double length_of(const Chain& chain) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < chain.points.size(); ++i)
    sum += (chain.points[i + 1] - chain.points[i]).norm();
  return sum;
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

// A dash of the square from every corner, its cuts on corners and between them.
TEST(Dashes, WhereAClosedChainBeginsMakesNoDifference) {
  const std::vector<std::vector<double>> patterns = {
      {8, 2}, {10, 10}, {0.7, 0.3}, {2.3, 0.1, 1.5, 0.1}};
  for (const std::vector<double>& lengths : patterns)
    for (const double offset : {0.0, 0.3, 4.0, 8.0, 9.0, -1e-16}) {
      Steps first;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        Chain square = kSquare;
        std::rotate(square.points.begin(), square.points.begin() + static_cast<int>(corner),
                    square.points.end());
        FillPath path;
        for (const Chain& dash :
             dashed(square, lengths, offset + 10.0 * static_cast<double>(corner)))
          add_line(dash, {2, LineJoin::miter, LineCap::butt}, path.edges);
        const Steps steps = stroke_steps(path);
        if (corner == 0) first = steps;
        for (std::size_t i = 0; i < steps.size(); ++i)
          ASSERT_NEAR(steps[i], first[i], 1) << lengths[0] << " " << offset << " " << corner;
      }
    }
}

TEST(Dashes, OneThatEndsWhereAClosedChainBeginsIsJoinedToTheOneThatBeginsThere) {
  const std::vector<double> lengths = {10, 5}, round = {40, 3};
  const std::vector<Chain> dashes = dashed(kSquare, lengths, 0);
  ASSERT_EQ(dashes.size(), 2U);
  EXPECT_EQ(dashes[0].points, (std::vector<Vec2>{{4, 14}, {4, 4}, {14, 4}}));
  ASSERT_EQ(dashed(kSquare, round, 0).size(), 1U);
  EXPECT_TRUE(dashed(kSquare, round, 0).front().closed);
}

TEST(Dashes, ACutBesideACornerIsAtIt) {
  for (const double off : {-1e-9, -1e-15, 0.0, 1e-15, 1e-9}) {
    const std::vector<double> ends = {10 + off, 5, 20, 1}, begins = {5, 5 + off, 3, 20};
    EXPECT_EQ(dashed(kCorner, ends, 0)[0].points, (std::vector<Vec2>{{4, 4}, {14, 4}}));
    const Chain dash = dashed(kCorner, begins, 0)[1];
    EXPECT_EQ(dash.points.front(), Vec2(14, 4)) << off;
    EXPECT_EQ(dash.points.size(), 2U) << off;
  }
}

// The ends of a dash of a circle lie on lines through its centre.
TEST(Dashes, CapsOfCurvesAreSquareToThem) {
  const std::vector<double> lengths = {3, 2.2};
  for (const Chain& dash : dashed(arc_chain({10, 10}, 6, 0.3, 4), lengths, 1)) {
    std::vector<Segment> edges;
    add_line(dash, {3, LineJoin::miter, LineCap::butt}, edges);
    const std::size_t legs = dash.points.size() - 1;
    const Segment& cap = edges[legs];
    EXPECT_NEAR((cap.b - cap.a).norm(), 6, 1e-12);
    EXPECT_NEAR(cross(cap.a - Vec2(10, 10), cap.b - Vec2(10, 10)), 0, 1e-12);
  }
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
