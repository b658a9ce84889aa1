// needs: shapes/box formats/toml
#include "app/answers/orbit_report.h"

#include <gtest/gtest.h>

#include "collide/scene_timeline.h"
#include "scene/load.h"

namespace flatray {
namespace {

// A ball in a box, and a mirror before the box in the file, so that its walls have the lower numbers.
Scene ball_in_a_box(const std::string& mirror) {
  auto loaded = load_scene_text(
      "room.toml",
      "flatray = 1\nframes = 9\nfps = 4\n[[chamber]]\nname = \"box\"\n"
      "shape = { box = { min = [0, 0], max = [10, 4] } }\n[[entity]]\nname = \"mirror\"\n"
      "shape = { box = { min = [0, -0.2], max = [0.4, 4.2] } }\nmaterial = \"mirror\"\n" +
          mirror);
  FLATRAY_CHECK(loaded.has_value(), loaded ? "" : format(loaded.error()));
  return std::move(loaded->scene);
}

// "object edge" of each bounce, as the table of `frame` has them.
std::vector<std::string> named_walls(const Scene& scene, unsigned frame) {
  const auto timeline = make_timeline(scene, 1, scene.frames);
  FLATRAY_CHECK(timeline.has_value());
  const OrbitRoom room(scene, at(*timeline, frame));
  const MovingWalls walls = moving_walls(*timeline);
  const OrbitReport report =
      follow_moving(room, walls, "ball", {{1, 1}, {4, 3}}, (frame - 1) / scene.fps, {6});
  std::vector<std::string> names;
  bounce_table(room, {&report, 1}).each_row([&](const Values& row) {
    names.push_back(row[6].as_text().value_or("") + " " + json_text(row[7]));
  });
  return names;
}

const std::vector<std::string> kBoxAlone = {"box 2", "box 1", "box 0", "box 2", "box 3", "box 0"};

// So far away that corners of the mirror are one double in the picture, while it keeps its four walls
// where it moves. Asked under sanitizers, too: numbers of one world read past the end of the other.
TEST(OrbitReport, NamesTheWallsMetWhereCornersOfAMirrorThatMovesAreOneDouble) {
  for (const char* far : {"1e6", "1e17", "-1e300"}) {
    const std::string at = std::string("at = [10, ") + far + "]\nvelocity = [-1, 0]\n";
    EXPECT_EQ(named_walls(ball_in_a_box(at), 1), kBoxAlone) << far;
  }
}

// A picture of a frame in which a mirror is gone has fewer walls than there are when the ball sets off.
TEST(OrbitReport, NamesTheWallsMetWhereAMirrorIsGoneInTheFrame) {
  const Scene scene = ball_in_a_box(
      "at = [20, 0]\nvelocity = [4, 0]\nresponse = \"remove\"\n[[entity]]\nname = \"wall\"\n"
      "shape = { box = { min = [22, 0], max = [23, 4] } }\nresponse = \"stop\"\n");
  ASSERT_TRUE(at(*make_timeline(scene, 1, 9), 9).entities[0].gone);
  EXPECT_EQ(named_walls(scene, 9), kBoxAlone);
}

}  // namespace
}  // namespace flatray
