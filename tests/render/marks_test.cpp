// needs: shapes/box passes/orbits passes/contacts formats/toml
// Round marks of rays and of time: how many, where, how large.
#include <gtest/gtest.h>

#include "support/pictures.h"

namespace flatray {
namespace {

// Ten units on forty pixels.
std::vector<FillRing> rings(const std::string& text, unsigned frame = 1) {
  const Scene scene = scene_of(
      "flatray = 1\nfps = 1\nframes = 5\nfilm = { size = [40, 40], world = [[0, 0], [10, 10]] }\n" +
      text);
  const Timeline timeline(scene, scene.seed, scene.frames);
  const auto list = draw_list(make_plan(scene, false), timeline, frame);
  std::vector<FillRing> found;
  for (const DrawItem& item : list->items)
    if (const auto* ring = std::get_if<FillRing>(&item.region)) found.push_back(*ring);
  return found;
}

std::string room_with(const std::string& keys) {
  return "[[chamber]]\nshape = { box = { min = [1, 1], max = [9, 9] } }\n"
         "[[ray]]\nat = [2, 5]\ndirection = [1, 0]\nbounces = 3\nstroke = { width_px = 1, colour = "
         "\"#ff0000\" }\n" +
         keys;
}

TEST(OrbitMarks, ABallIsWhereTheRayHasCome) {
  EXPECT_TRUE(rings(room_with("")).empty());
  // At a speed of 4: after a second at x = 6, after two 1 back from the wall at 9, at 8.
  const std::string moving = room_with("ball = { radius = 0.75 }\nspeed = 4\n");
  const double x[] = {2, 6, 8, 4, 2};
  for (unsigned frame = 1; frame <= 4; ++frame) {
    const auto there = rings(moving, frame);
    ASSERT_EQ(there.size(), 1U) << frame;
    EXPECT_EQ(there[0].radius, 3);
    EXPECT_EQ(there[0].centre, Vec2(4 * x[frame - 1], 20)) << frame;
  }
}

TEST(OrbitMarks, EveryBounceHasItsPointAndWhereItArrives) {
  const auto points = rings(room_with("hit_points = \"#0000ff\"\n"));
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[3].centre, Vec2(4, 20));
  EXPECT_EQ(points[0].centre, Vec2(36, 20));
  EXPECT_EQ(points[1].centre, Vec2(4, 20));
  EXPECT_EQ(points[2].centre, Vec2(36, 20));
}

TEST(ContactMarks, TheMarkOfTheTimeBarGoesEvenlyFromEndToEnd) {
  const std::string box =
      "[[entity]]\nshape = { box = { min = [4, 4], max = [5, 5] } }\nfill = "
      "\"#ff0000\"\n[collisions]\n";
  EXPECT_TRUE(rings(box + "points = \"#000000\"\n").empty());
  for (unsigned frame = 1; frame <= 5; ++frame) {
    const auto mark = rings(box + "time_bar = { width_px = 2, colour = \"#000000\" }\n", frame);
    ASSERT_EQ(mark.size(), 1U);
    EXPECT_NEAR(mark[0].centre.x(), 2 + 9 * (frame - 1.0), 1e-12);
    EXPECT_NEAR(mark[0].centre.y(), 38, 1e-12);
  }
}

}  // namespace
}  // namespace flatray
