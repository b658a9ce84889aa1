#include <gtest/gtest.h>

#include <numbers>

#include "anim/motion.h"
#include "anim/world.h"
#include "scenes.h"

namespace flatray {
namespace {

using testing::add_box;
using testing::small_scene;

std::uint32_t add_group(Scene& scene, Group group) {
  scene.groups.push_back(std::move(group));
  return static_cast<std::uint32_t>(scene.groups.size() - 1);
}
Group turning(double degrees_a_second) {
  Group group;
  group.angular_velocity = degrees_a_second / 180 * std::numbers::pi;
  return group;
}

TEST(Groups, TurnWhatTheyHoldAboutTheirOrigin) {
  Scene scene = small_scene();
  scene.frames = 5;
  Group group = turning(90);
  group.at = {10, 5};
  scene.entities[add_box(scene, {3, 0})].group = add_group(scene, group);
  const Timeline timeline(scene, 0, 5);
  const Vec2 expected[] = {{13, 5}, {10, 8}, {7, 5}, {10, 2}, {13, 5}};
  for (unsigned frame = 1; frame <= 5; ++frame) {
    const FrameState state = at(timeline, frame);
    EXPECT_EQ(state.entities[0].at, expected[frame - 1]) << frame;
    const Pose pose = entity_pose(state, 0);
    EXPECT_EQ(pose({1, 0}), expected[frame - 1] + (expected[frame - 1] - group.at) / 3) << frame;
  }
}

TEST(Groups, InGroupsComposeAndOppositeTurnsCancel) {
  Scene scene = small_scene();
  scene.frames = 9;
  Group outer = turning(30), inner = turning(-30);
  outer.at = {8, 0};
  outer.velocity = {0, 1};
  inner.at = {2, 0};
  inner.group = add_group(scene, outer);
  scene.entities[add_box(scene, {0, 0})].group = add_group(scene, inner);
  const Timeline timeline(scene, 0, 9);
  const FrameState state = at(timeline, 4);  // 90 degrees
  EXPECT_EQ(state.entities[0].at, Vec2(8, 5));
  EXPECT_EQ(entity_pose(state, 0).cos, 1);
}

TEST(Groups, AVelocityTurnsWithTheGroup) {
  Scene scene = small_scene();
  Group group;
  group.angle = std::numbers::pi / 2;
  scene.entities[add_box(scene, {0, 0}, {2, 0})].group = add_group(scene, group);
  EXPECT_EQ(at(Timeline(scene, 0, 3), 3).entities[0].at, Vec2(0, 4));
}

// Found by a reader: such a group was drawn once for all frames.
TEST(Groups, MoveByCurvesAndPathsToo) {
  for (std::optional<CurveId> Motion::*curve : {&Motion::x, &Motion::y, &Motion::angle}) {
    Scene scene = small_scene();
    scene.frames = 2;
    scene.curves = {{Curve::Ease::linear, {0, 4}, {1, 5}}};
    Group group;
    group.motion.*curve = 0;
    scene.entities[add_box(scene, {0, 0})].group = add_group(scene, group);
    EXPECT_NE(reason_to_move(scene), "");
  }
  Scene scene = small_scene();
  scene.frames = 2;
  Group group;
  group.motion.follow = Follow{};
  scene.entities[add_box(scene, {0, 0})].group = add_group(scene, group);
  EXPECT_NE(reason_to_move(scene), "");
}

// 2 * 1.5 = 3: places and velocities grow with what they are seen from, circles stay circles.
TEST(Groups, ScaleWhatTheyHoldAboutTheirOrigin) {
  Scene scene = small_scene();
  scene.film.world.reset();
  Group outer, inner;
  outer.at = {10, 0};
  outer.scale.value = 2;
  inner.at = {1, 4};
  inner.velocity = {0, 1};
  inner.scale.value = 1.5;
  inner.group = add_group(scene, outer);
  scene.entities[add_box(scene, {1, 2}, {1, 0})].group = add_group(scene, inner);
  scene.shapes[0].circles.push_back({{1, 1}, 0.5});
  const Timeline timeline(scene, 0, 2);
  const FrameState state = at(timeline, 2);
  EXPECT_EQ(state.entities[0].at, Vec2(10 + 2 * (1 + 1.5 * 2), 2 * (5 + 1.5 * 2)));
  const World world = build_world(scene, state);
  ASSERT_EQ(world.surfaces.segments.size(), 4u);
  ASSERT_EQ(world.surfaces.arcs.size(), 1u);
  EXPECT_EQ(world.surfaces.arcs[0].curve.centre, Vec2(18 + 3, 16 + 3));
  EXPECT_EQ(world.surfaces.arcs[0].curve.u.x(), 1.5);
  EXPECT_EQ(timeline.content().high, Vec2(10 + 2 * (1 + 1.5) + 4.5, 2 * (4 + 3) + 4.5));
}

// At half its time 0.5 + 0.5 * 3 = 2 times as large; at its end a point.
TEST(Groups, ScalesMayBeCurves) {
  Scene scene = small_scene();
  scene.curves = {{Curve::Ease::linear, {0, 2, 3}, {1, 3, 0}}};
  Group group;
  group.at = {10, 5};
  group.scale = {0, 0};
  Entity& box = scene.entities[add_box(scene, {1, 2})];
  box.group = add_group(scene, group);
  box.stroke = Stroke{0.5, false, {}};
  const Timeline timeline(scene, 0, 4);
  const FrameState half = at(timeline, 2);
  EXPECT_EQ(half.entities[0].at, Vec2(12, 9));
  EXPECT_EQ(entity_pose(half, 0)(Vec2(1, 1)), Vec2(14, 11));
  EXPECT_EQ(half.entities[0].stroke->scale, 2);
  EXPECT_EQ(build_world(scene, half).surfaces.segments.size(), 4u);
  EXPECT_TRUE(
      build_world(scene, at(timeline, 4)).surfaces.segments.empty());  // a point has no walls
  EXPECT_NE(reason_to_move(scene), "");
}

TEST(Groups, ScalesBeyondAllMeasureStayFinite) {
  Scene scene = small_scene();
  for (const double scale : {1e300, 1e-300}) {
    scene.groups.clear();
    scene.entities.clear();
    Group outer, inner;
    outer.scale.value = inner.scale.value = scale;
    inner.group = add_group(scene, outer);
    scene.entities[add_box(scene, {3, 4})].group = add_group(scene, inner);
    const Pose pose = entity_pose(at(Timeline(scene, 0, 1), 1), 0);
    EXPECT_TRUE(pose(Vec2(1e300, -7)).allFinite());
    EXPECT_GT(pose.scale, 0);
  }
}

TEST(Groups, CarryWallsCameraAndContent) {
  Scene scene = small_scene();
  scene.film.world.reset();
  Group group;
  group.at = {100, 50};
  group.velocity = {1, 0};
  scene.entities[add_box(scene, {2, 3})].group = add_group(scene, group);
  scene.camera.follow = 0;
  const Timeline timeline(scene, 0, 2);
  EXPECT_EQ(timeline.content().low, Vec2(102, 53));
  const FrameState state = at(timeline, 2);
  EXPECT_EQ(state.window.centre(), Vec2(103, 53));
  const World world = build_world(scene, state);
  ASSERT_EQ(world.owners.size(), 4u);
  EXPECT_EQ(shape_bounds(scene.shapes[0], entity_pose(state, 0)).low, Vec2(103, 53));
}

TEST(Groups, MoveWhatStandsInThem) {
  Scene scene = small_scene();
  scene.frames = 2;
  add_box(scene, {0, 0});
  EXPECT_EQ(reason_to_move(scene), "");
  Group outer = turning(1), inner;
  outer.name = "wheel";
  inner.group = add_group(scene, outer);
  const std::uint32_t number = add_group(scene, inner);
  EXPECT_EQ(reason_to_move(scene), "");  // nothing stands in it
  scene.entities[0].group = number;
  EXPECT_EQ(reason_to_move(scene), "group 'wheel' moves");
}

}  // namespace
}  // namespace flatray
