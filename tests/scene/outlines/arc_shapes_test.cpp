// needs: shapes/arc shapes/capsule shapes/circle shapes/ellipse shapes/sector
#include <gtest/gtest.h>

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

TEST(Shapes, ACapsuleIsTwoHalfCirclesWhateverItsLength) {
  for (const char* to : {"[10, 0]", "[1e-300, 0]", "[1e300, -1e300]"}) {
    const Shape shape =
        shape_of(std::string("capsule = { from = [0, 0], radius = 2, to = ") + to + " }");
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(arc_of(shape, i).u.norm(), 2, 1e-14) << to;
      EXPECT_NEAR(cross(arc_of(shape, i).u, arc_of(shape, i).v), 4, 1e-14) << to;
    }
  }
  EXPECT_EQ(shape_of("capsule = { from = [1, 1], to = [1, 1], radius = 2 }").circles.size(), 1U);
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
