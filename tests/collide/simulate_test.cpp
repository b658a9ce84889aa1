// needs: shapes/circle
#include "collide/simulate.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "full_counts.h"
#include "oracle/families.h"
#include "simulated_bodies.h"
#include "support/pictures.h"

namespace flatray {
namespace {

using namespace flatray::testing;
using oracle::Draw;

TEST(Simulate, EqualDiscsExchangeTheirVelocities) {
  const SimulatedBody bodies[] = {disc({0, 0}, 1, {1, 0}), disc({6, 0}, 1, {-1, 0})};
  const Simulation done = simulate(bodies, Response::bounce, 10);
  ASSERT_EQ(done.events.size(), 1U);
  EXPECT_EQ(done.events[0].time, 2);
  EXPECT_EQ(done.events[0].point, Vec2(3, 0));
  EXPECT_EQ(done.events[0].normal, Vec2(1, 0));
  EXPECT_EQ(done.events[0].velocity_a, Vec2(-1, 0));
  EXPECT_EQ(done.events[0].velocity_b, Vec2(1, 0));
  EXPECT_EQ(place_at(done.stages[0], 1), Vec2(1, 0));
  EXPECT_EQ(place_at(done.stages[0], 5), Vec2(-1, 0));
}

TEST(Simulate, WhatStopsStandsStillAndWhatIsMarkedGoesOn) {
  const SimulatedBody bodies[] = {disc({0, 0}, 1, {1, 0}), disc({6, 0}, 1, {-1, 0})};
  const Simulation stopped = simulate(bodies, Response::stop, 10);
  EXPECT_EQ(place_at(stopped.stages[0], 9), Vec2(2, 0));
  EXPECT_EQ(place_at(stopped.stages[1], 9), Vec2(4, 0));
  const Simulation marked = simulate(bodies, Response::mark, 10);
  ASSERT_EQ(marked.events.size(), 1U);
  EXPECT_EQ(place_at(marked.stages[0], 9), Vec2(9, 0));
}

TEST(Simulate, WhatStopsAtSomethingFixedThatMovesGoesWithIt) {
  const SimulatedBody bodies[] = {disc({0, 0}, 1, {1, 0}, kInfinity), disc({6, 0}, 1, {-1, 0})};
  const Simulation stopped = simulate(bodies, Response::stop, 10);
  ASSERT_EQ(stopped.events.size(), 1U);
  EXPECT_EQ(place_at(stopped.stages[0], 9), Vec2(9, 0));
  EXPECT_EQ(place_at(stopped.stages[1], 9), Vec2(11, 0));
}

TEST(Simulate, AThrustGoesThroughARowOfDiscsThatTouch) {
  std::vector<SimulatedBody> row = {disc({0, 0}, 1, {1, 0})};
  for (int i = 0; i < 5; ++i) row.push_back(disc({4.0 + 2 * i, 0}, 1, {0, 0}));
  const Simulation done = simulate(row, Response::bounce, 100);
  ASSERT_EQ(done.events.size(), 5U);
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(done.events[i].time, 2);
    EXPECT_EQ(done.events[i].a, i);
    EXPECT_EQ(done.events[i].b, i + 1);
  }
  EXPECT_EQ(done.stages[0].back().velocity, Vec2(0, 0));
  EXPECT_EQ(done.stages[5].back().velocity, Vec2(1, 0));
}

TEST(Simulate, AWallThinnerThanAnyStepStopsABodyOf300000KilometresASecond) {
  const SimulatedBody bodies[] = {box({0, 0}, {0x1p-10, 0x1p-10}, {3e8, 0}, 1),
                                  box({1, 0}, {0x1p-41, 8}, {0, 0}, kInfinity)};
  const Simulation done = simulate(bodies, Response::bounce, 1);
  ASSERT_EQ(done.events.size(), 1U);
  EXPECT_EQ(done.events[0].time, (1 - 0x1p-10 - 0x1p-41) / 3e8);
  EXPECT_EQ(done.events[0].velocity_a, Vec2(-3e8, 0));
}

struct Sums {
  Vec2 momentum{0, 0};
  double energy = 0;
};

// Four walls of infinite mass about [0, 20]^2, discs and boxes on a grid in them.
std::vector<SimulatedBody> gas(std::uint64_t seed, int across) {
  std::vector<SimulatedBody> bodies = {
      box({-1, 10}, {1, 12}, {0, 0}, kInfinity), box({21, 10}, {1, 12}, {0, 0}, kInfinity),
      box({10, -1}, {12, 1}, {0, 0}, kInfinity), box({10, 21}, {12, 1}, {0, 0}, kInfinity)};
  const double cell = 20.0 / across;
  for (int i = 0; i < across * across; ++i) {
    Draw draw(seed, 1, static_cast<std::uint64_t>(i));
    const Vec2 at((i % across + 0.5) * cell, (std::floor(i / across) + 0.5) * cell);
    const double vx = 2 * draw.unit() - 1, vy = 2 * draw.unit() - 1, mass = 0.5 + draw.unit();
    const double size = 0.2 * cell;
    bodies.push_back(i % 2 == 0 ? disc(at, size, {vx, vy}, mass)
                                : box(at, {size, 0.7 * size}, {vx, vy}, mass));
  }
  return bodies;
}

double energy(const std::vector<SimulatedBody>& bodies, const Simulation& done) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].mass < kInfinity)
      sum += 0.5 * bodies[i].mass * done.stages[i].back().velocity.squaredNorm();
  return sum;
}

TEST(Simulate, AGasKeepsItsEnergyAndLeavesNoOverlapAndStaysInItsRoom) {
  const std::vector<SimulatedBody> bodies = gas(3, 10);
  const Simulation none = simulate(bodies, Response::bounce, 0);
  const Simulation done = simulate(bodies, Response::bounce, 200, 5000);
  ASSERT_EQ(done.events.size(), 5000U);
  const double before = energy(bodies, none);
  EXPECT_LE(std::fabs(energy(bodies, done) - before), 1e-12 * before);
  for (std::size_t i = 1; i < done.events.size(); ++i)
    ASSERT_LE(done.events[i - 1].time, done.events[i].time);
  const double now = done.events.back().time;
  for (std::size_t i = 4; i < bodies.size(); ++i) {
    const Vec2 at = place_at(done.stages[i], now);
    EXPECT_TRUE((at.array() > 0).all() && (at.array() < 20).all()) << i;
    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
      if (bodies[i].parts[0].radius == 0 || bodies[k].parts[0].radius == 0) continue;
      EXPECT_GE((place_at(done.stages[k], now) - at).norm(),
                2 * bodies[i].parts[0].radius * (1 - 1e-12));
    }
  }
}

TEST(Simulate, ABounceKeepsMomentumWhateverTheMasses) {
  for (std::uint64_t item = 0; item < 50; ++item) {
    Draw draw(9, 2, item);
    const double vx = draw.unit(), vy = draw.unit() - 0.5, heavy = 1 + 100 * draw.unit();
    const SimulatedBody bodies[] = {disc({0, 0}, 1, {vx, vy}, heavy),
                                    disc({5, 0.5}, 1, {-1, 0}, 1)};
    const Simulation done = simulate(bodies, Response::bounce, 20);
    const Vec2 before = heavy * bodies[0].velocity + bodies[1].velocity;
    const Vec2 after = heavy * done.stages[0].back().velocity + done.stages[1].back().velocity;
    EXPECT_NEAR((after - before).norm(), 0, 1e-13 * heavy);
  }
}

// Only the ratio of masses counts, to the last double there is.
TEST(Simulate, EqualMassesExchangeVelocitiesHoweverLightOrHeavy) {
  for (const double mass : {5e-324, 1e-308, 1e307, 1e308})
    for (const double speed : {4.0, 1000.0, 0x1p-600, 0x1p600}) {
      const SimulatedBody bodies[] = {disc({0, 0}, 1, {speed, 0}, mass),
                                      disc({8, 0}, 1, {0, 0}, mass)};
      const Simulation done = simulate(bodies, Response::bounce, 10 / speed);
      ASSERT_EQ(done.events.size(), 1U) << mass << ' ' << speed;
      EXPECT_NEAR(done.events[0].velocity_a.x(), 0, 1e-15 * speed) << mass << ' ' << speed;
      EXPECT_NEAR(done.events[0].velocity_b.x(), speed, 1e-15 * speed) << mass << ' ' << speed;
    }
}

TEST(Simulate, BesideTheHeaviestTheLightestIsThrownAtTwiceItsSpeed) {
  const SimulatedBody bodies[] = {disc({0, 0}, 1, {4, 0}, 1e308), disc({8, 0}, 1, {0, 0}, 5e-324)};
  const Simulation done = simulate(bodies, Response::bounce, 10);
  ASSERT_EQ(done.events.size(), 1U);
  EXPECT_EQ(done.events[0].velocity_a, Vec2(4, 0));
  EXPECT_EQ(done.events[0].velocity_b, Vec2(8, 0));
}

TEST(Simulate, AnEntityTooSmallOrTooLargeForAMassByItsAreaIsRefused) {
  const auto bodies_at = [](int exponent, const std::string& second) {
    const auto n = [exponent](double x) { return fmt::format("{}", std::ldexp(x, exponent)); };
    const Scene scene = scene_of(
        "flatray = 1\nfps = 1\nframes = 9\n"
        "[[entity]]\nname = \"given\"\nshape = { circle = { radius = " +
        n(1) + " } }\nvelocity = [" + n(4) +
        ", 0]\nmass = 3\n"
        "[[entity]]\nname = \"by_area\"\nshape = { circle = { radius = " +
        n(1) + " } }\nat = [" + n(8) + ", 0]\n" + second);
    return bodies_of(Timeline(scene, 0, 9), Response::bounce, {});
  };
  for (const int exponent : {-600, 600}) {
    const auto bodies = bodies_at(exponent, "");
    ASSERT_FALSE(bodies) << exponent;
    const std::string told = format(bodies.error());
    EXPECT_NE(told.find(":9:1: error: entity 'by_area' is too"), std::string::npos) << told;
    EXPECT_TRUE(bodies_at(exponent, "mass = 1\n")) << exponent;
    EXPECT_TRUE(bodies_at(exponent, "mass = \"fixed\"\n")) << exponent;
  }
  EXPECT_TRUE(bodies_at(-300, ""));
}

// Points and parallel segments never overlap: of their meetings nothing would be seen.
TEST(Simulate, PairsThatCannotOverlapAreRefusedWhereOneOfThemCanBeMoved) {
  const auto refused = [](const std::string& one, const std::string& other) {
    const Scene scene = scene_of(
        "flatray = 1\nfps = 1\nframes = 9\ncollisions = { response = \"bounce\" }\n"
        "[[entity]]\nname = \"a\"\nvelocity = [1, 0]\n" +
        one + "\n[[entity]]\nname = \"b\"\nat = [3, 0]\n" + other + "\n");
    const auto bodies = bodies_of(Timeline(scene, 0, 9), std::nullopt, {});
    return bodies ? "" : format(bodies.error());
  };
  const std::string upright = "shape = { segment = { from = [0, -2], to = [0, 2] } }",
                    taller = "shape = { segment = { from = [0, -3], to = [0, 7] } }",
                    level = "shape = { segment = { from = [0, 0], to = [1, 0] } }",
                    disc = "shape = { circle = { radius = 1 } }", moved = "\nmass = 1";
  EXPECT_NE(
      refused(upright + moved, taller).find(":5:1: error: entity 'a' and entity 'b' have no area"),
      std::string::npos);
  EXPECT_NE(refused(upright, taller + moved), "");
  EXPECT_EQ(refused(upright, taller), "");
  EXPECT_EQ(refused(upright + moved, level), "");
  EXPECT_EQ(refused(upright + moved, disc), "");
  EXPECT_EQ(refused(upright + moved, taller + "\nresponse = \"none\""), "");
}

// Lengths times a power of two: the same events at the same times, velocities times the power.
TEST(Simulate, TheSameAtAnyScale) {
  const auto done_at = [](int exponent) {
    const auto n = [exponent](double x) { return fmt::format("{}", std::ldexp(x, exponent)); };
    const Scene scene = scene_of(
        "flatray = 1\nfps = 1\nframes = 12\n"
        "[[entity]]\nname = \"a\"\nshape = { circle = { radius = " +
        n(1) +
        " } }\n"
        "at = [" +
        n(-3) + ", 0]\nvelocity = [" + n(1) +
        ", 0]\n"
        "[[entity]]\nname = \"b\"\nshape = { circle = { radius = " +
        n(1) +
        " } }\n"
        "at = [0, " +
        n(1) +
        "]\n"
        "[[entity]]\nname = \"c\"\nshape = { box = { min = [" +
        n(-1) + ", " + n(-1) + "], max = [" + n(1) + ", " + n(1) + "] } }\nat = [" + n(3) + ", " +
        n(2.5) + "]\n");
    return flatray::simulate(*bodies_of(Timeline(scene, 0, 12), Response::bounce, {}), 11);
  };
  const Simulation one = done_at(0);
  ASSERT_EQ(one.events.size(), 2U);
  for (const int exponent : {-1000, -600, 600, 990}) {
    SCOPED_TRACE(exponent);
    const Simulation done = done_at(exponent);
    ASSERT_EQ(done.events.size(), one.events.size());
    for (std::size_t i = 0; i < one.events.size(); ++i) {
      EXPECT_NEAR(done.events[i].time, one.events[i].time, 1e-13);
      EXPECT_NEAR((done.events[i].normal - one.events[i].normal).norm(), 0, 1e-13);
      const Vec2 velocity(std::ldexp(done.events[i].velocity_b.x(), -exponent),
                          std::ldexp(done.events[i].velocity_b.y(), -exponent));
      EXPECT_NEAR((velocity - one.events[i].velocity_b).norm(), 0, 1e-13);
    }
  }
}

// Tangent of a slope of 3-4-5: the velocity along it stays, and the one against it goes.
TEST(Simulate, WhatSlidesKeepsItsVelocityAlongTheContact) {
  const SimulatedBody slope{{{{{0, 0}, {8, 0}, {8, 6}}, 0}}, {0, 0}, {0, 0}, kInfinity};
  const SimulatedBody bodies[] = {slope, disc({4, 8}, 1, {0, -5})};
  const Simulation done = simulate(bodies, Response::slide, 1);
  ASSERT_EQ(done.events.size(), 1U);
  EXPECT_EQ(done.events[0].time, (8 - 3 - 1.25) / 5);
  const Vec2 along(0.8, 0.6), across(-0.6, 0.8), after = done.events[0].velocity_b;
  EXPECT_NEAR(after.dot(along), -3, 1e-14);
  EXPECT_NEAR(after.dot(across), 0, 4 * 0x1p-39);
  EXPECT_GT(after.dot(across), 0);
}

TEST(Simulate, TwoThatSlideKeepMomentumAndGoOnTogetherAlongTheNormal) {
  const SimulatedBody bodies[] = {box({0, 0}, {1, 1}, {3, 0.25}, 1),
                                  box({5, 0}, {1, 1}, {0, -0.25}, 2)};
  const Simulation done = simulate(bodies, Response::slide, 10);
  ASSERT_EQ(done.events.size(), 1U);
  EXPECT_NEAR(done.events[0].velocity_a.x(), 1, 1e-11);
  EXPECT_NEAR(done.events[0].velocity_b.x(), 1, 1e-11);
  EXPECT_EQ(done.events[0].velocity_a.y(), 0.25);
  EXPECT_EQ(done.events[0].velocity_b.y(), -0.25);
  EXPECT_NEAR(done.events[0].velocity_a.x() + 2 * done.events[0].velocity_b.x(), 3, 1e-15);
}

// From wall to wall of an acute corner it loses all its speed by a factor at a time: some hundred events.
TEST(Simulate, WhatSlidesIntoACornerIsNotJammed) {
  for (std::uint64_t item = 0; item < 200; ++item) {
    Draw draw(11, 3, item);
    const double tilt = draw.unit() - 0.5, vx = 1 + 9 * draw.unit(), vy = -1 - 9 * draw.unit();
    const SimulatedBody floor{
        {{{{-50, -1}, {50, -1}, {50, 0}, {-50, 0}}, 0}}, {0, 0}, {0, 0}, kInfinity};
    const SimulatedBody wall{{{{{0, -50}, {9, -50}, {9 + 50 * tilt, 50}, {50 * tilt, 50}}, 0}},
                             {10, 0},
                             {0, 0},
                             kInfinity};
    const SimulatedBody bodies[] = {floor, wall, box({-20, 10}, {1, 0.7}, {vx, vy}, 1)};
    const Simulation done = simulate(bodies, Response::slide, 1000, 1000);
    EXPECT_TRUE(done.complete) << item;
    EXPECT_GE(done.stages[2].back().at.y(), 0.7 - 1e-12) << item;
  }
}

TEST(Simulate, WhatIsRemovedIsAWallToWhoMeetsItAndThenGone) {
  SimulatedBody brick = box({5, 0}, {1, 1}, {0, 0}, 1);
  brick.response = Response::remove;
  const SimulatedBody bodies[] = {disc({0, 0}, 1, {1, 0}), brick, disc({11, 0}, 1, {-1, 0})};
  const Simulation done = flatray::simulate(bodies, 20);
  ASSERT_EQ(done.events.size(), 1U);  // the third flies through where it was, behind the first
  EXPECT_EQ(done.events[0].velocity_a, Vec2(-1, 0));
  EXPECT_FALSE(stage_at(done.stages[1], 2.5).gone);
  EXPECT_TRUE(stage_at(done.stages[1], 3).gone);
  EXPECT_EQ(place_at(done.stages[1], 9), Vec2(5, 0));
}

void expect_same(const Simulation& one, const Simulation& other) {
  EXPECT_EQ(one.complete, other.complete);
  EXPECT_EQ(one.jammed, other.jammed);
  EXPECT_EQ(one.overlaps, other.overlaps);
  ASSERT_EQ(one.events.size(), other.events.size());
  for (std::size_t i = 0; i < one.events.size(); ++i) {
    const CollisionEvent &a = one.events[i], &b = other.events[i];
    ASSERT_EQ(a.time, b.time) << i;
    ASSERT_EQ(a.a, b.a) << i;
    ASSERT_EQ(a.b, b.b) << i;
    ASSERT_EQ(a.point, b.point) << i;
    ASSERT_EQ(a.normal, b.normal) << i;
    ASSERT_EQ(a.velocity_a, b.velocity_a) << i;
    ASSERT_EQ(a.velocity_b, b.velocity_b) << i;
  }
  for (std::size_t i = 0; i < one.stages.size(); ++i)
    ASSERT_EQ(one.stages[i].size(), other.stages[i].size()) << i;
}

TEST(Simulate, PairsThatComeNearGiveTheEventsOfAllPairs) {
  for (const int across : {3, 10, kSanitized ? 12 : 24}) {
    const std::vector<SimulatedBody> bodies = gas(5, across);
    const std::size_t events = times(6000);
    const Simulation near = flatray::simulate(bodies, 1e6, events, PairSearch::near);
    ASSERT_EQ(near.events.size(), events);
    expect_same(near, flatray::simulate(bodies, 1e6, events, PairSearch::all));
  }
}

// Of all sizes and speeds, near and far, at rest and in each other, with any response.
TEST(Simulate, PairsThatComeNearGiveTheEventsOfAllPairsOfBodiesOfAnyKind) {
  constexpr Response kAll[] = {Response::none,   Response::mark,  Response::stop,
                               Response::bounce, Response::slide, Response::remove};
  const std::uint64_t items = times(120);
  std::size_t events = 0;
  for (std::uint64_t item = 0; item < items; ++item) {
    Draw draw(21, 1, item);
    const double room = std::pow(10, 6 * draw.unit() - 2), far = std::pow(10, 3 * draw.unit());
    std::vector<SimulatedBody> bodies;
    for (int i = 0; i < 60; ++i) {
      const double x = room * (draw.unit() - 0.5), y = room * (draw.unit() - 0.5);
      const double size = room * std::pow(10, -3 * draw.unit() - 0.5);
      const double fast = draw.unit() < 0.3 ? 0 : room * std::pow(10, 4 * draw.unit() - 2);
      const double angle = 6.28 * draw.unit(), away = draw.unit() < 0.1 ? far : 1;
      const Vec2 at(away * x, away * y), velocity(fast * std::cos(angle), fast * std::sin(angle));
      const double mass = draw.unit() < 0.1 ? kInfinity : 0.5 + draw.unit();
      bodies.push_back(i % 2 == 0 ? disc(at, size, velocity, mass)
                                  : box(at, {size, 0.5 * size}, velocity, mass));
      bodies.back().response =
          item % 2 == 0 ? Response::bounce : kAll[static_cast<std::size_t>(draw.below(6))];
    }
    const Simulation near = flatray::simulate(bodies, 20, 300, PairSearch::near);
    events += near.events.size();
    expect_same(near, flatray::simulate(bodies, 20, 300, PairSearch::all));
    if (HasFatalFailure()) FAIL() << item;
  }
  EXPECT_GT(events, 80 * items);
}

// Lengths of so few units in the last place are off by a third.
TEST(Simulate, BodiesThatAreHardlyDoublesMeet) {
  constexpr double kUnit = 0x1p-1074;
  const SimulatedBody bodies[] = {disc({-10 * kUnit, -10 * kUnit}, 2 * kUnit, {kUnit, kUnit}),
                                  disc({0, 0}, 2 * kUnit, {0, 0})};
  const Simulation done = simulate(bodies, Response::bounce, 20);
  ASSERT_EQ(done.events.size(), 1U);
  EXPECT_NEAR(done.events[0].time, 10 - 2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(done.events[0].normal.x(), std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace flatray
