#include <gtest/gtest.h>

#include "oracle/families.h"
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

// A slope that goes up along `way`, a block that stands on it from 15 to 16 of these, and a box on it.
std::vector<SimulatedBody> on_slope(const Vec2& way, double from, const Vec2& velocity) {
  const Vec2 up(-way.y(), way.x());
  const ShapePart slope{{-9 * way, Vec2(20 * way.x(), -20 * way.y()), 20 * way}, 0};
  const Vec2 foot = 15 * way + 0.25 * up;
  const ShapePart block{{foot, foot + way, foot + way + 5 * up, foot + 5 * up}, 0};
  return {{{slope, block}, {0, 0}, {0, 0}, kInfinity},
          {{{{{0, 0}, way, way + up, up}, 0}}, from * way, velocity, 1}};
}

// Its normal is rounded, so that it comes nearer by less than a velocity has bits.
TEST(Jams, WhatGlidesAlongASlopeIsNotJammed) {
  oracle::Draw draw(53, 1, 0);
  for (const Vec2& way : {Vec2(3, 1), Vec2(1, 3), Vec2(4, 3), Vec2(5, 2), Vec2(7, 3)})
    for (int i = 0; i < 40; ++i) {
      const double from = draw.unit(), speed = 1 + draw.unit();
      const Simulation done =
          simulate(on_slope(way, from, speed * way), Response::bounce, 14 / speed + 1);
      ASSERT_TRUE(done.complete) << way.transpose() << " from " << from << " at " << speed;
      EXPECT_LT(done.events.size(), 9U);
      for (const Stage& stage : done.stages[1])  // it stays on the slope
        EXPECT_GT(cross(way, stage.at) / way.norm(), -1e-9);
      EXPECT_LT((done.stages[1].back().velocity + speed * way).norm(), 1e-9)
          << "not turned by the block";
    }
}

// Each of three bodies in one line is met again while the others are; below a lid velocities change by their
// last bits.
TEST(Jams, WhatGlidesAlongManyBodiesIsNotJammed) {
  oracle::Draw draw(53, 2, 0);
  for (const Vec2& way : {Vec2(3, 1), Vec2(1, 3), Vec2(0.7, 0.9), Vec2(5, 2), Vec2(-7, 3)})
    for (int i = 0; i < 40; ++i) {
      const double from = draw.unit(), speed = 1 + draw.unit();
      std::vector<SimulatedBody> bodies = on_slope(way, from, speed * way);
      bodies[0].parts.pop_back();
      const Vec2 up(-way.y(), way.x());
      const auto along = [&](double first, double last, double low, double high) {
        const ShapePart part{{first * way + low * up, last * way + low * up, last * way + high * up,
                              first * way + high * up},
                             0};
        bodies.push_back({{part}, {0, 0}, {0, 0}, kInfinity});
      };
      along(-4, 11, -2, 0);
      along(0, 7, -1, 0);
      if (i % 2 == 1) along(-9, 20, 1, 2);  // a lid
      const Simulation done = simulate(bodies, i % 4 < 2 ? Response::bounce : Response::slide, 4);
      ASSERT_TRUE(done.complete) << way.transpose() << " from " << from << " at " << speed;
      for (const Stage& stage : done.stages[1]) EXPECT_GT(cross(way, stage.at) / way.norm(), -1e-9);
    }
}

// One that rides on what moves, and one that stands, have stopped: neither is moved, and they are jammed.
TEST(Jams, WhatIsCarriedIntoWhatHasStoppedDoesNotPassIt) {
  std::vector<SimulatedBody> bodies = {box({0, -1}, {50, 1}, {1, 0}, kInfinity),
                                       box({0, 1.5}, {1, 1}, {0, -1}, 1),
                                       box({6, 2}, {1, 1}, {0, 0}, 1)};
  const Simulation done = simulate(bodies, Response::stop, 9);
  EXPECT_TRUE(done.jammed);
  EXPECT_EQ(done.jam, 4.5);
}

// Along a slope, up or down, with what is pushed and has stopped on it.
TEST(Jams, WhatStopsIsTakenAlongASlope) {
  for (const Vec2& way : {Vec2(3, 1), Vec2(1, 3), Vec2(4, 3), Vec2(5, 2), Vec2(7, 3)})
    for (const double speed : {0.75, -0.75}) {
      const Vec2 up(-way.y(), way.x());
      std::vector<SimulatedBody> bodies = on_slope(way, 1, {0, 0});
      bodies[0].parts.pop_back();  // without its block
      bodies[1].at += up;
      bodies[1].velocity = -0.5 * up;
      bodies.push_back(bodies[1]);
      bodies[2].mass = kInfinity;
      bodies[2].at = (speed > 0 ? -3.0 : 5.0) * way + 0.125 * up;
      bodies[2].velocity = speed * way;
      const Simulation done = simulate(bodies, Response::stop, 9);
      EXPECT_TRUE(done.complete) << way.transpose() << " at " << speed;
      EXPECT_EQ(done.stages[1].back().velocity, speed * way);
    }
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

// Between a wall and what is n times as heavy a ball is hit floor(pi sqrt(n)) times, fewer with what it begins with:
// Galperin 2003.
TEST(Jams, WhatCanBeMovedIsTurnedInTheEnd) {
  const auto hits = [](double heavy) {
    const SimulatedBody bodies[] = {box({-1, 0}, {1, 1}, {0, 0}, kInfinity),
                                    box({1.25, 0}, {0.25, 0.5}, {0, 0}, 1),
                                    box({2.5, 0}, {0.5, 1}, {-1, 0}, heavy)};
    const Simulation done = simulate(bodies, Response::bounce, 100);
    EXPECT_FALSE(done.jammed) << heavy;
    EXPECT_TRUE(done.complete) << heavy;
    return done.events.size();
  };
  EXPECT_EQ(hits(1e4), 314U);
  EXPECT_EQ(hits(1e6), 3141U);
  EXPECT_EQ(hits(1e7), 9934U);
}

// It leaves at 0.7495, before the walls have closed in to its width at 0.75.
TEST(Jams, WhatSlipsOutBesideIsNotJammed) {
  const auto done = [](double beside) {
    const SimulatedBody bodies[] = {box({-0.5, 0}, {0.5, 1}, {0, 0}, kInfinity),
                                    box({1.5, 0}, {0.5, 1}, {-1, 0}, kInfinity),
                                    box({0.5, 0}, {0.125, 0.125}, {1, beside}, 1)};
    return simulate(bodies, Response::bounce, 0.9);
  };
  EXPECT_FALSE(done(1.501).jammed);
  EXPECT_FALSE(done(1.51).jammed);
  EXPECT_TRUE(done(1.49).jammed);
}

// Each of them is hit ever faster, by a wall and by the other.
TEST(Jams, OfTwoBetweenWallsIsOne) {
  std::vector<SimulatedBody> bodies = between_walls(1, 0);
  bodies.back() = disc({-1.5, 0}, 1, {0.75, 0});
  bodies.push_back(disc({1.5, 0}, 1, {-0.5, 0}));
  const Simulation done = simulate(bodies, Response::bounce, 10, 100'000);
  EXPECT_TRUE(done.jammed);
  EXPECT_NEAR(done.jam, 2, 0.01);
  EXPECT_LT(done.events.size(), 100'000U);
}

}  // namespace
}  // namespace flatray
