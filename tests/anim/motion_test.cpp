#include "anim/motion.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scenes.h"

namespace flatray {
namespace {

using Ease = Curve::Ease;
using testing::add_box;
using testing::small_scene;

TEST(Motion, CurvesAndVelocitiesAddUp) {
  Scene scene = small_scene();
  scene.frames = 3;
  scene.curves = {{Ease::linear, {0, 2}, {0, 8}}, {Ease::linear, {0, 2}, {0, std::numbers::pi}}};
  Entity& box = scene.entities[add_box(scene, {1, 2}, {0, 1})];
  box.motion.x = 0;
  box.motion.angle = 1;
  const FrameState state = at(Timeline(scene, 0, 3), 2);
  EXPECT_EQ(state.entities[0].at, Vec2(5, 3));
  EXPECT_EQ(entity_pose(state, 0).sin, 1);
  EXPECT_NE(reason_to_move(scene), "");
}

TEST(Motion, AFollowerTurnsWithItsPathAndArrivesOnTime) {
  Scene scene = small_scene();
  scene.paths = {Path{{{0, 0}, {3, 0}, {3, 4}}, {0, 3, 7}, false}};
  Entity& box = scene.entities[add_box(scene, {10, 10})];
  box.motion.follow = Follow{0, 7, 3, 0, true};  // the whole path in 3 seconds
  const Timeline timeline(scene, 0, 5);
  EXPECT_EQ(at(timeline, 4).entities[0].at, Vec2(13, 14));
  EXPECT_EQ(entity_pose(at(timeline, 1), 0).cos, 1);
  EXPECT_EQ(entity_pose(at(timeline, 4), 0).sin, 1);
}

TEST(Motion, AStrokeMayGrow) {
  Scene scene = small_scene();
  scene.frames = 2;
  scene.curves = {{Ease::linear, {0, 4}, {1, 5}}};
  Entity& box = scene.entities[add_box(scene, {0, 0})];
  box.stroke = Stroke{0, false, {}};
  box.stroke->width_curve = 0;
  EXPECT_EQ(at(Timeline(scene, 0, 3), 3).entities[0].stroke->width, 3);
  EXPECT_NE(reason_to_move(scene), "");
}

TEST(Motion, ColoursThatChangeKeepNoFrameStill) {
  Scene scene = small_scene();
  Entity& box = scene.entities[add_box(scene, {0, 0})];
  box.fill = Paint(Colour{1, 2, 3, 255});
  EXPECT_EQ(reason_to_move(scene), "");
  box.fill->curve = 0;
  EXPECT_NE(reason_to_move(scene), "");
}

TEST(Motion, TheMarkOfATimeBarKeepsNoFrameStill) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  scene.collisions.emplace();
  EXPECT_EQ(reason_to_move(scene), "");
  scene.collisions->time_bar = Stroke{};
  EXPECT_NE(reason_to_move(scene), "");
}

TEST(Camera, ZoomShowsLessAboutTheSameMiddle) {
  Scene scene = small_scene();
  scene.camera.zoom = {4, {}};
  const Bounds window = at(Timeline(scene, 0, 1), 1).window;
  EXPECT_EQ(window.size(), Vec2(5, 2.5));
  EXPECT_EQ(window.centre(), Vec2(10, 5));
}

TEST(Camera, CurvesPanAndZoom) {
  Scene scene = small_scene();
  scene.frames = 3;
  scene.curves = {{Ease::linear, {0, 2}, {0, 8}}, {Ease::linear, {0, 2}, {10, 30}}};
  scene.camera.at = MovingPoint{{1, 5}, 0, {}};
  scene.camera.height = {0, 1};
  const Timeline timeline(scene, 0, 3);
  EXPECT_EQ(at(timeline, 1).window.size(), Vec2(20, 10));
  EXPECT_EQ(at(timeline, 3).window.size(), Vec2(60, 30));
  EXPECT_EQ(at(timeline, 2).window.centre(), Vec2(5, 5));
  EXPECT_EQ(reason_to_move(scene), "the camera moves");
}

TEST(Camera, ZoomingIsOnePictureWhetherWindowOrObjectsMove) {
  Scene scene = small_scene();
  add_box(scene, {3, 4});
  scene.curves = {{Ease::linear, {0, 2}, {1, 2}}};
  scene.camera.zoom = {0, 0};
  const FrameState moved = at(Timeline(scene, 0, 3), 3);
  Scene displaced = scene;
  displaced.camera.motion = CameraMotion::objects;
  const FrameState other = at(Timeline(displaced, 0, 3), 3);
  EXPECT_EQ(other.window.size(), moved.window.size());
  EXPECT_EQ(Vec2(entity_pose(other, 0).at - other.window.low),
            Vec2(entity_pose(moved, 0).at - moved.window.low));
}

}  // namespace
}  // namespace flatray
