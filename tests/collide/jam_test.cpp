#include <gtest/gtest.h>

#include "simulated_bodies.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// Between two that nothing moves and that close in on it there is no way out.
TEST(Jams, WhatIsJammedIsToldAndEnds) {
  const SimulatedBody bodies[] = {disc({0, 0}, 1, {1, 0}, kInfinity), disc({6, 0}, 1, {0, 0}),
                                  disc({12, 0}, 1, {-1, 0}, kInfinity)};
  const Simulation done = simulate(bodies, Response::stop, 10);
  EXPECT_TRUE(done.jammed);
  EXPECT_EQ(done.jam, 4);
  EXPECT_TRUE(done.events.empty());  // both come at once
}

// The second of two walls that come one after the other is told, and not that the first comes again.
TEST(Jams, WhatStopsBetweenTwoWallsIsJammedOnce) {
  for (const double other : {-1.0, -0.25, 0.0}) {
    const SimulatedBody bodies[] = {box({0, 0}, {1, 9}, {1, 0}, kInfinity), disc({6, 0}, 1, {0, 0}),
                                    box({14.0 - 4 * other, 0}, {1, 9}, {other, 0}, kInfinity)};
    const Simulation done = simulate(bodies, Response::stop, 100);
    EXPECT_TRUE(done.jammed) << other;
    ASSERT_EQ(done.events.size(), 1U) << other;
    EXPECT_EQ(done.events[0].time, 4);
    EXPECT_GT(done.jam, 4);
  }
}

TEST(Jams, WhatStopsIsTakenAlongAWallThatStands) {
  const SimulatedBody bodies[] = {box({0, -2}, {50, 1}, {0, 0}, kInfinity),
                                  disc({0, 2}, 1, {0, -1}),
                                  box({-9, 5}, {1, 5.5}, {1, 0}, kInfinity)};
  const Simulation done = simulate(bodies, Response::stop, 20);
  EXPECT_TRUE(done.complete);
  EXPECT_EQ(done.events.size(), 2U);
  EXPECT_EQ(done.stages[1].back().velocity, Vec2(1, 0));
}

std::vector<SimulatedBody> between_walls(double closing, double beside) {
  return {box({-5, 0}, {1, 9}, {closing, 0}, kInfinity),
          box({5, 0}, {1, 9}, {-closing, 0}, kInfinity), disc({0.5, 0}, 1, {0.75, beside})};
}

// The gap of 8 has no room for the disc from t = 3 on; ever more hits come before.
TEST(Jams, HitsThatAccumulateAreAJam) {
  const Simulation done = simulate(between_walls(1, 0), Response::bounce, 10);
  EXPECT_TRUE(done.jammed);
  EXPECT_NEAR(done.jam, 3, 1e-5);
  EXPECT_LT(done.until, 3);
  EXPECT_EQ(done.untold.second, 2U);
  EXPECT_LT(done.events.size(), 5000U);
  EXPECT_GT(done.events.size(), 1000U);
}

TEST(Jams, HitsUpToATimeBeforeTheJamAreAllTold) {
  const Simulation done = simulate(between_walls(1, 0), Response::bounce, 2.9995);
  EXPECT_TRUE(done.complete);
  EXPECT_GT(done.events.size(), 2048U);
}

TEST(Jams, HitsBetweenWallsThatStandDoNotAccumulate) {
  const Simulation done = simulate(between_walls(0, 0), Response::bounce, 1e5, 10'000);
  EXPECT_FALSE(done.jammed);
  EXPECT_EQ(done.events.size(), 10'000U);
}

// It has gone out beside the walls before they meet it on both sides.
TEST(Jams, WhatGoesOutBetweenClosingWallsIsNotJammed) {
  const Simulation done = simulate(between_walls(1, 4), Response::bounce, 10);
  EXPECT_TRUE(done.complete);
  EXPECT_GT(done.events.size(), 1U);
}

}  // namespace
}  // namespace flatray
