#include "anim/rigid_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "anim/frame_state.h"
#include "anim/scenes.h"

namespace flatray {
namespace {

CurveId add_curve(Scene& scene, Curve::Ease ease, std::vector<double> times,
                  std::vector<double> values) {
  scene.curves.push_back({ease, std::move(times), std::move(values)});
  return static_cast<CurveId>(scene.curves.size() - 1);
}

// Three groups in one another that turn, follow a path and keys, and a box in them that does, too.
Scene carried_box() {
  Scene scene = testing::small_scene();
  scene.frames = 9;
  scene.fps = 2;
  scene.paths.push_back({{{0, 0}, {3, 0}, {3, 4}, {0, 0}}, {0, 3, 7, 12}, true});
  scene.groups.resize(3);
  Group &outer = scene.groups[0], &middle = scene.groups[1], &inner = scene.groups[2];
  outer.angular_velocity = 1.25;
  outer.velocity = {0.5, -0.25};
  outer.at = {10, 20};
  outer.scale.value = 1.5;
  middle.group = 0;
  middle.angle = 0.5;  // stands still, but for its path
  middle.motion.follow = Follow{0, 12, 1.7, 2, true};
  inner.group = 1;
  inner.at = {2, -1};
  inner.motion.angle = add_curve(scene, Curve::Ease::smooth, {0.3, 1.1, 2.9}, {0, 9, -4});
  inner.motion.x = add_curve(scene, Curve::Ease::linear, {0.7, 2}, {5, -5});
  const std::uint32_t box = testing::add_box(scene, {1, 3}, {0.25, 0});
  scene.entities[box].group = 2;
  scene.entities[box].angle = -1;
  scene.entities[box].angular_velocity = -2;
  scene.entities[box].motion.y = add_curve(scene, Curve::Ease::smooth, {0, 1.3, 4}, {1, 7, 2});
  return scene;
}

Vec2 place_of(const RigidMotion& motion, double t) {
  Vec2 at = motion.at(t);
  for (const Swing& swing : motion.swings) {
    const double c = std::cos(swing.turned(t)), s = std::sin(swing.turned(t));
    const Vec2 arm = swing.arm(t);
    at += Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
  }
  return at;
}

// Where frames would show an entity between them, if there were any.
TEST(TrueMotion, IsWhatFramesInBetweenShow) {
  const Scene scene = carried_box();
  const Timeline timeline(scene, 0, scene.frames);
  const TrueMotion motions(timeline);
  std::size_t pieces = 0;
  for (unsigned frame = 1; frame < scene.frames; ++frame) {
    const double begin = (frame - 1) / scene.fps, end = frame / scene.fps;
    std::vector<double> times = motions.knots(0, std::nullopt, begin, end);
    times.push_back(end);
    for (double from = begin; const double to : times) {
      const auto [motion, scale] = motions.between(0, std::nullopt, frame, from, to);
      ++pieces;
      EXPECT_EQ(scale, 1.5);
      EXPECT_LT(motion.doubt, 1e-11);  // arms of some 10, in four groups
      for (const double t : {0.125, 0.5, 0.8}) {
        const double part = (from + t * (to - from) - begin) * scene.fps;
        const EntityState state = entity_states(timeline, frame, part)[0];
        EXPECT_LE((place_of(motion, t) - state.at).norm(), std::min(motion.doubt, 1e-12));
        EXPECT_NEAR(motion.angle(t), state.angle, 1e-12);
        const Bounds box = box_around(motion);
        EXPECT_TRUE((box.low.array() <= state.at.array()).all() &&
                    (state.at.array() <= box.high.array()).all());
      }
      from = to;
    }
  }
  EXPECT_GT(pieces, 15U);  // four seconds of a path of 0.57 s an edge, and keys
}

TEST(TrueMotion, OfWhatGoesStraightIsEven) {
  Scene scene = testing::small_scene();
  scene.frames = 2;
  scene.groups.resize(1);
  scene.groups[0].angle = 0.5;
  scene.groups[0].velocity = {1, 0};
  const std::uint32_t box = testing::add_box(scene, {1, 3}, {0.25, 0});
  scene.entities[box].group = 0;
  const Timeline timeline(scene, 0, 2);
  const RigidMotion motion = TrueMotion(timeline).between(box, std::nullopt, 1, 0, 1).motion;
  EXPECT_TRUE(motion.is_even());
  EXPECT_NEAR((motion.at.c[1] - Vec2(1 + 0.25 * std::cos(0.5), 0.25 * std::sin(0.5))).norm(), 0,
              1e-15);
}

TEST(TrueMotion, IsSeenFromTheGroupThatCarriesBoth) {
  Scene scene = carried_box();
  scene.entities.push_back(scene.entities[0]);
  scene.entities[1].group = 1;
  EXPECT_EQ(group_of_both(scene, 0, 1), std::optional<std::uint32_t>(1));
  scene.entities[1].group.reset();
  EXPECT_EQ(group_of_both(scene, 0, 1), std::nullopt);
  const Timeline timeline(scene, 0, scene.frames);
  // Seen from its own group it only follows its keys and turns.
  const Carried own = TrueMotion(timeline).between(0, 2, 1, 0, 0.5);
  EXPECT_TRUE(own.motion.swings.empty());
  EXPECT_EQ(own.scale, 1);
}

TEST(Cubic, StaysWithinItsBounds) {
  const Cubic<double> p{{1, -3, 5, -2.5}};
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.02 * i;
    EXPECT_LE(std::fabs(p(t)), p.most(2) + 1e-12);
    EXPECT_LE(std::fabs(p.slope(t)), p.most_slope(2) + 1e-12);
    EXPECT_LE(std::fabs(2 * 5 - 15 * t), p.most_bend(2) + 1e-12);
    EXPECT_LE(p.most(2), p.sum(2));
    EXPECT_LE(p.most_slope(2), p.sum_of_slope(2));
  }
}

}  // namespace
}  // namespace flatray
