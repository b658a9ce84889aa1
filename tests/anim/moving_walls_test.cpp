#include "anim/moving_walls.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace flatray {
namespace {

using testing::add_box;
using testing::small_scene;

TEST(MovingWalls, WhatRestsStandsInTheWorldAndWhatMovesIsSeenFromWhereItIs) {
  Scene scene = small_scene();
  add_box(scene, {3, 4});
  add_box(scene, {5, 6}, {1, -2});
  const MovingWalls walls = moving_walls(Timeline(scene, 0, 1));
  ASSERT_EQ(walls.world.surfaces.size(), 8U);
  EXPECT_EQ(walls.world.surfaces.segments[0].a, Vec2(3, 4));
  EXPECT_EQ(walls.world.surfaces.segments[4].a, Vec2(0, 0));
  const std::vector<Leg>& legs = walls.legs(4);
  ASSERT_EQ(legs.size(), 1U);
  EXPECT_EQ(legs[0].from, Vec2(5, 6));
  EXPECT_EQ(legs[0].velocity, Vec2(1, -2));
  EXPECT_TRUE(legs[0].is_last());
  EXPECT_EQ(walls.motion_of[0], 0U);
}

// Keys of the thing and of its group, in one list of legs that leaves no gap.
TEST(MovingWalls, KeysAndGroupsMakeLegs) {
  Scene scene = small_scene();
  scene.curves = {{Curve::Ease::linear, {-1, 2}, {0, 3}}, {Curve::Ease::linear, {1, 4}, {0, 6}}};
  Group group;
  group.at = {10, 0};
  group.scale.value = 2;
  group.motion.y = 1;
  scene.groups.push_back(group);
  Entity& box = scene.entities[add_box(scene, {0, 0}, {0, 0.5})];
  box.motion.x = 0;
  box.group = 0;
  const Timeline timeline(scene, 0, 5);
  const MovingWalls walls = moving_walls(timeline);
  const std::vector<Leg>& legs = walls.legs(0);
  ASSERT_EQ(legs.size(), 4U);
  const double begins[] = {0, 1, 2, 4};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(legs[i].begin, begins[i]);
    EXPECT_EQ(legs[i].from, entity_states(timeline, 1 + static_cast<unsigned>(begins[i]))[0].at);
    if (i < 3) {
      EXPECT_EQ(legs[i].to, legs[i + 1].from);
      EXPECT_EQ(legs[i].end, legs[i + 1].begin);
    }
  }
  EXPECT_EQ(legs[3].velocity, Vec2(0, 1));
  EXPECT_EQ(walls.world.surfaces.segments[0].b, Vec2(2, 0));
}

TEST(MovingWalls, FollowWhatContactMakesOfThem) {
  Scene scene = small_scene();
  add_box(scene, {0, 0}, {1, 0});
  Responses met;
  met.stages = {{{0, {0, 0}, {1, 0}}, {2, {2, 0}, {-1, 0}}, {5, {-1, 0}, {0, 0}, true}}};
  const MovingWalls walls = moving_walls(Timeline(scene, 0, 8, met));
  ASSERT_EQ(walls.legs(0).size(), 3U);
  EXPECT_EQ(walls.legs(0)[0].to, Vec2(2, 0));
  EXPECT_EQ(walls.legs(0)[1].end, 5);
  EXPECT_EQ(walls.gone_from[walls.motion_of[0]], 5);
}

}  // namespace
}  // namespace flatray
