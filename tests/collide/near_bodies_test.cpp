#include "collide/near_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;
using Pairs = std::set<IndexPair>;

struct World {
  std::vector<Bounds> shapes;
  std::vector<std::vector<Stage>> stages;
  std::vector<Bounds> ways;  // from 0 to 1
};

// A few far away, a few huge, a few very fast.
World world(std::uint64_t item, int count) {
  World made;
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
    const World bodies = world(item, 150);
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
  near.change(1, {2, {0, 50}, {0, 0}, true});
  found.clear();
  near.each_near(0, [&](std::uint32_t k) { found.push_back(k); });
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace flatray
