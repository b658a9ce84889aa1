// needs: shapes/arc shapes/box shapes/capsule shapes/circle shapes/convex shapes/ellipse shapes/import shapes/ngon
#include "scene/keys/changing_shape.h"

#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string entity(const std::string& shape, const std::string& keys = "") {
  return "flatray = 1\nframes = 5\nfps = 1\n" + with_shape(shape).substr(12) + keys + "\n";
}

// Of the first entity at a time.
Shape at_time(const Scene& scene, double time) {
  const Shape& shape = scene.shapes[scene.entities[0].shape];
  return shape_at(scene, scene.changing_shapes.at(shape.changes), time);
}

TEST(ChangingShapes, HaveTheirNumbersAtEachTime) {
  const Scene disc =
      loaded(entity("circle = { radius = { keys = [[0, 1], [2, 5]] }, centre = [3, 4] }")).scene;
  EXPECT_EQ(at_time(disc, 0).circles[0].radius, 1);
  EXPECT_EQ(at_time(disc, 1).circles[0].radius, 3);
  EXPECT_EQ(at_time(disc, 9).circles[0].radius, 5);
  EXPECT_EQ(at_time(disc, 1).circles[0].centre, Vec2(3, 4));

  const Scene box =
      loaded(entity("box = { min = [0, 0], max = { keys = [[0, [1, 2]], [2, [5, 4]]] } }")).scene;
  EXPECT_EQ(at_time(box, 1).vertices[2], Vec2(3, 3));
  const Scene high =
      loaded(entity("box = { min = [0, 0], max = [7, { keys = [[0, 2], [2, 4]] }] }")).scene;
  EXPECT_EQ(at_time(high, 0.5).vertices[2], Vec2(7, 2.5));

  const Scene oval = loaded(entity("ellipse = { radii = [{ keys = [[0, 2], [1, 4]] }, 1], angle = "
                                   "{ keys = [[0, 0], [1, 90]] } }"))
                         .scene;
  EXPECT_EQ(at_time(oval, 1).arc_paths[0].arcs[0].u, Vec2(0, 4));

  const Scene arc =
      loaded(entity("arc = { radius = 2, from = 0, to = { keys = [[0, 90], [2, 270]] } }")).scene;
  EXPECT_EQ(at_time(arc, 1).arc_paths[0].arcs[0].sweep, 0x1.921fb54442d18p+1);

  const Scene square =
      loaded(entity("ngon = { sides = 4, radius = { keys = [[0, 1], [1, 2]] } }")).scene;
  EXPECT_EQ(at_time(square, 0.5).vertices[0], Vec2(0, 1.5));

  const Scene bent = loaded(entity("convex = { points = [[0, 0], [4, 0], [{ keys = [[0, 1], [1, "
                                   "3]] }, 2]] }"))
                         .scene;
  EXPECT_EQ(at_time(bent, 0.5).vertices[2], Vec2(2, 2));
}

TEST(ChangingShapes, AreTheShapesWrittenWithTheirValues) {
  const std::string values[] = {"2", "{ keys = [[0, 1], [2, 3]], ease = \"smooth\" }"};
  const auto shapes = [&](const std::string& v) {
    return std::vector<std::string>{
        "capsule = { from = [0, 0], to = [5, 1], radius = " + v + " }",
        "star = { points = 5, outer = 4, inner = " + v + " }",
        "sector = { radius = 4, from = 10, to = 200, inner = " + v + " }",
        "mushroom = { radius = 3, width = " + v + ", height = 2 }",
        "polygon = { points = [[0, 0], [4, 0], [4, 4], [" + v + ", 1]], fill_rule = \"even-odd\" }",
        "polyline = { points = [[0, 0], [" + v + ", 1], [9, 9]], closed = true }",
        "text = { string = \"go\", size = " + v + ", align = \"centre\" }",
        "penrose = { size = " + v + " }",
        "tokarsky = { size = " + v + ", at = [1, 2] }",
        "segment = { from = [0, 0], to = [" + v + ", 7] }"};
  };
  const std::vector<std::string> fixed = shapes(values[0]), changing = shapes(values[1]);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const Scene scene = loaded(entity(fixed[i])).scene;
    const Shape &want = scene.shapes[0], got = at_time(loaded(entity(changing[i])).scene, 1);
    EXPECT_EQ(got.vertices, want.vertices) << fixed[i];
    EXPECT_EQ(got.begin, want.begin) << fixed[i];
    EXPECT_EQ(got.edges, want.edges) << fixed[i];
    ASSERT_EQ(got.segments.size(), want.segments.size()) << fixed[i];
    ASSERT_EQ(got.arc_paths.size(), want.arc_paths.size()) << fixed[i];
    for (std::size_t j = 0; j < want.segments.size(); ++j)
      EXPECT_TRUE(got.segments[j].a == want.segments[j].a &&
                  got.segments[j].b == want.segments[j].b);
    for (std::size_t j = 0; j < want.arc_paths.size(); ++j)
      for (std::size_t k = 0; k < want.arc_paths[j].arcs.size(); ++k)
        EXPECT_TRUE(got.arc_paths[j].arcs[k].u == want.arc_paths[j].arcs[k].u &&
                    got.arc_paths[j].arcs[k].centre == want.arc_paths[j].arcs[k].centre);
  }
}

// Found by a reviewer: one number alone, right at both keys; the walls were gone in between.
TEST(ChangingShapes, AreRefusedWhereOneNumberAloneIsWrongBetweenItsKeys) {
  for (const char* shape :
       {"lens = { height = 4, thickness = 3, radii = [{ keys = [[0, 5], [8, 0]] }, 5] }",
        "cell = { a = [1, 0], b = [{ keys = [[0, 0.05], [2, 0.95]] }, 0.3], sides = 6 }",
        "conic = { vertex = [0, 0], focus = [{ keys = [[0, -5], [2, 5]] }, 0.1], width = 4, "
        "eccentricity = 0 }"}) {
    const std::string refused = refusal(entity(shape));
    EXPECT_NE(refused.find(" s\n"), std::string::npos) << shape << refused;
  }
}

TEST(ChangingShapes, AreNotThereWhereNothingOfThemIsLeft) {
  const std::string shapes[] = {
      "ngon = { sides = 5, radius = { keys = [[0, 0], [2, 1]] } }",
      "capsule = { from = [0, 0], to = [1, 0], radius = { keys = [[0, 0], [2, 1]] } }",
      "box = { min = [0, 0], max = { keys = [[0, [0, 3]], [2, [3, 3]]] } }",
      "arc = { radius = 1, from = 0, to = { keys = [[0, 0], [2, 360]] } }",
      "sector = { radius = 2, from = 0, to = 90, inner = { keys = [[0, 2], [2, 0]] } }",
      "ellipse = { radii = [{ keys = [[0, 0], [2, 1]] }, 1] }",
      "text = { string = \"grow\", size = { keys = [[0, 0], [2, 1]] } }"};
  for (const std::string& shape : shapes) {
    const Scene scene = loaded(entity(shape)).scene;
    const Shape none = at_time(scene, 0), some = at_time(scene, 1);
    EXPECT_TRUE(none.vertices.empty() && none.arc_paths.empty()) << shape;
    EXPECT_FALSE(some.vertices.empty() && some.arc_paths.empty()) << shape;
    EXPECT_EQ(scene.entities[0].fill.has_value(), shape.find("arc") != 0) << shape;
  }
}

TEST(ChangingShapes, AreSharedByCopiesUnlessTheyAreDrawn) {
  const std::string ring = "repeat = { ring = { count = 9, radius = 50 } }";
  EXPECT_EQ(loaded(entity("circle = { radius = { keys = [[0, 1], [2, 3]] } }", ring))
                .scene.changing_shapes.size(),
            1u);
  const Scene drawn =
      loaded(entity("circle = { radius = { keys = [[0, 1], [2, { uniform = [3, 9] }]] } }", ring))
          .scene;
  ASSERT_EQ(drawn.changing_shapes.size(), 9u);
  EXPECT_NE(shape_at(drawn, drawn.changing_shapes[0], 2).circles[0].radius,
            shape_at(drawn, drawn.changing_shapes[8], 2).circles[0].radius);
}

TEST(ChangingShapes, MistakesAreToldWithTheTimeAndWhatToWrite) {
  const std::string two_paces =
      "box = { min = [{ keys = [[0, 0], [4, 10]], ease = \"smooth\" }, 0], max = [{ keys = [[0, "
      "0.5], [4, 10.5]] }, 1] }";
  const std::string far = "{ keys = [[0, 0], [2, 1e17]] }";
  const Refused cases[] = {
      {entity("circle = { radius = { keys = [[0, 1], [2, -1]] } }"), "radius of -1 at 2 s"},
      {entity("ngon = { sides = 5, radius = { keys = [[0, 1], [2, -1]] } }"),
       "ngon.radius goes below 0"},
      {entity("box = { min = [0, 0], max = [{ keys = [[0, 1], [3, -1]] }, 1] }"),
       "box has no area at 3 s"},
      {entity(two_paces), "box has no area at 3 s"},  // right at both ends
      {entity("sector = { radius = { keys = [[0, 0], [2, 10]] }, from = 0, to = 90, inner = 5.5 }"),
       "sector.inner does not lie between 0 and the radius at 1 s"},  // not there at 0 s
      {entity("mushroom = { radius = { keys = [[0, 0], [4, 3]] }, width = 2, height = 1 }"),
       "the stem is as wide as the cap at 1 s"},
      {entity("ngon = { sides = 5, radius = 1, centre = [" + far + ", 0] }"),
       "the sides of the ngon are lost in rounding at 2 s"},
      {entity("star = { points = 5, outer = 2, inner = 1, centre = [" + far + ", 0] }"),
       "the points of the star are lost in rounding at 2 s"},
      {entity("tokarsky = { size = 1, at = [" + far + ", 0] }"),
       "the corners of the room are lost in rounding at 2 s"},
      {entity("text = { string = \"far\", size = { keys = [[0, 0], [2, 1e-323]] } }"),
       "letters of this size are lost in rounding at 2 s"},
      {"flatray = 1\nfps = 1\n" + with_shape(two_paces).substr(12),
       "box has no area at 3 s"},  // frames = 1, and the fourth may be asked for
      {entity("polygon = { points = [[0, 0], [2, 0], [2, 2], [{ keys = [[0, 0], [2, 5]] }, 1]] }"),
       "cross at 2 s"},
      {entity("ngon = { sides = { keys = [[0, 3], [1, 9]] }, radius = 1 }"),
       "ngon.sides cannot change with time"},
      {entity("import = { file = \"a.obj\", scale = { keys = [[0, 1]] } }"),
       "import.scale cannot change with time"},
      {entity("circle = { radius = { keys = [[1, 1], [0, 2]] } }"),
       "not later than the key before"},
      {"flatray = 1\n[[chamber]]\nshape = { circle = { radius = { keys = [[0, 1]] } } }",
       "circle.radius cannot change with time"},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

TEST(ChangingShapes, WorkOfCheckingThemIsBounded) {
  LoadLimits limits;
  limits.max_corners = 1000;
  const std::string text =
      "flatray = 1\nframes = 9999999\n" +
      with_shape(
          "box = { min = [{ keys = [[0, 0], [99999, 1]] }, 0], max = [{ keys = [[0, 2], "
          "[99999, 3]] }, 1] }")
          .substr(12);
  const auto result = load_scene_text("t.toml", text, {}, limits);
  ASSERT_FALSE(result);
  EXPECT_NE(format(result.error()).find("--max-corners"), std::string::npos);
}

TEST(ChangingShapes, WorkOfCheckingThemIsBoundedWhereTheyAreNotThere) {
  LoadLimits limits;
  limits.max_corners = 1000;
  const std::string none = "{ keys = [[0, 0], [1e9, 0]] }",
                    turning = "{ keys = [[0, 0], [1e9, 1]] }";
  const std::string shapes[] = {
      "ngon = { sides = 10000, radius = " + none + ", angle = " + turning + " }",
      "star = { points = 1000, outer = " + none + ", inner = 1, angle = " + turning + " }",
      "tokarsky = { size = " + none + ", at = [" + turning + ", 0] }"};
  for (const std::string& shape : shapes) {
    const auto result = load_scene_text(
        "t.toml", "flatray = 1\nframes = 9999999\nfps = 1\n" + with_shape(shape).substr(12), {},
        limits);
    ASSERT_FALSE(result) << shape;
    EXPECT_NE(format(result.error()).find("--max-corners"), std::string::npos) << shape;
  }
}

TEST(ChangingColours, AreKeptAsPremultipliedLight) {
  const Scene scene =
      loaded(entity("circle = { radius = 1 }",
                    "fill = { keys = [[0, \"#ff000000\"], [1, \"#ffffff\"]] }\n"
                    "stroke = { width = 1, colour = { keys = [[0, \"#102030\"]] } }"))
          .scene;
  ASSERT_EQ(scene.curves.size(), 8u);
  EXPECT_EQ(scene.entities[0].fill->curve, 0u);
  EXPECT_EQ(scene.curves[0].values, (std::vector<double>{0, 1}));  // unseen red is no light
  EXPECT_EQ(scene.curves[3].values, (std::vector<double>{0, 1}));
  EXPECT_EQ(scene.entities[0].stroke->colour.curve, 4u);
}

TEST(ChangingColours, RefusalsSayWhatCanChange) {
  const std::string curve = "{ keys = [[0, \"#000000\"]] }";
  const Refused cases[] = {
      {entity("circle = { radius = 1 }", "fill = { keys = [[0, 1]] }"),
       "entity.fill.keys[0][1] is a number, not a string"},
      {entity("circle = { radius = 1 }",
              "fill = { linear = { from = [0, 0], to = [1, 0], stops = [" + curve +
                  ", \"#ffffff\"] } }"),
       "linear.stops[0] cannot change with time"},
      {"flatray = 1\nfilm = { background = " + curve + " }",
       "film.background cannot change with time"},
      {"flatray = 1\n[[chamber]]\nshape = { circle = { radius = 1 } }\nfill = " + curve,
       "chamber.fill cannot change with time"},
      {entity("circle = { radius = 1 }", "velocity = { keys = [[0, [1, 0]]] }"),
       "write at = { keys = [[t, [x, y]], ...] }"},
      {entity("circle = { radius = 1 }", "layer = { keys = [[0, 1]] }"),
       "entity.layer cannot change with time"},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

}  // namespace
}  // namespace flatray
