#include "anim/timeline.h"

#include <gtest/gtest.h>

#include "anim/step.h"
#include "base/philox.h"
#include "scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

Scene with_chain(MarkovChain chain, std::vector<std::vector<Look>> looks = {}) {
  Scene scene = small_scene();
  add_box(scene, {4, 1}, {12, 0});
  scene.chains.push_back(std::move(chain));
  scene.entities[0].markov = MarkovUse{0, 0, std::nullopt, std::move(looks)};
  return scene;
}

std::vector<StateId> states(const Timeline& timeline, unsigned frames, std::uint32_t entity = 0) {
  std::vector<StateId> all;
  for (unsigned k = 1; k <= frames; ++k) all.push_back(timeline.markov(entity, k).state);
  return all;
}

TEST(Timeline, FrameSeventeenAloneEqualsFrameSeventeenOfALongerRun) {
  const Scene scene = with_chain(runner_chain());
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Timeline alone(scene, seed, 17), run(scene, seed, 240);
    const auto a = alone.markov(0, 17), b = run.markov(0, 17);
    EXPECT_EQ(a.state, b.state);
    EXPECT_EQ(a.sub_state, b.sub_state);
    EXPECT_EQ(a.moved, b.moved);
  }
}

TEST(Timeline, FramesBetweenThoseKeptAreThoseOfARunThatKeepsAll) {
  Look moving;
  moving.velocity = Vec2(3, 1);
  const Scene scene = with_chain(runner_chain(), {{Look{}, Look{}, Look{}}, {moving}});
  const auto last = static_cast<unsigned>(2 * Timeline::kMostKept + 77);
  const Timeline dense(scene, 5, 4000), sparse(scene, 5, last);
  for (unsigned k = 1; k <= 4000; ++k) {
    const auto a = dense.markov(0, k), b = sparse.markov(0, k);
    ASSERT_EQ(a.state, b.state) << "frame " << k;
    ASSERT_EQ(a.sub_state, b.sub_state) << "frame " << k;
    ASSERT_EQ(a.moved, b.moved) << "frame " << k;
  }
  const Timeline longer(scene, 5, last + 1000);
  EXPECT_EQ(sparse.markov(0, last).moved, longer.markov(0, last).moved);
}

TEST(Timeline, ATimeIsInTheFrameWhoseTimeIsTheLastBeforeIt) {
  Scene scene = small_scene();
  for (const double fps : {24.0, 25.0, 29.97, 30.0, 49.0, 60.0}) {
    scene.fps = fps;
    for (int frame = 1; frame < 2000; ++frame) {
      const double shown = (frame - 1) / fps, next = frame / fps;
      EXPECT_EQ(frame_at(scene, shown), frame);
      EXPECT_EQ(std::floor(frame_at(scene, std::nextafter(shown, 1e9))), frame);
      EXPECT_EQ(std::floor(frame_at(scene, std::nextafter(next, 0.0))), frame);
    }
    EXPECT_NEAR(frame_at(scene, 10.5 / fps), 11.5, 1e-12);
  }
}

TEST(Timeline, StatesFollowTheDrawsByTheirNames) {
  const Scene scene = with_chain(runner_chain());
  const Timeline timeline(scene, 7, 30);
  StateId state = 0;
  for (unsigned k = 1; k <= 30; ++k) {
    EXPECT_EQ(timeline.markov(0, k).state, state) << "frame " << k;
    state = step(scene.chains[0], state, random_bits(7, Stream::markov, k - 1, 0));
  }
}

TEST(Timeline, AHeldStateIsDrawnOnceInHoldFrames) {
  MarkovChain slow = flip_chain();
  slow.hold = 3;
  const Scene scene = with_chain(slow);
  // Frame k has made floor((k-1)/3) draws.
  EXPECT_EQ(states(Timeline(scene, 1, 10), 10),
            (std::vector<StateId>{0, 0, 0, 1, 1, 1, 0, 0, 0, 1}));
}

TEST(Timeline, HoldStretchesTheSameStates) {
  const Scene quick = with_chain(runner_chain());
  MarkovChain held = runner_chain();
  held.hold = 4;
  const Scene slow = with_chain(held);
  const Timeline a(quick, 3, 25), b(slow, 3, 100);
  for (unsigned k = 1; k <= 100; ++k)
    EXPECT_EQ(b.markov(0, k).state, a.markov(0, (k - 1) / 4 + 1).state);
}

TEST(Timeline, SubStatesCycleWithoutADraw) {
  const Scene scene = with_chain(still_chain(), {{Look{}, Look{}, Look{}}});
  const Timeline timeline(scene, 1, 8);
  for (unsigned k = 1; k <= 8; ++k) EXPECT_EQ(timeline.markov(0, k).sub_state, (k - 1) % 3);
}

TEST(Timeline, SubStatesStartOverWhenTheStateIsEnteredAnew) {
  MarkovChain flip = flip_chain();
  flip.hold = 2;  // A has three sub-states but two frames at a time
  const Scene scene = with_chain(flip, {{Look{}, Look{}, Look{}}, {}});
  const Timeline timeline(scene, 1, 6);
  const std::vector<std::uint32_t> expected = {0, 1, 0, 0, 0, 1};
  for (unsigned k = 1; k <= 6; ++k) EXPECT_EQ(timeline.markov(0, k).sub_state, expected[k - 1]);
}

TEST(Timeline, DieIsNeverLeft) {
  const Scene scene = with_chain(runner_chain());
  unsigned died = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Timeline timeline(scene, seed, 60);
    bool dead = false;
    for (const StateId state : states(timeline, 60)) {
      EXPECT_TRUE(!dead || state == 3);
      dead = dead || state == 3;
    }
    died += dead ? 1 : 0;
  }
  EXPECT_EQ(died,
            200U);  // 59 steps at about 5.6 expected: surviving has odds of 1e-5 for all seeds
}

TEST(Timeline, SeedsAndEntitiesDrawIndependently) {
  Scene scene = with_chain(runner_chain());
  add_box(scene, {0, 0});
  scene.entities[1].markov = scene.entities[0].markov;
  int seeds_differ = 0, entities_differ = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Timeline timeline(scene, seed, 20), other(scene, seed + 1000, 20);
    seeds_differ += states(timeline, 20) != states(other, 20) ? 1 : 0;
    entities_differ += states(timeline, 20, 0) != states(timeline, 20, 1) ? 1 : 0;
  }
  EXPECT_GT(seeds_differ, 40);
  EXPECT_GT(entities_differ, 40);
}

TEST(Timeline, PositionIsTheSumOfTheVelocitiesSoFar) {
  // Frames: A A B B A A, velocities 2, 5 (second sub-state of A), none of its own (entity's 12).
  MarkovChain flip = flip_chain();
  flip.hold = 2;
  Scene scene = with_chain(flip, {{moving({2, 0}), moving({5, 1})}, {Look{}}});
  scene.fps = 4;
  const Timeline timeline(scene, 1, 6);
  const std::vector<Vec2> sums = {{0, 0}, {2, 0}, {7, 1}, {19, 1}, {31, 1}, {33, 1}};
  for (unsigned k = 1; k <= 6; ++k) EXPECT_EQ(timeline.markov(0, k).moved, sums[k - 1] / 4);
}

// Steps of 1e400 there and back, each of which is held at what a scene holds.
TEST(Timeline, StepsBeyondAllDoublesAreHeld) {
  Scene scene = with_chain(flip_chain(), {{moving({1e300, 0})}, {moving({-1e300, 0})}});
  scene.fps = 1e-100;
  const Timeline timeline(scene, 1, 5);
  for (unsigned k = 1; k <= 5; ++k)
    EXPECT_EQ(timeline.markov(0, k).moved, Vec2(k % 2 == 0 ? 1e300 : 0, 0)) << k;
}

TEST(Timeline, AStateWithoutLooksKeepsTheEntitysVelocity) {
  const Scene scene = with_chain(still_chain());
  EXPECT_EQ(Timeline(scene, 1, 5).markov(0, 5).moved, Vec2(48, 0));
}

}  // namespace
}  // namespace flatray
