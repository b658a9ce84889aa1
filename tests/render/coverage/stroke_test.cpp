#include "render/coverage/stroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "full_counts.h"
#include "geom/primitives/bezier.h"
#include "render/coverage/chains.h"
#include "render/coverage/strokes.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::Draws;

TEST(Stroke, OfTheShortestLegsIsAsWideAsAll) {
  for (const double length : {1e-200, 1.6e-162, 2.4e-162, 1e-150, 1e-3}) {
    LineStyle style;
    style.half_width = 5;
    style.caps = LineCap::square;
    EXPECT_NEAR(area_of({{{0, 10}, {length, 10}}, false}, style), 50, 0.02) << length;
  }
}

constexpr double kRound = 0.033;  // a disc of radius 2 by chords: 2/3 sagitta times circumference

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

// Miters of 60 degrees are twice the width.
TEST(Strokes, MitersAtTheLimitAreKeptAtAllCornersOfATriangle) {
  for (int degrees = 0; degrees < 120; ++degrees) {
    Chain triangle{{}, true};
    for (int k = 0; k < 3; ++k) {
      const double turn = (degrees + 120 * k) * std::numbers::pi / 180;
      triangle.points.push_back(Vec2(10, 10) + 6 * Vec2(std::cos(turn), std::sin(turn)));
    }
    std::vector<Segment> at_limit, sharper;
    add_line(triangle, {1, LineJoin::miter, LineCap::butt, 2}, at_limit);
    add_line(triangle, {1, LineJoin::miter, LineCap::butt, 2.001}, sharper);
    EXPECT_EQ(at_limit.size(), sharper.size()) << degrees;
  }
}

// Points that film coordinates round to one make legs without edges: nothing is cut off without a word.
TEST(Strokes, AreWholeOrSaidNotToBe) {
  Chain dense{{{0, 0}}};
  for (int k = 1; k <= 6000; ++k) dense.points.emplace_back(k * 0x1p-18, 0);
  dense.points.emplace_back(2048, 2048);
  std::vector<Segment> some, all;
  EXPECT_FALSE(add_line(dense, {5e11, LineJoin::round, LineCap::butt}, some, 10'000));
  EXPECT_TRUE(add_line(dense, {5e11, LineJoin::round, LineCap::butt}, all, 20'000));
  EXPECT_LE(all.size(), 20'000U);
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

constexpr double kTurn = 2 * std::numbers::pi;

// A pen square to the arc covers a sector of a ring; one longer than the radius on both sides of the
// centre a sector each way.
TEST(Strokes, AWideArcIsItsSectorOfARing) {
  for (const double sweep : {0.2, 1.0, -2.5, 4.0})
    for (const double radius : {1.0, 2.0, 4.5})
      for (const double half : {0.5, 1.0, 3.0, 4.5}) {
        const double outer = radius + half, inner = radius - half;
        const double across =
            inner > 0 ? -std::abs(sweep) : std::min(std::abs(sweep), kTurn - std::abs(sweep));
        const double area = (std::abs(sweep) * outer * outer + across * inner * inner) / 2;
        const double most = std::abs(sweep) * (outer + std::abs(inner)) * kCapSagitta_px;
        EXPECT_NEAR(area_of(arc_chain({10, 10}, radius, 0.3, sweep),
                            {half, LineJoin::bevel, LineCap::butt}),
                    area, most + 1e-6)
            << sweep << " " << radius << " " << half;
      }
}

// Whether an edge ends there, within rounding.
bool has_corner(const std::vector<Segment>& edges, const Vec2& corner) {
  return std::any_of(edges.begin(), edges.end(),
                     [&](const Segment& edge) { return (edge.b - corner).norm() < 1e-12; });
}

TEST(Strokes, CapsOfCurvesAreSquareToThem) {
  std::vector<Segment> edges;
  add_line(arc_chain({4, 4}, 8, 0, kTurn / 4), {3, LineJoin::miter, LineCap::butt}, edges);
  for (const Vec2& corner : {Vec2(9, 4), Vec2(15, 4), Vec2(4, 9), Vec2(4, 15)})
    EXPECT_TRUE(has_corner(edges, corner)) << corner;
  // They set off by (3, 4) and arrive by (4, -3), also where the next control point lies on the end.
  const Bezier curves[] = {{{20, 20}, {23, 24}, {36, 27}, {40, 24}},
                           {{20, 20}, {20, 20}, {23, 24}, {40, 24}},
                           {{20, 20}, {23, 24}, {27, 16}}};
  const Vec2 last[] = {{4, -3}, {17, 0}, {4, -8}};
  for (std::size_t i = 0; i < 3; ++i) {
    edges.clear();
    add_line(chains_of({&curves[i], 1}).front(), {5, LineJoin::miter, LineCap::butt}, edges);
    const Vec2 side = 5 * Vec2(-last[i].y(), last[i].x()).normalized();
    for (const Vec2& corner :
         {Vec2(16, 23), Vec2(24, 17), Vec2(curves[i].end() + side), Vec2(curves[i].end() - side)})
      EXPECT_TRUE(has_corner(edges, corner)) << i << ": " << corner;
  }
}

TEST(Strokes, CurvesThatMeetInACornerJoinByTheirDirections) {
  const Bezier curves[] = {{{2, 4}, {6, 10}, {10, 10}}, {{10, 10}, {10, 14}, {4, 18}}};
  std::vector<Segment> edges;
  add_line(chains_of(curves).front(), {2, LineJoin::miter, LineCap::butt}, edges);
  EXPECT_TRUE(has_corner(edges, {12, 8}));
}

TEST(Strokes, AWholeTurnHasNoJointWhereItBegins) {
  for (const double from : {0.1, 0.3, 1.0, 2.0, 5.0}) {
    std::vector<Segment> edges;
    const EllipseArc arc{{100, 100}, {70, 0}, {0, 70}, from};
    add_line(chain_of({{arc}, true}), {20, LineJoin::miter, LineCap::butt}, edges);
    for (const Segment& edge : edges) EXPECT_LT((edge.a - arc.centre).norm(), 90 + 1e-5) << from;
  }
}

double distance_to(const std::vector<Segment>& edges, const Vec2& point) {
  double least = 1e9;
  for (const Segment& edge : edges) {
    const Vec2 along = edge.b - edge.a, there = point - edge.a;
    const double part = std::clamp(there.dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (there - part * along).norm());
  }
  return least;
}

// The curve moved outward by half the width, and where it is straight to both sides.
TEST(Strokes, TheOuterEdgeOfACurveIsWithinTheSagitta) {
  for (std::uint64_t item = 0; item < times(120); ++item) {
    Draws draws(17, item);
    const double half = std::exp2(-3 + 11 * draws.unit()), size = std::exp2(1 + 7 * draws.unit());
    const auto point = [&] { return Vec2(size * draws.unit(), size * draws.unit()); };
    const double near = size * std::exp2(-6 - 8 * draws.unit());  // to a cusp
    const Bezier curve =
        item % 12 == 5  ? Bezier(point(), point(), point(), std::exp2(6 * draws.unit() - 3))
        : item % 4 == 1 ? Bezier(point(), point(), point(), point())
                        : Bezier({0, 0}, {size - near, size}, {near, size}, {size, 0});
    const EllipseArc arc{point(),
                         {size, 0},
                         {0, size * (0.05 + draws.unit())},
                         5 * draws.unit(),
                         6 * draws.unit() - 3};
    const bool is_arc = item % 2 == 0;
    const Chain chain = is_arc ? chain_of({{arc}, false}) : chains_of({&curve, 1}).front();
    std::vector<Segment> edges;
    add_line(chain, {half, LineJoin::bevel, LineCap::butt}, edges);
    const auto along = [&](double s) -> Vec2 {
      const EllipseArc slope{{0, 0}, arc.v, -arc.u};
      return is_arc ? slope.at(arc.from + s * arc.sweep) : tangent_at(curve, s);
    };
    for (int i = 0; i < 50; ++i) {
      const double s = (i + draws.unit()) / 50;
      const Vec2 ahead = along(s).normalized();
      const bool left = cross(along(s - 1e-6), along(s + 1e-6)) * (is_arc ? arc.sweep : 1) < 0;
      const Vec2 out = (left ? half : -half) * Vec2(-ahead.y(), ahead.x());
      const Vec2 on = is_arc ? arc.at(arc.from + s * arc.sweep) : point_at(curve, s);
      EXPECT_LE(distance_to(edges, on + out), kCapSagitta_px) << item << " at " << s;
    }
  }
}

// y = x^2 / 10^6 for 4 10^6 px, and a hyperbola as long.
TEST(Strokes, LongCurvesHaveAsManyChordsAsTheyNeed) {
  for (const double weight : {1.0, 1.5}) {
    const Bezier curve({-2e6, 4e6}, {0, -4e6}, {2e6, 4e6}, weight);
    const Chain chain = chains_of({&curve, 1}).front();
    const std::size_t chords = chain.points.size() - 1;
    double most = 0;
    for (std::size_t i = 0; i < chords; ++i) {
      const double s = (static_cast<double>(i) + 0.5) / static_cast<double>(chords);
      const Vec2 middle = 0.5 * (chain.points[i] + chain.points[i + 1]);
      most = std::max(most, (point_at(curve, s) - middle).norm());
    }
    EXPECT_LE(most, 1.0 / 512) << weight;
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

}  // namespace
}  // namespace flatray
