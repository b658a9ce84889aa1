#include "collide/instant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oracle/families.h"
#include "simulated_bodies.h"

namespace flatray {
namespace {

using namespace flatray::testing;
using oracle::Draw;

// By name and not by number: of whom, when, and how they go on.
struct Told {
  double time;
  std::uint32_t a, b;
  Vec2 velocity_a, velocity_b;
};
auto key(const Told& told) { return std::tuple(told.time, told.a, told.b); }

// What bodies do in another order, under the numbers they have in the first. Events of one time are
// sorted: which of them come first is by number.
std::vector<Told> told_in_order(const std::vector<SimulatedBody>& bodies,
                                const std::vector<std::uint32_t>& order, double end) {
  std::vector<SimulatedBody> placed;
  for (const std::uint32_t i : order) placed.push_back(bodies[i]);
  std::vector<Told> all;
  for (const CollisionEvent& e : flatray::simulate(placed, end).events) {
    Told told{e.time, order[e.a], order[e.b], e.velocity_a, e.velocity_b};
    if (told.a > told.b) {
      std::swap(told.a, told.b);
      std::swap(told.velocity_a, told.velocity_b);
    }
    all.push_back(told);
  }
  std::sort(all.begin(), all.end(), [](const Told& a, const Told& b) { return key(a) < key(b); });
  return all;
}

void expect_same(const std::vector<Told>& one, const std::vector<Told>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(key(one[i]), key(other[i])) << i;
    ASSERT_EQ(one[i].velocity_a, other[i].velocity_a) << i;
    ASSERT_EQ(one[i].velocity_b, other[i].velocity_b) << i;
  }
}

std::vector<SimulatedBody> all_respond(std::vector<SimulatedBody> bodies, Response response) {
  for (SimulatedBody& body : bodies) body.response = response;
  return bodies;
}

TEST(Instants, ACueThatHitsTwoDiscsAtOnceHitsThemInNoOrder) {
  const std::vector<SimulatedBody> bodies = all_respond(
      {disc({0, 0}, 2.5, {1, 0}), disc({8, 3}, 2.5, {0, 0}), disc({8, -3}, 2.5, {0, 0})},
      Response::bounce);
  std::vector<std::uint32_t> order{0, 1, 2};
  const std::vector<Told> first = told_in_order(bodies, order, 10);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0].time, 4);
  EXPECT_EQ(first[1].time, 4);
  EXPECT_NEAR(first[0].velocity_a.x(), -7.0 / 57, 0x1p-53);
  EXPECT_EQ(first[0].velocity_a.y(), 0);
  EXPECT_NEAR(first[0].velocity_b.x(), 32.0 / 57, 0x1p-53);
  EXPECT_EQ(first[0].velocity_b.x(), first[1].velocity_b.x());
  EXPECT_EQ(first[0].velocity_b.y(), -first[1].velocity_b.y());
  while (std::next_permutation(order.begin(), order.end()))
    expect_same(first, told_in_order(bodies, order, 10));
}

// Of the angle of an equilateral triangle, to rounding: the cue goes back at a fifth.
TEST(Instants, ACueBetweenTwoDiscsThatTouchGoesBackAtAFifth) {
  const double high = 10 * std::sqrt(3);
  const std::vector<SimulatedBody> bodies =
      all_respond({disc({0, 0}, 10, {1, 0}), disc({1 + high, 10}, 10, {0, 0}),
                   disc({1 + high, -10}, 10, {0, 0})},
                  Response::bounce);
  const std::vector<Told> told = told_in_order(bodies, {0, 1, 2}, 5);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_NEAR(told[0].velocity_a.x(), -0.2, 4e-16);
  EXPECT_EQ(told[0].velocity_a.y(), 0);
  EXPECT_NEAR(told[0].velocity_b.x(), 0.6, 4e-16);
  EXPECT_NEAR(told[0].velocity_b.y(), 0.2 * std::sqrt(3), 4e-16);
}

// A floor and boxes above each other, all as fast; each lands on the one below and all stay there.
std::vector<SimulatedBody> falling(std::vector<double> masses) {
  std::vector<SimulatedBody> bodies{box({0, -1}, {5, 1}, {0, 0}, kInfinity)};
  for (std::size_t i = 0; i < masses.size(); ++i)
    bodies.push_back(
        box({0.1, 2.0 + 2.1 * static_cast<double>(i)}, {0.5, 0.5}, {0, -0.7}, masses[i]));
  return all_respond(std::move(bodies), Response::slide);
}

TEST(Instants, BoxesThatLandOnEachOtherLieStillAfterOneEventEach) {
  for (const std::vector<double>& masses : {std::vector<double>{1, 1},
                                            {1, 3},
                                            {3, 0.1},
                                            {1, 1, 1},
                                            {2, 0.3, 7},
                                            {1, 9, 1, 0.2, 5, 5}}) {
    const Simulation done = flatray::simulate(falling(masses), 1000);
    EXPECT_TRUE(done.complete);
    EXPECT_EQ(done.events.size(), masses.size());
    for (std::size_t i = 1; i < done.stages.size(); ++i) {
      EXPECT_EQ(done.stages[i].back().velocity, Vec2(0, 0)) << i;
      EXPECT_NEAR(place_at(done.stages[i], 1000).y(), static_cast<double>(i) - 0.5, 1e-14) << i;
      for (const Stage& stage : done.stages[i])  // nothing between rest and falling
        EXPECT_TRUE(stage.velocity.y() == 0 || stage.velocity.y() == -0.7) << stage.velocity.y();
    }
  }
}

// A pile at rest is pushed aside by what comes from the left, and only so: it does not sink.
TEST(Instants, WhatRestsSlidesOnWhereItLies) {
  std::vector<SimulatedBody> bodies = falling({1, 1});
  bodies.push_back(box({-40, 0.4}, {0.5, 0.25}, {4, 0}, 1));
  bodies.back().response = Response::slide;
  const Simulation done = flatray::simulate(bodies, 12);
  EXPECT_TRUE(done.complete);
  for (const std::size_t i : {1U, 2U}) EXPECT_EQ(done.stages[i].back().velocity.y(), 0);
  EXPECT_EQ(done.stages[1].back().velocity.x(), 2);
  EXPECT_EQ(done.stages[3].back().velocity, Vec2(2, 0));
  EXPECT_EQ(done.stages[2].back().velocity.x(), 0);
}

// Discs of several sizes that fall on a floor, each above those before.
std::vector<SimulatedBody> falling_discs(int count) {
  std::vector<SimulatedBody> bodies{box({5, -1}, {200, 1}, {0, 0}, kInfinity)};
  Draw draw(43, 1, 0);
  double top = 1;
  for (int i = 0; i < count; ++i) {
    const double radius = 0.3 + 0.3 * draw.unit(), x = 10 * draw.unit();
    bodies.push_back(disc({x, top + radius}, radius, {0, -1}, radius * radius));
    top += 2 * radius + 0.05;
  }
  return all_respond(std::move(bodies), Response::slide);
}

// What slides round another and is pushed against it at once again has not left it: so these are some
// dozens of events a disc, where they were hundreds, and more with each disc.
TEST(Instants, PilesOfDiscsComeToAnEnd) {
  for (const auto& [count, most] : {std::pair(20, 150U), {30, 800U}}) {
    const Simulation done = flatray::simulate(falling_discs(count), 1000);
    EXPECT_TRUE(done.complete) << count;
    EXPECT_LT(done.events.size(), most) << count;
  }
}

TEST(Instants, APileOfDiscsHasNoOrder) {
  const std::vector<SimulatedBody> bodies = falling_discs(20);
  std::vector<std::uint32_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::vector<Told> first = told_in_order(bodies, order, 1000);
  std::reverse(order.begin(), order.end());
  expect_same(first, told_in_order(bodies, order, 1000));
}

// It has slid off the edge of what it lay on before something lands on it: nothing holds it up.
TEST(Instants, WhatHasSlidOffIsHeldByNothing) {
  std::vector<SimulatedBody> bodies =
      all_respond({box({0, -1}, {5, 1}, {0, 0}, kInfinity), box({0, 2}, {0.5, 0.5}, {1, -1}, 1),
                   box({10.5, 22}, {0.5, 0.5}, {0, -2}, 1)},
                  Response::slide);
  const Simulation done = flatray::simulate(bodies, 30);
  ASSERT_EQ(done.events.size(), 2U);
  EXPECT_EQ(done.events[0].velocity_b, Vec2(1, 0));
  EXPECT_EQ(done.events[1].velocity_a, Vec2(1, -1));
  EXPECT_EQ(done.events[1].velocity_b, Vec2(0, -1));
}

TEST(Instants, AnOverlapOfOneUlpAtTheStartHolds) {
  ASSERT_LT(0.3 - 0.1, 0.2);
  for (const Response response : {Response::slide, Response::bounce, Response::stop}) {
    const std::vector<SimulatedBody> bodies = all_respond(
        {box({0, 0}, {5, 0.2}, {0, 0}, kInfinity), box({0, 0.3}, {0.1, 0.1}, {0, -1}, 1),
         disc({3, 0.3}, 0.1, {0, -1}), box({-3, 0.3}, {0.1, 0.1}, {0, 1}, 1)},
        response);
    const Simulation done = flatray::simulate(bodies, 10);
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(done.overlaps, (Pairs{{0, 1}, {0, 2}, {0, 3}}));
    ASSERT_EQ(done.events.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(done.events[i].time, 0);
      EXPECT_EQ(done.events[i].normal, Vec2(0, 1));
      EXPECT_EQ(done.events[i].velocity_b, Vec2(0, response == Response::bounce ? 1 : 0));
    }
  }
}

// From within, too, and for each kind of body the shortest way out.
TEST(Instants, WhatLiesInAnotherGoesOutTheShortestWay) {
  const SimulatedBody bar{{{{{-2, 0}, {2, 0}}, 0.5}}, {0, 0}, {0, 0}, kInfinity};
  for (const double side : {1.0, -1.0}) {
    for (const Vec2& velocity : {Vec2(0, -side), Vec2(0, side)}) {
      const Simulation done = testing::simulate(
          std::vector{bar, disc({1, 0.4 * side}, 0.5, velocity)}, Response::bounce, 10);
      EXPECT_EQ(done.overlaps.size(), 1U);
      EXPECT_EQ(done.events.size(), velocity.y() == side ? 0U : 1U) << side;
      EXPECT_EQ(done.stages[1].back().velocity, Vec2(0, side));
    }
  }
}

TEST(Instants, AJamIsToldAfterWhatCameBefore) {
  for (const Response response : {Response::slide, Response::bounce}) {
    const std::vector<SimulatedBody> bodies = all_respond(
        {disc({0, 0}, 1, {1, 0}, kInfinity), disc({6, 0}, 1, {0, 0}),
         disc({12, 0}, 1, {-1, 0}, kInfinity), disc({0, 50}, 1, {1, 0}), disc({3, 50}, 1, {0, 0})},
        response);
    const Simulation done = flatray::simulate(bodies, 10);
    EXPECT_TRUE(done.jammed);
    EXPECT_FALSE(done.complete);
    EXPECT_LE(done.until, 4);
    ASSERT_FALSE(done.events.empty());
    EXPECT_EQ(done.events[0].time, 1);
    EXPECT_EQ(done.events[0].a, 3U);
    EXPECT_TRUE(done.untold.first == 1 || done.untold.second == 1);
  }
}

// On lattices many hits coincide. One box only: where two meet corner to corner, of which side the normal is
// depends on which of them comes first.
std::vector<SimulatedBody> lattice(std::uint64_t item) {
  Draw draw(41, 1, item);
  constexpr Response kAll[] = {Response::bounce, Response::slide, Response::stop, Response::remove,
                               Response::mark};
  std::vector<SimulatedBody> bodies{box({4, -1}, {8, 0.5}, {0, 0}, kInfinity),
                                    box({4, 9}, {8, 0.5}, {0, 0}, kInfinity)};
  const auto step = [&draw] { return static_cast<double>(draw.below(3)) - 1; };
  for (int i = 0; i < 16; ++i) {
    const Vec2 at(2 * (i % 4) + 1, 2 * std::floor(i / 4) + 1);
    const double vx = step(), vy = step(), mass = 1 + static_cast<double>(draw.below(2));
    bodies.push_back(i != 5 ? disc(at, 0.5, {vx, vy}, mass) : box(at, {0.5, 0.5}, {vx, vy}, mass));
    bodies.back().response = item % 3 == 0   ? Response::bounce
                             : item % 3 == 1 ? Response::slide
                                             : kAll[static_cast<std::size_t>(draw.below(5))];
  }
  return bodies;
}

TEST(Instants, TheOrderOfBodiesMattersToNone) {
  std::size_t events = 0, at_once = 0;
  for (std::uint64_t item = 0; item < 60; ++item) {
    const std::vector<SimulatedBody> bodies = lattice(item);
    std::vector<std::uint32_t> order(bodies.size());
    std::iota(order.begin(), order.end(), 0U);
    const std::vector<Told> first = told_in_order(bodies, order, 2.5);
    events += first.size();
    for (std::size_t i = 1; i < first.size(); ++i)
      at_once += first[i].time == first[i - 1].time ? 1 : 0;
    for (std::uint64_t turn = 0; turn < 3; ++turn) {
      Draw draw(42, turn, item);
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[static_cast<std::size_t>(draw.below(static_cast<int>(i)))]);
      expect_same(first, told_in_order(bodies, order, 2.5));
      if (HasFatalFailure()) FAIL() << item;
    }
  }
  EXPECT_GT(events, 500U);
  EXPECT_GT(at_once, 200U);
}

// Turned over, all happens turned over, to the last bit.
TEST(Instants, AMirroredSceneIsMirrored) {
  for (std::uint64_t item = 0; item < 60; ++item) {
    const std::vector<SimulatedBody> bodies = lattice(item);
    std::vector<SimulatedBody> mirrored = bodies;
    for (SimulatedBody& body : mirrored) {
      body.at.x() = -body.at.x();
      body.velocity.x() = -body.velocity.x();
    }
    const Simulation one = flatray::simulate(bodies, 2.5), other = flatray::simulate(mirrored, 2.5);
    ASSERT_EQ(one.events.size(), other.events.size()) << item;
    for (std::size_t i = 0; i < one.events.size(); ++i) {
      const CollisionEvent &a = one.events[i], &b = other.events[i];
      ASSERT_EQ(a.time, b.time) << item;
      ASSERT_EQ(a.velocity_a, Vec2(-b.velocity_a.x(), b.velocity_a.y())) << item;
      ASSERT_EQ(a.velocity_b, Vec2(-b.velocity_b.x(), b.velocity_b.y())) << item;
    }
  }
}

}  // namespace
}  // namespace flatray
