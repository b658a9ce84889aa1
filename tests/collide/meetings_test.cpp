// needs: shapes/circle shapes/capsule shapes/ellipse
#include "collide/meetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "all_meetings.h"
#include "collide/broad_phase.h"
#include "oracle/families.h"
#include "scene/load.h"

namespace flatray {
namespace {

TEST(Meetings, SameWhicheverFrameRate) {
  for (const char* fps : {"1", "7", "1000"}) {
    const std::vector<Meeting> met =
        meetings(std::string("flatray = 1\nfps = ") + fps +
                 "\nframes = 4000\n"
                 "[[entity]]\nname = \"bullet\"\n"
                 "shape = { box = { min = [0, 0], max = [1, 1] } }\n"
                 "velocity = [1000, 0]\n"
                 "[[entity]]\nname = \"wall\"\n"
                 "shape = { box = { min = [1501, -5], max = [1501.5, 5] } }\n");
    ASSERT_EQ(met.size(), 1U) << fps;
    EXPECT_EQ(met[0].part.times.low, 1.5);
    EXPECT_EQ(met[0].part.times.high, 1.5015);
    EXPECT_TRUE(met[0].straight);
    EXPECT_EQ(met[0].part.normal, Vec2(1, 0));
  }
}

// A point that passes by the top of a slanting capsule touches it where the upper end is highest, exactly.
TEST(Meetings, SlantingCapsulesAreTouchedAtTheirTops) {
  for (int x = -4; x <= 4; ++x)
    for (int y = 1; y <= 5; ++y)
      for (const int radius : {1, 2, 3}) {
        const std::vector<Meeting> met = meetings(fmt::format(
            "flatray = 1\nfps = 1\nframes = 41\n"
            "[[entity]]\nshape = {{ circle = {{ radius = 0 }} }}\nat = [-20, {}]\nvelocity = [1, "
            "0]\n"
            "[[entity]]\nshape = {{ capsule = {{ from = [1, 2], to = [{}, {}], radius = {} }} }}\n",
            2 + y + radius, 1 + x, 2 + y, radius));
        ASSERT_EQ(met.size(), 1U) << x << " " << y << " " << radius;
        EXPECT_EQ(met[0].part.kind, HitClass::touch);
        EXPECT_EQ(met[0].part.times.low, 21 + x);
        EXPECT_EQ(met[0].part.times.high, 21 + x);
      }
}

TEST(Meetings, CapsulesAndEllipsesMeetAsTheyAre) {
  const std::vector<Meeting> met = meetings(
      "flatray = 1\nfps = 1\nframes = 21\n"
      "[[entity]]\nname = \"pill\"\nvelocity = [1, 0]\n"
      "shape = { capsule = { from = [0, 0], to = [2, 0], radius = 1 } }\n"
      "[[entity]]\nname = \"wall\"\nshape = { box = { min = [10, -4], max = [11, 4] } }\n"
      "[[entity]]\nname = \"fly\"\nat = [1, -6]\nvelocity = [1, 2]\n"
      "shape = { circle = { radius = 0.5 } }\n"
      "[[entity]]\nname = \"ring\"\nat = [13, 0]\nshape = { ellipse = { radii = [1, 1] } }\n"
      "[[entity]]\nname = \"tall\"\nat = [6, 0]\nshape = { ellipse = { radii = [1, 2] } }\n");
  ASSERT_EQ(met.size(), 4U);
  EXPECT_EQ(met[0].b, 4U);  // within proven times
  EXPECT_LE(met[0].part.times.low, 2);
  EXPECT_GE(met[0].part.times.low + met[0].part.width, 2);
  EXPECT_TRUE(met[0].part.width > 0 && met[0].part.width < 1e-11);
  EXPECT_EQ(met[1].b, 2U);  // from below, against the side: -6 + 2 t = -1.5
  EXPECT_EQ(met[1].part.times.low, 2.25);
  EXPECT_EQ(met[1].part.point, Vec2(3.25, -1));
  EXPECT_EQ(met[2].b, 1U);
  EXPECT_EQ(met[2].part.times.low, 7);
  EXPECT_EQ(met[2].part.point, Vec2(10, 0));
  EXPECT_EQ(met[2].part.times.high, 12);
  EXPECT_EQ(met[3].b, 3U);
  EXPECT_EQ(met[3].part.times.low, 9);
}

TEST(Meetings, WhatTurnsMeetsBetweenFrames) {
  const std::vector<Meeting> met = meetings(
      "flatray = 1\nfps = 1\nframes = 5\n"
      "[[entity]]\nname = \"hand\"\nshape = { box = { min = [1, -0.1], max = [3, 0.1] } }\n"
      "angular_velocity = 90\n"
      "[[entity]]\nname = \"post\"\nshape = { box = { min = [-0.1, 1.5], max = [0.1, 2] } }\n");
  ASSERT_EQ(met.size(), 1U);
  EXPECT_FALSE(met[0].straight);
  // The hand's upper side, 0.1 above its middle, comes to the corners of the post.
  const double low = std::atan2(1.5, 0.1) - std::asin(0.1 / std::hypot(1.5, 0.1));
  const double first = low / (std::numbers::pi / 2), last = 2 - first;
  EXPECT_LE(met[0].part.times.low, first + 1e-15);
  EXPECT_GE(met[0].part.times.low + met[0].part.width, first - 1e-15);
  EXPECT_LE(met[0].part.width, 0x1p-40 + 0x1p-48);  // in seconds rounded outwards
  EXPECT_NEAR(met[0].part.times.high, last, 1e-12);
  EXPECT_TRUE(met[0].part.certain);
  EXPECT_NEAR((met[0].part.point - Vec2(0.1, 1.5)).norm(), 0, 1e-11);
}

void expect_same(const std::vector<MeetingPart>& some, const std::vector<MeetingPart>& others) {
  ASSERT_EQ(some.size(), others.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some[i].times.low, others[i].times.low);
    EXPECT_EQ(some[i].times.high, others[i].times.high);
    EXPECT_EQ(some[i].kind, others[i].kind);
    EXPECT_EQ(some[i].start, others[i].start);
    EXPECT_EQ(some[i].point, others[i].point);
    EXPECT_EQ(some[i].normal, others[i].normal);
  }
}

// Among all pairs of some polygons, discs and ellipses.
TEST(Meetings, ManyPairsTogetherTellWhatEachTellsAlone) {
  const Scene scene = scene_of(
      "flatray = 1\nframes = 2\nseed = 3\n"
      "[[entity]]\nname = \"p\"\nshape = { ngon = { sides = 5, radius = { uniform = [0.3, 1] } } "
      "}\n"
      "repeat = { scatter = { count = 40, in = [[0, 0], [8, 8]] } }\n"
      "[[entity]]\nname = \"s\"\nshape = { star = { points = 4, outer = 0.8, inner = 0.3 } }\n"
      "repeat = { scatter = { count = 10, in = [[0, 0], [8, 8]] } }\n"
      "[[entity]]\nname = \"d\"\nshape = { circle = { radius = 0.5 } }\n"
      "repeat = { scatter = { count = 10, in = [[0, 0], [8, 8]] } }\n"
      "[[entity]]\nname = \"e\"\nshape = { ellipse = { radii = [0.5, 0.25] } }\n"
      "repeat = { scatter = { count = 3, in = [[0, 0], [8, 8]] } }\n");
  std::vector<MovingShape> bodies;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) {
    oracle::Draw draw(5, 42, i);
    const double x = 4 * draw.unit() - 2, y = 4 * draw.unit() - 2, angle = draw.unit();
    const Entity& entity = scene.entities[i];
    bodies.push_back({&scene.shapes[entity.shape], pose(entity.at, angle), {x, y}});
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    for (std::uint32_t k = i + 1; k < bodies.size(); ++k) pairs.emplace_back(i, k);
  const auto one = pairs_meet(bodies, pairs, {0, 1}, 1), two = pairs_meet(bodies, pairs, {0, 1}, 2);
  std::size_t met = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto alone = shapes_meet(bodies[pairs[i].first], bodies[pairs[i].second], {0, 1});
    expect_same(one[i], alone);
    expect_same(two[i], alone);
    met += alone.size();
  }
  EXPECT_GT(met, 100U);
}

TEST(Meetings, WhatRestsMeetsNothingThatRests) {
  EXPECT_TRUE(
      meetings("flatray = 1\nframes = 10\n"
               "[[entity]]\nname = \"a\"\nshape = { box = { min = [0, 0], max = [2, 2] } }\n"
               "[[entity]]\nname = \"b\"\nshape = { box = { min = [1, 1], max = [3, 3] } }\n")
          .empty());
}

TEST(BroadPhase, AWayOfAFewLeastDoublesIsInItsBox) {
  const double least = 0x1p-1074;
  for (const int way : {1, 3, 5, 7}) {
    const Bounds box = swept({{0, 0}, {0, 0}}, {way * least, -way * least}, 0.5);
    EXPECT_GT(2 * box.high.x(), way * least);
    EXPECT_LT(2 * box.low.y(), -way * least);
  }
}

TEST(BroadPhase, FindsThePairsThatTestingAllFinds) {
  oracle::Draw draw(3, 41, 0);
  std::vector<Bounds> boxes(200);
  for (std::size_t i = 3; i < boxes.size(); ++i) {  // three are empty
    const Vec2 low(draw.below(100), draw.below(100));
    boxes[i] = {low, low + Vec2(draw.below(12), draw.below(12))};
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (std::uint32_t i = 3; i < boxes.size(); ++i)
    for (std::uint32_t k = i + 1; k < boxes.size(); ++k)
      if ((boxes[i].low.array() <= boxes[k].high.array()).all() &&
          (boxes[k].low.array() <= boxes[i].high.array()).all())
        all.emplace_back(i, k);
  EXPECT_GT(all.size(), 50U);
  EXPECT_EQ(overlapping_pairs(boxes), all);
}

// On lattices, where many ends are equal; in columns, rows and nests.
TEST(BroadPhase, FindsEachPairOnceAndNoneOfTwoLeftOut) {
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  for (int kind = 0; kind < 5; ++kind) {
    oracle::Draw draw(3, 42, static_cast<std::uint64_t>(kind));
    std::vector<Bounds> boxes(300);
    std::vector<bool> left_out;
    for (Bounds& box : boxes) {
      const Vec2 low(kind == 1 ? 0 : draw.below(30), kind == 2 ? 0 : draw.below(30));
      box = {low, low + Vec2(draw.below(kind == 3 ? 40 : 4), draw.below(kind == 4 ? 40 : 4))};
      left_out.push_back(draw.below(3) > 0);
    }
    Pairs all = overlapping_pairs(boxes), found;
    std::erase_if(all, [&](const auto& p) { return left_out[p.first] && left_out[p.second]; });
    each_overlap(boxes, left_out, [&](std::uint32_t a, std::uint32_t b) {
      found.emplace_back(a, b);
      return true;
    });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, all) << kind;
    std::size_t asked = 0;
    each_overlap(boxes, left_out, [&](std::uint32_t, std::uint32_t) { return ++asked < 7; });
    EXPECT_EQ(asked, 7U);
  }
}

// Boxes that all overlap; the first of them move.
Scene stacked(int count, int moving) {
  std::string text = "flatray = 1\nframes = 10\n";
  for (int i = 0; i < count; ++i)
    text += "[[entity]]\nname = \"b" + std::to_string(i) + "\"\n" +
            "shape = { box = { min = [0, 0], max = [2, 2] } }\n" +
            (i < moving ? "velocity = [0.1, 0]\n" : "");
  return scene_of(text);
}

TEST(Meetings, AreFoundInBatchesThatHoldAll) {
  const Scene scene = stacked(400, 400);  // of 79 800 pairs
  EXPECT_EQ(meetings(scene).size(), 400U * 399 / 2);
}

TEST(Meetings, MoreThanTheLimitsAreRefusedAtAnEntity) {
  const Scene scene = stacked(60, 3);
  const Timeline timeline(scene, 0, 10);
  const std::size_t pairs = 3 * 57 + 3;
  const auto found = [&](std::uint64_t most_pairs, std::size_t most_meetings) {
    return find_meetings(timeline, 10, Outline::own, 1, {most_pairs, most_meetings});
  };
  EXPECT_EQ(found(pairs, pairs).value().size(), pairs);  // what rests is no pair
  for (const auto& refused : {found(pairs - 1, pairs), found(pairs, pairs - 1)}) {
    ASSERT_FALSE(refused);
    EXPECT_NE(format(refused.error()).find("there are more than 173 "), std::string::npos)
        << format(refused.error());
  }
}

}  // namespace
}  // namespace flatray
