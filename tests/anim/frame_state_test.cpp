#include "anim/frame_state.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

constexpr double kPi = 0x1.921fb54442d18p+1;  // nearest to pi

TEST(FrameState, PositionWithoutAChainIsVelocityTimesTime) {
  Scene scene = small_scene();
  scene.fps = 10;
  add_box(scene, {1, 2}, {3, -1});
  const FrameState state = at(Timeline(scene, 0, 1), 8);
  EXPECT_EQ(state.time, 0.7);  // 7/10 rounded once, not seven tenths added up
  EXPECT_EQ(state.entities[0].at, Vec2(1 + 3 * 0.7, 2 - 0.7));
}

TEST(FrameState, ALookChangesOnlyWhatItSets) {
  Scene scene = small_scene();
  const std::uint32_t runner = add_box(scene, {0, 0});
  scene.shapes.push_back(box({0, 0}, {2, 2}));
  scene.chains.push_back(flip_chain());
  Entity& entity = scene.entities[runner];
  entity.fill = Colour{1, 2, 3, 255};
  entity.stroke = Stroke{.width = 2, .colour = {}};
  Look big;
  big.shape = 1;
  Look red;
  red.fill = Colour{255, 0, 0, 255};
  entity.markov = MarkovUse{0, 0, std::nullopt, {{big}, {red}}};
  const Timeline timeline(scene, 0, 2);
  const EntityState first = at(timeline, 1).entities[0], second = at(timeline, 2).entities[0];
  EXPECT_EQ(first.shape, 1U);
  EXPECT_EQ(first.fill, (Colour{1, 2, 3, 255}));
  EXPECT_EQ(first.state, StateId{0});
  EXPECT_EQ(second.shape, 0U);
  EXPECT_EQ(second.fill, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(second.stroke->width, 2);
  EXPECT_EQ(second.state, StateId{1});
}

TEST(FrameState, AnEntityWithoutAChainHasNoState) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  EXPECT_EQ(at(Timeline(scene, 0, 1), 1).entities[0].state, std::nullopt);
}

TEST(FrameState, ItTurnsAtItsAngularVelocity) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  scene.entities[0].angle = kPi / 2;
  scene.entities[0].angular_velocity = kPi / 2;
  EXPECT_EQ(at(Timeline(scene, 0, 1), 3).entities[0].angle, 1.5 * kPi);
}

// k * 90 degrees as a scene gives it (degrees * pi / 180, rounded) or as turning adds it up.
TEST(Pose, QuarterTurnsAreExact) {
  const Vec2 local(3, 0.1);
  const Vec2 turned[] = {{3, 0.1}, {-0.1, 3}, {-3, -0.1}, {0.1, -3}};
  for (int k = -4000; k <= 4000; ++k) {
    const Vec2 expected = turned[((k % 4) + 4) % 4];
    EXPECT_EQ(pose({0, 0}, 90.0 * k * (kPi / 180))(local), expected) << k;
    EXPECT_EQ(pose({0, 0}, k * (kPi / 2))(local), expected) << k;
    EXPECT_EQ(pose({0, 0}, kPi / 2 + (k - 1) * (kPi / 2))(local), expected) << k;
  }
}

TEST(Pose, OtherAnglesAreNotTakenForQuarterTurns) {
  const double quarter = kPi / 2;
  EXPECT_NE(pose({0, 0}, quarter * (1 + 0x1p-50)).cos, 0);
  EXPECT_EQ(pose({0, 0}, 0x1p-500).sin, 0x1p-500);
  const Pose third = pose({0, 0}, kPi / 3);
  EXPECT_NEAR(third.cos, 0.5, 0x1p-52);
  EXPECT_NEAR(third.sin, std::sqrt(0.75), 0x1p-52);
}

TEST(Pose, PlacesThePointAfterTurningIt) {
  EXPECT_EQ(pose({10, 20}, kPi)({1, 2}), Vec2(9, 18));
  EXPECT_EQ(pose({0.5, 0.25}, 0)({1, 2}), Vec2(1.5, 2.25));
}

}  // namespace
}  // namespace flatray
