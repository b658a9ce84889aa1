// needs: shapes/circle shapes/polygon
#include "collide/edge_ray_meetings.h"

#include <gtest/gtest.h>

#include "all_meetings.h"

namespace flatray {
namespace {

const char* const kBullet =
    "flatray = 1\nfps = 24\nframes = 4\n"
    "[[entity]]\nname = \"bullet\"\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
    "velocity = [3e8, 0]\n"
    "[[entity]]\nname = \"wall\"\nshape = { box = { min = [5, -5], max = [5.001, 5] } }\n";

TEST(EdgeRayMeetings, LoseWhatGoesThroughBetweenTwoFrames) {
  const Scene scene = scene_of(kBullet);
  const Timeline timeline(scene, 0, 4);
  EXPECT_TRUE(find_edge_ray_meetings(timeline, 4).value().empty());
  const std::vector<Meeting> exact = meetings(scene);
  ASSERT_EQ(exact.size(), 1U);
  EXPECT_EQ(exact[0].part.times.low, 4 / 3e8);
}

// In from t = 1.5 to 6, wholly inside between t = 2 and 5.5, where no side of the ring meets the seed.
TEST(EdgeRayMeetings, SeeOneInsideTheOtherWhicheverComesFirst) {
  const std::string ring =
      "[[entity]]\nname = \"ring\"\nshape = { box = { min = [4, -4], max = [12, 4] } }\n";
  const std::string seed =
      "[[entity]]\nname = \"seed\"\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "velocity = [2, 0]\n";
  for (const std::string& entities : {ring + seed, seed + ring}) {
    const Scene scene = scene_of("flatray = 1\nfps = 1\nframes = 9\n" + entities);
    const Timeline timeline(scene, 0, 9);
    const std::vector<Meeting> exact = meetings(scene);
    ASSERT_EQ(exact.size(), 1U);
    EXPECT_EQ(exact[0].part.times.low, 1.5);
    EXPECT_EQ(exact[0].part.times.high, 6);
    const std::vector<Meeting> seen = find_edge_ray_meetings(timeline, 9).value();
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(seen[0].part.times.low, 2);
    EXPECT_EQ(seen[0].part.times.high, 6);
  }
}

TEST(Meetings, BoxesMeetWhereTrianglesDoNot) {
  const Scene scene = scene_of(
      "flatray = 1\nfps = 1\nframes = 3\n"
      "[[entity]]\nname = \"a\"\nshape = { polygon = { points = [[0, 0], [4, 0], [0, 4]] } }\n"
      "[[entity]]\nname = \"b\"\nshape = { polygon = { points = [[4, 4], [1, 4], [4, 1]] } }\n"
      "velocity = [0.25, 0]\n");
  EXPECT_TRUE(meetings(scene).empty());
  EXPECT_EQ(meetings(scene, Outline::box).size(), 1U);
}

TEST(Meetings, DiscsMeetToo) {
  const std::vector<Meeting> met = meetings(
      "flatray = 1\nfps = 1\nframes = 9\n"
      "[[entity]]\nname = \"a\"\nshape = { circle = { radius = 2 } }\nat = [-10, 3]\n"
      "velocity = [2, 0]\n"
      "[[entity]]\nname = \"b\"\nshape = { circle = { radius = 3 } }\n");
  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(met[0].part.times.low, 3);
  EXPECT_EQ(met[0].part.times.high, 7);
  EXPECT_NEAR((met[0].part.normal - Vec2(0.8, -0.6)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace flatray
