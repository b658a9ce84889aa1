#include "collide/near_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "collide/broad_phase.h"
#include "oracle/families.h"
#include "simulated_bodies.h"

namespace flatray {
namespace {

using oracle::Draw;
using testing::disc;
using Pairs = std::set<IndexPair>;

struct CrowdedWorld {
  std::vector<Bounds> shapes;
  std::vector<std::vector<Stage>> stages;
  std::vector<Bounds> ways;  // from 0 to 1
};

// A few far away, a few huge, a few very fast.
CrowdedWorld world(std::uint64_t item, int count) {
  CrowdedWorld made;
  Draw draw(31, 1, item);
  for (int i = 0; i < count; ++i) {
    const double x = 40 * draw.unit(), y = 40 * draw.unit();
    const double far = draw.unit() < 0.05 ? 1e17 : 1, large = draw.unit() < 0.05 ? 30 : 1;
    const double fast = draw.unit() < 0.05 ? 1e6 : 1;
    const double vx = fast * (draw.unit() - 0.5), vy = fast * (draw.unit() - 0.5);
    const Vec2 half(large * draw.unit(), 0.5 * large);
    made.shapes.push_back({-half, half});
    const Vec2 at(far * x, y);
    made.stages.push_back({{0, at, {vx, vy}}});
    made.ways.push_back(swept({at - half, at + half}, {vx, vy}, 1));
  }
  return made;
}

TEST(NearBodies, AreThosePairsWhoseSweptBoxesMeetEachOnce) {
  for (std::uint64_t item = 0; item < 40; ++item) {
    const CrowdedWorld bodies = world(item, 150);
    NearBodies near(bodies.shapes);
    near.open(0, 1, bodies.stages);
    Pairs found;
    near.each_pair([&](const IndexPair& pair) {
      EXPECT_LT(pair.first, pair.second);
      EXPECT_TRUE(found.insert(pair).second);
    });
    const auto meeting = overlapping_pairs(bodies.ways);
    EXPECT_EQ(found, Pairs(meeting.begin(), meeting.end())) << item;
  }
}

TEST(NearBodies, AChangedWayIsMetAndWhatIsGoneIsNot) {
  const Bounds unit{{-0.5, -0.5}, {0.5, 0.5}};
  NearBodies near({unit, unit, unit});
  const std::vector<Stage> stages[] = {
      {{0, {0, 0}, {1, 0}}}, {{0, {0, 50}, {0, 0}}}, {{0, {9, 0}, {0, 0}}}};
  near.open(0, 4, stages);
  std::size_t pairs = 0;
  near.each_pair([&](const IndexPair&) { ++pairs; });
  EXPECT_EQ(pairs, 0U);
  near.change(0, {1, {1, 0}, {0, 20}});
  std::vector<std::uint32_t> found;
  near.each_near(0, [&](std::uint32_t k) { found.push_back(k); });
  EXPECT_EQ(found, std::vector<std::uint32_t>{1});
  found.clear();
  near.each_near(1, [&](std::uint32_t k) { found.push_back(k); });
  EXPECT_EQ(found, std::vector<std::uint32_t>{0});
  near.change(1, {2, {0, 50}, {0, 0}, true});
  found.clear();
  near.each_near(0, [&](std::uint32_t k) { found.push_back(k); });
  EXPECT_TRUE(found.empty());
}

// As they change their ways one by one, some far beyond where they were.
TEST(NearBodies, ChangedWaysAreThoseThatBoxesTell) {
  for (std::uint64_t item = 0; item < 20; ++item) {
    CrowdedWorld bodies = world(item, 150);
    NearBodies near(bodies.shapes);
    near.open(0, 1, bodies.stages);
    const CrowdedWorld later = world(100 + item, 150);
    Draw draw(31, 3, item);
    for (int changes = 0; changes < 100; ++changes) {
      const auto body = static_cast<std::uint32_t>(150 * draw.unit());
      near.change(body, later.stages[body].back());
      const auto& [from, at, velocity, gone] = later.stages[body].back();
      bodies.ways[body] =
          swept({at + bodies.shapes[body].low, at + bodies.shapes[body].high}, velocity, 1);
      std::set<std::uint32_t> found, meeting;
      const auto asked = static_cast<std::uint32_t>(150 * draw.unit());
      near.each_near(asked, [&](std::uint32_t k) { EXPECT_TRUE(found.insert(k).second); });
      for (std::uint32_t k = 0; k < 150; ++k)
        if (k != asked && bodies.ways[k].meets(bodies.ways[asked])) meeting.insert(k);
      EXPECT_EQ(found, meeting) << item;
    }
  }
}

TEST(NearBodies, WhatPlaysNoPartMeetsNothing) {
  const Bounds unit{{-0.5, -0.5}, {0.5, 0.5}},
      all{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  NearBodies near({all, {}, unit, {}});
  const std::vector<Stage> stands{{0, {0, 0}, {0, 0}}};
  const std::vector<Stage> stages[] = {stands, stands, stands, stands};
  near.open(0, 1, stages);
  Pairs found;
  near.each_pair([&](const IndexPair& pair) { found.insert(pair); });
  EXPECT_EQ(found, (Pairs{{0, 2}}));
}

// Both graze at a time at which the places of both are known to no more than how deep.
TEST(NearBodies, WhatFliesFarMeetsByEitherSearch) {
  std::size_t met = 0;
  for (std::uint64_t item = 0; item < 400; ++item) {
    Draw draw(31, 2, item);
    const double heading = 2 * std::numbers::pi * draw.unit(),
                 turned = 2 * std::numbers::pi * draw.unit();
    const double far = 0x1p33 * (1 + draw.unit()), time = 1 + draw.unit();
    const double depth = 0x1p-19 * draw.unit();
    const Vec2 ahead(std::cos(heading), std::sin(heading));
    const Vec2 along(std::cos(turned), std::sin(turned));
    const Vec2 across(-along.y(), along.x());
    const Vec2 velocity = far * ahead, at = -time * velocity;
    const Vec2 other = at + (2 - depth) * across - time * along;
    const SimulatedBody bodies[] = {disc(at, 1, velocity), disc(other, 1, velocity + along)};
    const Simulation all = simulate(bodies, 4, 10, PairSearch::all);
    const Simulation near = simulate(bodies, 4, 10, PairSearch::near);
    ASSERT_EQ(near.events.size(), all.events.size()) << item;
    met += all.events.size();
  }
  EXPECT_GT(met, 100U);
}

TEST(NearBodies, WhatComesNearerFasterThanAnyDoubleMeetsByEitherSearch) {
  const double far = 1e307, fast = 1e308;
  SimulatedBody bodies[] = {disc({-far, 0}, 1e300, {fast, 0}), disc({far, 0}, 1e300, {-fast, 0})};
  for (SimulatedBody& body : bodies) body.response = Response::mark;
  for (const PairSearch search : {PairSearch::all, PairSearch::near}) {
    const Simulation done = simulate(bodies, 1, 10, search);
    ASSERT_EQ(done.events.size(), 1U);
    EXPECT_EQ(done.events[0].normal, Vec2(1, 0));
  }
}

}  // namespace
}  // namespace flatray
