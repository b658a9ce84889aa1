// needs: shapes/circle
#include "scene/curve.h"
#include "scene/reading/reader.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string body(const std::string& keys) {
  return "flatray = 1\n[[entity]]\nname = \"e\"\nshape = { circle = { radius = 1 } }\n" + keys +
         "\n";
}

TEST(Curves, StandForAPointOrForOneOfItsNumbers) {
  const Scene both = loaded(body("at = { keys = [[0, [1, 2]], [1.5, [3, 4]]] }")).scene;
  ASSERT_EQ(both.curves.size(), 2u);
  EXPECT_EQ(both.curves[*both.entities[0].motion.y].values, (std::vector<double>{2, 4}));
  EXPECT_EQ(both.curves[*both.entities[0].motion.x].times, (std::vector<double>{0, 1.5}));
  const Scene one = loaded(body("at = [7, { keys = [[0, 5]], ease = \"smooth\" }]")).scene;
  EXPECT_EQ(one.entities[0].at, Vec2(7, 0));
  EXPECT_FALSE(one.entities[0].motion.x);
  EXPECT_EQ(one.curves[0].ease, Curve::Ease::smooth);
}

TEST(Curves, OfAnglesAreInDegrees) {
  const Scene scene = loaded(body("angle = { keys = [[0, 0], [1, 90]] }")).scene;
  EXPECT_EQ(scene.curves[0].values[1], radians(90));
}

TEST(Curves, AreSharedByCopiesUnlessTheyAreDrawn) {
  const std::string ring = "\nrepeat = { ring = { count = 9, radius = 5 } }";
  EXPECT_EQ(loaded(body("angle = { keys = [[0, 0], [1, 90]] }" + ring)).scene.curves.size(), 1u);
  const Scene drawn =
      loaded(body("angle = { keys = [[0, 0], [1, { uniform = [0, 90] }]] }" + ring)).scene;
  EXPECT_EQ(drawn.curves.size(), 9u);
  EXPECT_NE(drawn.curves[0].values, drawn.curves[8].values);
}

TEST(Curves, ThatStepHaveNoSlopeToBeTooSteep) {
  const Scene scene =
      loaded(body("angle = { keys = [[0, 0], [1e-320, 90]], ease = \"step\" }")).scene;
  EXPECT_EQ(value_at(scene.curves[0], 0), 0);
  EXPECT_EQ(value_at(scene.curves[0], 1e-320), radians(90));
}

TEST(Curves, MoveGroupsStrokesAndTheCamera) {
  const Scene scene = loaded(
                          "flatray = 1\n[camera]\nat = [{ keys = [[0, 1]] }, 2]\nheight = { keys "
                          "= [[0, 3]] }\nzoom = { keys = [[0, 4]] }\n[[group]]\nname = "
                          "\"g\"\nat = { keys = [[0, [1, 2]]] }\n" +
                          body("stroke = { width = { keys = [[0, 2], [1, 0]] } }").substr(12))
                          .scene;
  EXPECT_TRUE(scene.groups[0].motion.x);
  EXPECT_TRUE(scene.entities[0].stroke->width_curve);
  EXPECT_TRUE(scene.camera.at->x && scene.camera.height->curve && scene.camera.zoom.curve);
  EXPECT_EQ(scene.camera.at->value, Vec2(0, 2));
}

TEST(Follow, MeasuresItsPath) {
  const Scene scene =
      loaded(body("follow = { path = [[0, 0], [0, 0], [3, 4], [3, 0]], speed = 2, closed = true }"))
          .scene;
  ASSERT_EQ(scene.paths.size(), 1u);
  EXPECT_EQ(scene.paths[0].lengths, (std::vector<double>{0, 5, 9, 12}));
  EXPECT_EQ(scene.paths[0].points.back(), Vec2(0, 0));
  EXPECT_EQ(scene.entities[0].motion.follow->speed, 2);
  const Scene timed = loaded(body("follow = { path = [[0, 0], [3, 4]], duration = 2 }")).scene;
  EXPECT_EQ(timed.entities[0].motion.follow->speed, 5);
  EXPECT_EQ(timed.entities[0].motion.follow->duration, 2);
}

TEST(Motion, RefusalsSayWhatToWrite) {
  const Refused cases[] = {
      {body("at = { keys = [] }"), "entity.at.keys is empty"},
      {body("at = { keys = 3 }"), "entity.at.keys is a number, not a list of keys"},
      {body("at = { keys = [[0, 1]] }"), "entity.at.keys[0][1] is a number, not two numbers"},
      {body("angle = { keys = [0, 1] }"),
       "entity.angle.keys[0] is a number, not a time and a value"},
      {body("angle = { keys = [[1, 0], [1, 5]] }"),
       "entity.angle.keys[1] is not later than the key before it"},
      {body("angle = { keys = [[0, 0], [1e-300, 1e9]] }"),
       "entity.angle.keys[1] is too near to the key before it"},
      {body("angle = { keys = [[0, 1e301]] }"), "entity.angle.keys[0] lies beyond 1e300"},
      {body("angle = { keys = [[0, 0]], ease = \"smoth\" }"), "did you mean 'smooth'?"},
      {body("velocity = [{ keys = [[0, 1]] }, 0]"), "entity.velocity[0] cannot change with time"},
      {body("velocity = { keys = [[0, [1, 0]]] }"), "entity.velocity cannot change with time"},
      {body("bounding_box = { width = { keys = [[0, 1]] } }"),
       "bounding_box.width cannot change with time"},
      {body("stroke = { width = { keys = [[0, 1], [1, -1]] } }"), "stroke.width goes below 0"},
      {"flatray = 1\nfps = { keys = [[0, 1]] }", "fps cannot change with time"},
      {"flatray = 1\ncamera = { zoom = 0 }", "camera.zoom is not above 0"},
      {"flatray = 1\ncamera = { height = { keys = [[0, 1], [1, 0]] } }",
       "camera.height is not above 0"},
      {body("follow = { path = [[0, 0], [1, 0]] }"), "follow wants either speed or duration"},
      {body("follow = { path = [[0, 0], [1, 0]], speed = 1, duration = 1 }"),
       "follow wants either speed or duration"},
      {body("follow = { path = [[0, 0], [0, 0]], speed = 1 }"), "the path of follow has no length"},
      {body("follow = { path = [[0, 0], [1e200, 0]], speed = 1 }"),
       "the path of follow is too long"},
      {body("follow = { path = 3, speed = 1 }"), "follow.path is a number, not a list of points"},
      {body("follow = { path = [[0, 0], [1, 0]], duration = 0 }"),
       "follow.duration is not above 0"},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

}  // namespace
}  // namespace flatray
