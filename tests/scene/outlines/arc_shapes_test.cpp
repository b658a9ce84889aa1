// needs: shapes/arc shapes/capsule shapes/circle shapes/ellipse shapes/lens shapes/sector
#include <gtest/gtest.h>

#include "full_counts.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

const EllipseArc& arc_of(const Shape& shape, std::size_t i = 0) {
  return shape.arc_paths.at(0).arcs.at(i);
}

TEST(Shapes, AnEllipseKeepsItsHalfDiameters) {
  const Shape shape = shape_of("ellipse = { radii = [3, 2], centre = [1, 1], angle = 90 }");
  EXPECT_EQ(arc_of(shape).u, Vec2(0, 3));
  EXPECT_EQ(arc_of(shape).v, Vec2(-2, 0));
  EXPECT_TRUE(shape.arc_paths[0].closed);
}

TEST(Shapes, AnArcRunsCounterClockwise) {
  const Shape shape = shape_of("arc = { radius = 2, from = 270, to = 0 }");
  EXPECT_EQ(arc_of(shape).start(), Vec2(0, -2));
  EXPECT_NEAR(arc_of(shape).sweep, std::numbers::pi / 2, 1e-15);
  EXPECT_FALSE(shape.arc_paths[0].closed);
  EXPECT_TRUE(shape_of("arc = { radius = 2, from = 0, to = 9, chord = true }").arc_paths[0].closed);
  EXPECT_EQ(arc_of(shape_of("arc = { radius = 2, from = 10, to = 370 }")).sweep,
            2 * std::numbers::pi);
}

TEST(Shapes, ASectorComesBackAlongItsInnerArc) {
  const Shape shape = shape_of("sector = { radius = 4, inner = 1, from = 0, to = 90 }");
  ASSERT_EQ(shape.arc_paths[0].arcs.size(), 2U);
  EXPECT_EQ(arc_of(shape, 1).end(), Vec2(1, 0));
  const Shape pie = shape_of("sector = { radius = 4, from = 0, to = 90 }");
  EXPECT_EQ(arc_of(pie, 1).start(), Vec2(0, 0));
}

// Found by a reviewer: the doubles next to decimals 360 apart differ by a little more or less.
TEST(Shapes, AWholeTurnIsOneInAnyDecimals) {
  for (int tenths = -3600; tenths < 3600; tenths += kSanitized ? 7 : 1) {
    const auto decimal = [](int value) {
      return fmt::format("{}{}.{}", value < 0 ? "-" : "", std::abs(value) / 10,
                         std::abs(value) % 10);
    };
    const std::string arc =
        "arc = { radius = 1, from = " + decimal(tenths) + ", to = " + decimal(tenths + 3600) + " }";
    ASSERT_EQ(shape_of(arc).arc_paths[0].arcs[0].sweep, 2 * std::numbers::pi) << arc;
  }
}

TEST(Shapes, ACapsuleIsTwoHalfCirclesWhateverItsLength) {
  for (const char* to : {"[10, 0]", "[1e-300, 0]", "[5e-324, 0]", "[1e300, -1e300]"}) {
    const Shape shape =
        shape_of(std::string("capsule = { from = [0, 0], radius = 2, to = ") + to + " }");
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(arc_of(shape, i).u.norm(), 2, 1e-14) << to;
      EXPECT_NEAR(cross(arc_of(shape, i).u, arc_of(shape, i).v), 4, 1e-14) << to;
    }
  }
  EXPECT_EQ(shape_of("capsule = { from = [1, 1], to = [1, 1], radius = 2 }").circles.size(), 1U);
}

// A lens goes counter-clockwise round its axis, its vertices as far apart as it is thick.
TEST(Shapes, ALensHasTheFacesThatItsRadiiSay) {
  for (const char* radii :
       {"[3, 4]", "[-3, 4]", "[3, -4]", "[-3, -4]", "[0, 4]", "[3, 0]", "[1, 1]"}) {
    const Shape shape = shape_of(std::string("lens = { height = 2, thickness = 2.5, radii = ") +
                                 radii + ", centre = [5, 7] }");
    const auto& arcs = shape.arc_paths.at(0).arcs;
    double twice = 0;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const Vec2 a = arcs[i].start() - Vec2(5, 7), b = arcs[i].end() - Vec2(5, 7);
      twice += cross(a, b) + cross(b, Vec2(arcs[(i + 1) % arcs.size()].start() - Vec2(5, 7)));
      EXPECT_NEAR(std::fabs(a.y()), 1, 1e-15);
      const Vec2 vertex = arcs[i].at(arcs[i].from + arcs[i].sweep / 2) - Vec2(5, 7);
      if (arcs[i].u != Vec2(0, 0)) {
        EXPECT_EQ(std::fabs(vertex.x()), 1.25) << radii;
        EXPECT_EQ(vertex.y(), 0) << radii;
      }
    }
    EXPECT_GT(twice, 1) << radii;
  }
}

TEST(Shapes, CurvesThatAreNoneAreRefused) {
  const Refused cases[] = {
      {"ellipse = { radii = [1, 0] }", "4:31: error: ellipse.radii are not above 0"},
      {"ellipse = { radii = [1] }", "ellipse.radii has 1 number, not two"},
      {"arc = { radius = 1, from = 0, to = 0 }", "from 0 to 0 is not part of a turn"},
      {"arc = { radius = 1, from = 0, to = 361 }", "or to = from + 360 for a whole one"},
      {"arc = { radius = 1, from = 0, to = 1e300 }", "is not part of a turn"},
      {"arc = { radius = 0, from = 0, to = 9 }", "arc.radius is 0"},
      {"sector = { radius = 1, inner = 1, from = 0, to = 9 }", "sector.inner does not lie between"},
      {"capsule = { from = [0, 0], to = [1, 0], radius = -1 }", "capsule.radius is -1"},
      {"lens = { height = 2, thickness = 1, radii = [2, -0.9] }",
       "less than half as wide as the lens"},
      {"lens = { height = 2, thickness = 1, radii = [2, 1e7] }", "flat but for rounding"},
      {"lens = { height = 1e200, thickness = 1e199, radii = [1e200, 1e200] }",
       "cross before they come to its rim"},
      {"lens = { height = 2, thickness = 0.9, radii = [1, 0] }",
       "cross before they come to its rim"},
  };
  expect_refused(cases, [](const std::string& shape) { return refusal(with_shape(shape)); });
}

TEST(Shapes, CurvesAreWallsOfAnyKind) {
  for (const char* shape :
       {"ellipse = { radii = [2, 1] }", "capsule = { from = [0, 0], to = [1, 0], radius = 1 }",
        "sector = { radius = 1, from = 0, to = 90 }"}) {
    const std::string line = std::string("shape = { ") + shape + " }\n";
    EXPECT_EQ(refusal("flatray = 1\n[[entity]]\n" + line + "material = \"mirror\"\n"), "");
    EXPECT_EQ(refusal("flatray = 1\n[[chamber]]\n" + line + "[[chamber.pillars]]\n" + line), "");
  }
}

}  // namespace
}  // namespace flatray
