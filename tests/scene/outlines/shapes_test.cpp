// needs: shapes/bezier shapes/circle shapes/conic shapes/convex shapes/import shapes/parabola shapes/polygon shapes/segment
#include <gtest/gtest.h>

#include "scene/outlines/ring.h"
#include "scene/scene_text.h"
#include "scene/shape.h"

namespace flatray {
namespace {

std::string refused(const std::string& shape) { return refusal(with_shape(shape)); }

std::vector<Vec2> piece(const Shape& shape, std::size_t i) {
  return {shape.vertices.begin() + shape.begin[i], shape.vertices.begin() + shape.begin[i + 1]};
}

// Twice the area of all pieces; exact for the small integers used here.
double double_area(const Shape& shape) {
  double sum = 0;
  for (std::size_t i = 0; i < shape.piece_count(); ++i) {
    const std::vector<Vec2> ring = piece(shape, i);
    for (std::size_t k = 0; k < ring.size(); ++k)
      sum += cross(ring[k], ring[(k + 1) % ring.size()]);
  }
  return sum;
}

// Each edge of a piece with a number lies on the edge of that number of the ring.
void expect_edges_of(const Shape& shape, const std::vector<Vec2>& ring) {
  ASSERT_EQ(shape.edges.size(), shape.vertices.size());
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    for (std::size_t k = shape.begin[i]; k < shape.begin[i + 1]; ++k) {
      if (shape.edges[k] < 0) continue;
      const auto edge = static_cast<std::size_t>(shape.edges[k]);
      const Vec2 &from = ring[edge], &to = ring[(edge + 1) % ring.size()];
      const std::size_t next = k + 1 < shape.begin[i + 1] ? k + 1 : shape.begin[i];
      EXPECT_EQ(orientation(from, to, shape.vertices[k]), Sign::zero) << k;
      EXPECT_EQ(orientation(from, to, shape.vertices[next]), Sign::zero) << k;
    }
}

TEST(Shapes, ABoxIsFourCornersCounterClockwise) {
  const Shape shape = shape_of("box = { min = [1, 2], max = [3, 5] }");
  EXPECT_EQ(shape.vertices, (std::vector<Vec2>{{1, 2}, {3, 2}, {3, 5}, {1, 5}}));
  EXPECT_EQ(shape.begin, (std::vector<std::uint32_t>{0, 4}));
  EXPECT_EQ(shape.edges, (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(Shapes, ABoxWithoutAreaIsRefused) {
  EXPECT_NE(refused("box = { min = [0, 0], max = [0, 1] }").find("box has no area"),
            std::string::npos);
  EXPECT_NE(
      refused("box = { min = [1, 1], max = [0, 0] }").find("min must lie below and left of max"),
      std::string::npos);
}

TEST(StiffCases, B13CirclesOfEveryRadiusButNegativeOnes) {
  EXPECT_EQ(shape_of("circle = { radius = 0 }").circles.at(0).radius, 0);
  EXPECT_EQ(shape_of("circle = { radius = 5e-324 }").circles.at(0).radius, 5e-324);
  EXPECT_EQ(shape_of("circle = { radius = 1e308, centre = [1, 2] }").circles.at(0).radius, 1e308);
  EXPECT_NE(refused("circle = { radius = -1 }").find("4:31: error: circle has a radius of -1"),
            std::string::npos);
  EXPECT_NE(refused("circle = { radius = -5e-324 }").find("circle has a radius of -5e-324"),
            std::string::npos);
}

TEST(Shapes, ClockwiseConvexIsTurnedAndKeepsItsEdgeNumbers) {
  const std::vector<Vec2> ring = {{0, 0}, {0, 2}, {3, 2}, {3, 0}};
  const Shape shape = shape_of("convex = { points = [[0, 0], [0, 2], [3, 2], [3, 0]] }");
  ASSERT_EQ(shape.piece_count(), 1u);
  EXPECT_EQ(double_area(shape), 12);
  expect_edges_of(shape, ring);
  EXPECT_EQ(shape.edges.size(), 4u);
}

TEST(Shapes, ConvexPassesOverRepeatedAndCollinearVertices) {
  const Shape shape = shape_of(
      "convex = { points = [[0, 0], [0, 0], [1, 0], [2, 0], [2, 2], [2, 2], [0, 2], [0, 1]] }");
  ASSERT_EQ(shape.piece_count(), 1u);
  EXPECT_EQ(shape.vertices.size(), 4u);
  EXPECT_EQ(double_area(shape), 8);
  // Edge 0 has no length; 1 and 2 make the bottom, 6 and 7 the left side.
  std::vector<std::int32_t> edges = shape.edges;
  std::sort(edges.begin(), edges.end());
  EXPECT_EQ(edges, (std::vector<std::int32_t>{1, 3, 5, 6}));
}

TEST(Shapes, WhatIsNotConvexIsRefusedNamingTheVertex) {
  const std::string shown = refused("convex = { points = [[0, 0], [4, 0], [1, 1], [0, 4]] }");
  EXPECT_NE(shown.find("4:48: error: not convex at vertex 2, (1, 1)"), std::string::npos) << shown;
  EXPECT_NE(shown.find("polygon = "), std::string::npos);
}

TEST(Shapes, ASimplePolygonIsCutIntoConvexPieces) {
  const std::vector<Vec2> ring = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  const Shape shape = shape_of("polygon = { points = [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]] }");
  EXPECT_GE(shape.piece_count(), 2u);
  EXPECT_EQ(double_area(shape), 20);
  expect_edges_of(shape, ring);
  std::vector<std::int32_t> edges = shape.edges;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  EXPECT_EQ(edges, (std::vector<std::int32_t>{-1, 0, 1, 2, 3, 4}));
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    EXPECT_FALSE(non_convex_vertex(piece(shape, i)));
}

constexpr const char* kBowTie = "points = [[0, 0], [1, 1], [1, 0], [0, 1]]";

TEST(StiffCases, B10ABowTieIsRefusedNamingItsCrossingEdges) {
  const std::string shown = refused(std::string("polygon = { ") + kBowTie + " }");
  EXPECT_NE(shown.find("4:33: error: edges 0 and 2 of the polygon cross"), std::string::npos)
      << shown;
  EXPECT_NE(shown.find("fill_rule = \"even-odd\""), std::string::npos);
  EXPECT_NE(refused(std::string("convex = { ") + kBowTie + " }").find("not convex at vertex"),
            std::string::npos);
}

TEST(StiffCases, B10ABowTieIsDrawnByEvenOdd) {
  const Shape shape =
      shape_of(std::string("polygon = { ") + kBowTie + ", fill_rule = \"even-odd\" }");
  EXPECT_EQ(shape.piece_count(), 0u);
  ASSERT_EQ(shape.crossing_rings.size(), 1u);
  EXPECT_EQ(shape.crossing_rings[0], (std::vector<Vec2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
}

TEST(StiffCases, B10ABowTieIsNoChamber) {
  const std::string shown =
      refusal(std::string("flatray = 1\n[[chamber]]\nshape = { polygon = { ") + kBowTie +
              ", fill_rule = \"even-odd\" } }");
  EXPECT_NE(shown.find("3:9: error: the walls of the chamber cross"), std::string::npos) << shown;
}

TEST(Shapes, EvenOddOfASimplePolygonIsThePolygon) {
  const Shape shape =
      shape_of("polygon = { points = [[0, 0], [2, 0], [0, 2]], fill_rule = \"even-odd\" }");
  EXPECT_TRUE(shape.crossing_rings.empty());
  EXPECT_EQ(double_area(shape), 4);
}

TEST(StiffCases, B9WithoutAreaItIsASegmentOrAPoint) {
  for (const char* kind : {"convex", "polygon"}) {
    const std::string start = std::string(kind) + " = { points = ";
    const LoadedScene line = loaded(with_shape(start + "[[1, 1], [3, 3], [2, 2]] }"));
    ASSERT_EQ(line.scene.shapes[0].segments.size(), 1u);
    EXPECT_EQ(line.scene.shapes[0].segments[0].a, Vec2(1, 1));
    EXPECT_EQ(line.scene.shapes[0].segments[0].b, Vec2(3, 3));
    ASSERT_EQ(line.warnings.size(), 1u);
    EXPECT_EQ(line.warnings[0].message, std::string(kind) + " has no area");
    const Shape point = shape_of(start + "[[1, 2], [1, 2]] }");
    ASSERT_EQ(point.circles.size(), 1u);
    EXPECT_EQ(point.circles[0].centre, Vec2(1, 2));
    EXPECT_EQ(point.circles[0].radius, 0);
  }
}

TEST(StiffCases, A5IntegersThatNoDoubleHoldsAreWarnedOf) {
  const LoadedScene got =
      loaded(with_shape("segment = { from = [9007199254740992, 0], to = [9007199254740993, 0] }"));
  ASSERT_EQ(got.warnings.size(), 2u);
  EXPECT_EQ(got.warnings[1].message, "9007199254740993 reads as 9007199254740992");
  EXPECT_EQ(got.warnings[0].message,
            "(9007199254740992, 0) and (9007199254740993, 0) read as the same point");
  EXPECT_EQ(got.scene.shapes[0].circles.size(), 1u);  // the point it has become
}

// Found by a reviewer: 16 is 0x10.
TEST(Shapes, PointsThatAreOneInOtherDigitsAreNotWarnedOf) {
  EXPECT_TRUE(loaded(with_shape("polyline = { points = [[0x10, 0], [16, 0], [1.6e1, 9]] }"))
                  .warnings.empty());
}

TEST(StiffCases, A5CornersThatReadAsOneAreWarnedOfAndLeaveASegment) {
  const LoadedScene got =
      loaded(with_shape("polygon = { points = [[1e16, 0], [10000000000000001.0, 0], [1e16, 4]] }"));
  bool told = false;
  for (const Diagnostic& warning : got.warnings)
    told =
        told || warning.message == "(1e16, 0) and (10000000000000001.0, 0) read as the same point";
  EXPECT_TRUE(told) << format(got.warnings, "warning");
  const Shape& shape = got.scene.shapes[0];
  EXPECT_EQ(shape.piece_count(), 0u);
  ASSERT_EQ(shape.segments.size(), 1u);
  EXPECT_EQ(shape.segments[0].b, Vec2(1e16, 4));
}

TEST(StiffCases, A5ABoxSoWrittenHasNoArea) {
  EXPECT_NE(refusal(with_shape("box = { min = [1e16, 0], max = [10000000000000001, 1] }"))
                .find("t.toml:4:17: error: box has no area"),
            std::string::npos);
}

TEST(Shapes, VerticesWrittenAlikeAreNotWarnedOf) {
  EXPECT_TRUE(loaded(with_shape("polygon = { points = [[0, 0], [1, 0], [1.0, 0e5], [0, 1]] }"))
                  .warnings.empty());
}

// With the focus f ahead of the vertex (1 - e^2) x^2 - 2 f (1 + e) x + y^2 = 0.
TEST(Shapes, AConicIsWhatItsEccentricitySays) {
  const Bezier plain =
      shape_of("conic = { vertex = [0, 0], focus = [1, 0], width = 6, eccentricity = 2 }")
          .beziers.at(0);
  EXPECT_EQ(plain.start(), Vec2(1, -3));
  EXPECT_EQ(plain.point(1), Vec2(-0.5, 0));
  EXPECT_EQ(plain.end(), Vec2(1, 3));
  EXPECT_EQ(plain.weight, 2);
  EXPECT_EQ(
      shape_of("conic = { vertex = [3, 1], focus = [3, 2], width = 5 }").beziers.at(0).points,
      shape_of("parabola = { vertex = [3, 1], focus = [3, 2], width = 5 }").beziers.at(0).points);
  for (const double e : {0.0, 0.3, 0.9, 1.0, 1.5, 20.0}) {
    const Bezier curve =
        shape_of("conic = { vertex = [0, 0], focus = [2, 0], width = 3.5, eccentricity = " +
                 std::to_string(e) + " }")
            .beziers.at(0);
    for (const double s : {0.0, 0.1, 0.4, 0.5, 1.0}) {
      const Vec2 p = point_at(curve, s);
      EXPECT_NEAR((1 - e * e) * p.x() * p.x() - 4 * (1 + e) * p.x() + p.y() * p.y(), 0, 1e-12) << e;
    }
  }
  EXPECT_NE(refused("conic = { vertex = [0, 0], focus = [1, 0], width = 4, eccentricity = 0.6 }")
                .find("the conic is as wide as the whole ellipse"),
            std::string::npos);  // which is 4 wide
  EXPECT_NE(refused("conic = { vertex = [0, 0], focus = [0, 0], width = 1, eccentricity = 0.5 }")
                .find("the conic is too flat, or its focus is its vertex"),
            std::string::npos);
  EXPECT_NE(refused("conic = { vertex = [0, 0], focus = [1, 0], width = 1, eccentricity = -1 }")
                .find("the eccentricity is below 0"),
            std::string::npos);
}

TEST(Shapes, OfLinesInAStateAreWarnedOfWhereNothingDrawsThem) {
  const auto warnings = [](const std::string& keys, const std::string& look) {
    return loaded(
               with_shape("circle = { radius = 1 }") + keys +
               "\nmarkov = { chain = 'c' }\nstates = { A = { shape = { segment = { from = [0, 0], "
               "to = [1, 0] } }" +
               look + " } }\n[markov.c]\nA = { A = 1 }\n")
        .warnings;
  };
  const Diagnostics told = warnings("", "");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message, "a state's shape of lines has no inside to fill");
  EXPECT_TRUE(warnings("", ", stroke = { width_px = 1 }").empty());
  EXPECT_TRUE(warnings("\nstroke = { width_px = 1 }", "").empty());
  EXPECT_TRUE(warnings("\nstroke = 'none'", "").empty());
  EXPECT_TRUE(warnings("\nmaterial = 'mirror'", "").empty());
}

TEST(Shapes, OfLinesThatAreFilledAreWarnedOfOnce) {
  const auto warnings = [](const std::string& shape) {
    return loaded(with_shape(shape) +
                  "\nfill = '#ff0000'\nrepeat = { ring = { count = 3, "
                  "radius = 9 } }\n")
        .warnings;
  };
  const Diagnostics told = warnings("segment = { from = [0, 0], to = [1, 0] }");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message, "a shape of lines has no inside to fill");
  EXPECT_EQ(warnings("bezier = { points = [[0, 0], [1, 1], [2, 1], [3, 0]] }").size(), 1U);
  EXPECT_TRUE(warnings("circle = { radius = 1 }").empty());
}

TEST(Shapes, ArgumentsOfTheWrongKindAreTold) {
  EXPECT_NE(refused("box = 3").find("4:17: error: box is a number, not a table"),
            std::string::npos);
  EXPECT_NE(refused("box = { min = [0, 0] }").find("4:17: error: box needs 'max'"),
            std::string::npos);
  EXPECT_NE(refused("convex = { points = [] }").find("convex.points is empty"), std::string::npos);
  EXPECT_NE(refused("convex = { points = [[0, 0], [1]] }").find("convex.points[1] has 1 number"),
            std::string::npos);
  EXPECT_NE(refused("convex = { points = [[0, \"0\"]] }").find("convex.points[0][1] is a string"),
            std::string::npos);
  EXPECT_NE(refused("polygon = { points = [[0, 0]], fill_rule = \"evenodd\" }")
                .find("(did you mean 'even-odd'?)"),
            std::string::npos);
}

TEST(Shapes, EveryKindIsListedWithWhatItTakes) {
  std::vector<std::string> names;
  for (const ShapeType* shape : shape_types()) {
    names.emplace_back(shape->name);
    EXPECT_NE(usage(*shape).find(" = "), std::string::npos);
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"box", "circle", "convex", "import", "polygon", "segment"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  const auto box = std::find(names.begin(), names.end(), "box") - names.begin();
  EXPECT_EQ(usage(*shape_types()[static_cast<std::size_t>(box)]),
            "min = [x, y] or a curve, max = [x, y] or a curve");
}

TEST(Rings, CleaningKeepsTheLowestNumberOfAStraightRun) {
  const std::vector<Vec2> ring = {{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}};
  const CleanRing clean = clean_ring(ring);  // vertex 0 lies between 4 and 1
  EXPECT_EQ(clean.vertices, (std::vector<Vec2>{{2, 0}, {2, 2}, {0, 2}, {0, 0}}));
  EXPECT_EQ(clean.edges, (std::vector<std::int32_t>{1, 2, 3, 0}));
}

}  // namespace
}  // namespace flatray
