#include "collide/meetings.h"

#include <gtest/gtest.h>

#include "collide/broad_phase.h"
#include "oracle/families.h"
#include "scene/load.h"
#include "support/pictures.h"

namespace flatray {
namespace {

TEST(Meetings, SameWhicheverFrameRate) {
  for (const char* fps : {"1", "7", "1000"}) {
    const Scene scene = scene_of(std::string("flatray = 1\nfps = ") + fps +
                                 "\nframes = 4000\n"
                                 "[[entity]]\nname = \"bullet\"\n"
                                 "shape = { box = { min = [0, 0], max = [1, 1] } }\n"
                                 "velocity = [1000, 0]\n"
                                 "[[entity]]\nname = \"wall\"\n"
                                 "shape = { box = { min = [1501, -5], max = [1501.5, 5] } }\n");
    const std::vector<Meeting> met = find_meetings(Timeline(scene, 0, 4000), 4000);
    ASSERT_EQ(met.size(), 1U) << fps;
    EXPECT_EQ(met[0].part.times.low, 1.5);
    EXPECT_EQ(met[0].part.times.high, 1.5015);
    EXPECT_TRUE(met[0].straight);
    EXPECT_EQ(met[0].part.normal, Vec2(1, 0));
  }
}

TEST(Meetings, WhatTurnsIsSeenFromFrameToFrame) {
  const Scene scene = scene_of(
      "flatray = 1\nfps = 1\nframes = 5\n"
      "[[entity]]\nname = \"hand\"\nshape = { box = { min = [1, -0.1], max = [3, 0.1] } }\n"
      "angular_velocity = 90\n"
      "[[entity]]\nname = \"post\"\nshape = { box = { min = [-0.1, 1.5], max = [0.1, 2] } }\n");
  const std::vector<Meeting> met = find_meetings(Timeline(scene, 0, 5), 5);
  ASSERT_EQ(met.size(), 1U);
  EXPECT_FALSE(met[0].straight);
  EXPECT_EQ(met[0].part.times.low, 1);   // frame 2: a quarter turn
  EXPECT_EQ(met[0].part.times.high, 2);  // held as it is in frame 2 until frame 3
}

TEST(Meetings, WhatRestsMeetsNothingThatRests) {
  const Scene scene = scene_of(
      "flatray = 1\nframes = 10\n"
      "[[entity]]\nname = \"a\"\nshape = { box = { min = [0, 0], max = [2, 2] } }\n"
      "[[entity]]\nname = \"b\"\nshape = { box = { min = [1, 1], max = [3, 3] } }\n");
  EXPECT_TRUE(find_meetings(Timeline(scene, 0, 10), 10).empty());
}

TEST(BroadPhase, FindsThePairsThatTestingAllFinds) {
  oracle::Draw draw(3, 41, 0);
  std::vector<Bounds> boxes(200);
  for (std::size_t i = 3; i < boxes.size(); ++i) {  // three are empty
    const Vec2 low(draw.below(100), draw.below(100));
    boxes[i] = {low, low + Vec2(draw.below(12), draw.below(12))};
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (std::uint32_t i = 3; i < boxes.size(); ++i)
    for (std::uint32_t k = i + 1; k < boxes.size(); ++k)
      if ((boxes[i].low.array() <= boxes[k].high.array()).all() &&
          (boxes[k].low.array() <= boxes[i].high.array()).all())
        all.emplace_back(i, k);
  EXPECT_GT(all.size(), 50U);
  EXPECT_EQ(overlapping_pairs(boxes), all);
}

}  // namespace
}  // namespace flatray
