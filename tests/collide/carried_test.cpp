// needs: shapes/box shapes/capsule shapes/circle shapes/ellipse shapes/segment
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "all_meetings.h"
#include "full_counts.h"
#include "oracle/families.h"

namespace flatray {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_first(const std::vector<Meeting>& met, double truth, double slack = 1e-14) {
  ASSERT_FALSE(met.empty());
  const MeetingPart& part = met[0].part;
  EXPECT_TRUE(part.certain);
  EXPECT_LE(part.times.low, truth + slack);
  EXPECT_GE(part.times.low + part.width, truth - slack);
  EXPECT_LT(part.width, 1e-8);
}

std::string scene_text(double fps, double seconds, const std::string& things) {
  return "flatray = 1\nfps = " + std::to_string(fps) +
         "\nframes = " + std::to_string(static_cast<int>(std::lround(seconds * fps)) + 1) + "\n" +
         things;
}

// A tip on radius 10 at half a turn a second comes to a post at 45 degrees: the discs touch where their
// centres are 1 apart, at 45 degrees less 2 asin(1/20).
const char* const kTipAndPost =
    "[[group]]\nname = \"arm\"\nangular_velocity = 180\n"
    "[[entity]]\nname = \"tip\"\ngroup = \"arm\"\nat = [10, 0]\n"
    "shape = { circle = { radius = 0.5 } }\n"
    "[[entity]]\nname = \"post\"\nat = [7.0710678118654755, 7.0710678118654755]\n"
    "shape = { circle = { radius = 0.5 } }\n";

TEST(Carried, ATipOnAnArmMeetsAPostAtEveryFrameRate) {
  const double first = 0.25 - 2 * std::asin(0.05) / kPi, last = 0.25 + 2 * std::asin(0.05) / kPi;
  for (const double fps : {0.5, 1.0, 2.0, 4.0, 24.0, 1000.0}) {
    SCOPED_TRACE(fps);
    const std::vector<Meeting> met = meetings(scene_text(fps, 4, kTipAndPost));
    ASSERT_EQ(met.size(), 2U);  // and again after a whole turn
    expect_first(met, first);
    EXPECT_LT(met[0].part.width, 1e-11);
    EXPECT_NEAR(met[0].part.times.high, last, 1e-11);
    EXPECT_NEAR(met[1].part.times.low, 2 + first, 1e-11);
    EXPECT_FALSE(met[0].straight);
    const double middle = kPi / 4 - std::asin(0.05);
    const Vec2 touch = 10 * std::cos(std::asin(0.05)) * Vec2(std::cos(middle), std::sin(middle));
    EXPECT_NEAR((met[0].part.point - touch).norm(), 0, 1e-9);
  }
}

// Groups in groups, at different speeds one against the other: the tip's place is 6 e^(i pi t) + 4
// e^(-i pi t) + 1 e^(i 2 pi t), which is (8, 2) + ... at t = 1/4 to the last digit known.
TEST(Carried, ATipOnAnArmMeetsAPostAtEverySize) {
  for (const double size : {1e-300, 1e-200, 1e-163, 1e-161, 1.0, 1e120}) {
    SCOPED_TRACE(size);
    const double across = 7.0710678118654755 * size;
    const std::string things = fmt::format(
        "[[group]]\nname = \"arm\"\nangular_velocity = 180\n"
        "[[entity]]\nname = \"tip\"\ngroup = \"arm\"\nat = [{}, 0]\n"
        "shape = {{ circle = {{ radius = {} }} }}\n"
        "[[entity]]\nname = \"post\"\nat = [{}, {}]\n"
        "shape = {{ circle = {{ radius = {} }} }}\n",
        10 * size, 0.5 * size, across, across, 0.5 * size);
    expect_first(meetings(scene_text(1, 4, things)), 0.25 - 2 * std::asin(0.05) / kPi);
  }
}

// Two hands whose places cancel: by what its frames show it goes below what it meets.
TEST(Carried, WhatRoundingMayHaveMovedIsLookedAt) {
  const std::vector<Meeting> met =
      meetings(scene_text(1, 1,
                          "[[group]]\nname = \"far\"\nat = [0, 1e17]\n"
                          "[[group]]\nname = \"above\"\ngroup = \"far\"\nat = [0, 0.75]\n"
                          "[[entity]]\ngroup = \"above\"\nat = [-5, -1e17]\nvelocity = [10, 0]\n"
                          "shape = { circle = { radius = 0.1 } }\n"
                          "[[entity]]\nat = [0, 0.75]\nangular_velocity = 90\n"
                          "shape = { segment = { from = [-0.2, 0], to = [0.2, 0] } }\n"));
  ASSERT_EQ(met.size(), 1U);
  EXPECT_FALSE(met[0].part.certain);
}

TEST(Carried, WhatGroupsInGroupsCarryMeetsOnItsTrueWay) {
  const double s = std::sqrt(0.5);
  const Vec2 tip(10 * s, 2 * s + 1);  // at t = 1/4
  for (const double fps : {0.5, 1.0, 2.0, 4.0, 24.0, 1000.0}) {
    SCOPED_TRACE(fps);
    const std::string post =
        "at = [" + std::to_string(tip.x()) + ", " + std::to_string(tip.y()) + "]";
    const std::vector<Meeting> met = meetings(scene_text(
        fps, 2,
        "[[group]]\nname = \"one\"\nangular_velocity = 180\n"
        "[[group]]\nname = \"two\"\ngroup = \"one\"\nat = [6, 0]\nangular_velocity = -360\n"
        "[[group]]\nname = \"three\"\ngroup = \"two\"\nat = [4, 0]\nangular_velocity = 540\n"
        "[[entity]]\ngroup = \"three\"\nat = [1, 0]\nshape = { circle = { radius = 0.01 } }\n"
        "[[entity]]\nshape = { circle = { radius = 0.01 } }\n" +
            post + "\n"));
    ASSERT_EQ(met.size(), 1U);
    const MeetingPart& part = met[0].part;
    const auto apart = [&](double t) {
      const auto on = [&](double r, double turns) {
        return Vec2(r * std::cos(turns * kPi * t), r * std::sin(turns * kPi * t));
      };
      const Vec2 there(std::stod(std::to_string(tip.x())), std::stod(std::to_string(tip.y())));
      return (on(6, 1) + on(4, -1) + on(1, 2) - there).norm() - 0.02;
    };
    EXPECT_GT(apart(part.times.low - 1e-12), 0);
    EXPECT_LT(apart(part.times.low + part.width + 1e-12), 0);
    EXPECT_LT(part.width, 1e-11);
    EXPECT_LT(apart(part.times.high - 1e-9), 0);
    EXPECT_GT(apart(part.times.high + 1e-9), 0);
  }
}

// Round a ring of 64 corners in a second: past a post that no chord between frames comes near.
TEST(Carried, APathIsFollowedRoundItsCornersBetweenFrames) {
  std::string path;
  for (int i = 0; i < 64; ++i)
    path += (i > 0 ? ", [" : "[") + std::to_string(std::round(1e6 * std::cos(i * kPi / 32)) / 1e5) +
            ", " + std::to_string(std::round(1e6 * std::sin(i * kPi / 32)) / 1e5) + "]";
  std::vector<double> times;
  for (const double fps : {0.5, 1.0, 2.0, 4.0, 24.0, 1000.0}) {
    SCOPED_TRACE(fps);
    const std::vector<Meeting> met = meetings(scene_text(
        fps, 2,
        "[[entity]]\nname = \"walker\"\nshape = { box = { min = [-0.1, -0.1], max = [0.1, 0.1] } "
        "}\n"
        "follow = { path = [" +
            path +
            "], duration = 1, closed = true, turn = true }\n"
            "[[entity]]\nname = \"post\"\nat = [0, 10]\nshape = { circle = { radius = 0.3 } }\n"));
    ASSERT_EQ(met.size(), 2U);
    EXPECT_NEAR(met[1].part.times.low, 1 + met[0].part.times.low, 1e-11);
    times.push_back(met[0].part.times.low);
    // A quarter of the way but for the post's radius and half the walker.
    EXPECT_NEAR(times.back(), 0.25 - 0.4 / (20 * kPi), 1e-4);
    EXPECT_NEAR(times.back(), times.front(), 1e-11);
  }
}

// From rest through 7 turns to rest in a second: smooth keys, u^2 (3 - 2 u) turns of the way.
TEST(Carried, KeysThroughSeveralTurnsBetweenFramesMeetEachTime) {
  const double half = 2 * std::asin(0.05) / (2 * kPi);  // of a turn
  for (const double fps : {0.5, 1.0, 2.0, 24.0}) {
    SCOPED_TRACE(fps);
    const std::vector<Meeting> met = meetings(scene_text(
        fps, 4,
        "[[group]]\nname = \"arm\"\nangle = { keys = [[1, 0], [2, 2520]], ease = \"smooth\" }\n"
        "[[entity]]\ngroup = \"arm\"\nat = [10, 0]\nshape = { circle = { radius = 0.5 } }\n"
        "[[entity]]\nat = [0, 10]\nshape = { circle = { radius = 0.5 } }\n"));
    ASSERT_EQ(met.size(), 7U);
    for (int turn = 0; turn < 7; ++turn) {
      const auto turned = [](double time) {
        const double u = time - 1;
        return 7 * u * u * (3 - 2 * u);
      };
      const MeetingPart& part = met[static_cast<std::size_t>(turn)].part;
      EXPECT_TRUE(part.certain);
      EXPECT_LE(turned(part.times.low), turn + 0.25 - half + 1e-13);
      EXPECT_GE(turned(part.times.low + part.width), turn + 0.25 - half - 1e-13);
      EXPECT_NEAR(turned(part.times.high), turn + 0.25 + half, 1e-10);
    }
  }
}

// A place that keys move to and fro between two frames.
TEST(Carried, KeysToAndFroBetweenFramesMeet) {
  for (const char* ease : {"linear", "smooth"})
    for (const double fps : {0.5, 1.0, 7.0}) {
      const std::vector<Meeting> met = meetings(scene_text(
          fps, 2,
          std::string("[[entity]]\nshape = { box = { min = [-1, -1], max = [1, 1] } }\n"
                      "at = { keys = [[0, [0, 0]], [0.5, [10, 0]], [1, [0, 0]]], ease = \"") +
              ease + "\" }\n[[entity]]\nat = [6, 0]\nshape = { circle = { radius = 1 } }\n"));
      SCOPED_TRACE(ease);
      ASSERT_EQ(met.size(), 2U);
      // From 4 to 8 of 10, and back: linear at 0.2 s; smooth where u^2 (3 - 2 u) = 0.4.
      const bool is_linear = std::string(ease) == "linear";
      const auto gone = [&](double u) { return is_linear ? u : u * u * (3 - 2 * u); };
      EXPECT_NEAR(gone(2 * met[0].part.times.low), 0.4, 1e-11);
      EXPECT_NEAR(gone(2 * met[0].part.times.high), 0.8, 1e-11);
      EXPECT_NEAR(gone(2 - 2 * met[1].part.times.low), 0.8, 1e-11);
      EXPECT_NEAR(gone(2 - 2 * met[1].part.times.high), 0.4, 1e-11);
    }
}

// What rests in one group that turns keeps as it lies, whatever the group does.
TEST(Carried, WhatOneGroupCarriesIsToldAsItLiesThere) {
  const std::vector<Meeting> met = meetings(
      scene_text(2, 2,
                 "[[group]]\nname = \"g\"\nangular_velocity = 777\nvelocity = [3, 1]\n"
                 "[[entity]]\ngroup = \"g\"\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
                 "[[entity]]\ngroup = \"g\"\nshape = { box = { min = [1, 0.25], max = [2, 2] } }\n"
                 "[[entity]]\ngroup = \"g\"\nat = [0, 4]\nvelocity = [0, -1]\n"
                 "shape = { box = { min = [0, 0], max = [1, 1] } }\n"));
  ASSERT_EQ(met.size(), 2U);
  EXPECT_EQ(met[0].b, 1U);
  EXPECT_EQ(met[0].part.kind, HitClass::touch);  // as of what rests
  EXPECT_EQ(met[0].part.times.high, 2);
  EXPECT_EQ(met[1].a, 1U);
  EXPECT_EQ(met[1].part.times.low, 2);  // touches its side as the scene ends
  EXPECT_EQ(met[1].part.kind, HitClass::touch);
}

// What jumps at the very time of a frame has not gone from where it was to where it is.
TEST(Carried, JumpsAtTheTimesOfFramesAreNoFlights) {
  const std::string box = "shape = { box = { min = [-0.5, -0.5], max = [0.5, 0.5] } }\n";
  const std::string jumper =
      "[[entity]]\nat = { keys = [[0, [0, 0]], [1, [10, 0]]], ease = \"step\" }\n" + box;
  EXPECT_TRUE(meetings(scene_text(24, 2, jumper + "[[entity]]\nat = [5, 0]\n" + box)).empty());
  const std::vector<Meeting> bullet =
      meetings(scene_text(24, 2,
                          jumper + "[[entity]]\nat = [0, -99]\nvelocity = [0, 100]\n"
                                   "shape = { circle = { radius = 0.1 } }\n"));
  ASSERT_EQ(bullet.size(), 1U);  // from y = -99 at 100 a second past what stands there still
  EXPECT_NEAR(bullet[0].part.times.low, 0.984, 1e-12);
  EXPECT_NEAR(bullet[0].part.times.high, 0.996, 1e-12);
  const std::string corners =
      "[[group]]\nname = \"g\"\nfollow = { path = [[0, 0], [10, 0], [10, 10], [0, 10]], closed = "
      "true, duration = 4, turn = true }\n[[entity]]\ngroup = \"g\"\nat = [0, 10]\n" +
      box + "[[entity]]\nat = [5, 5]\nshape = { circle = { radius = 0.4 } }\n";
  EXPECT_TRUE(meetings(scene_text(24, 4, corners)).empty());
  // Where it has jumped to at the last frame.
  const std::vector<Meeting> last =
      meetings(scene_text(24, 1, jumper + "[[entity]]\nat = [10.5, 0]\n" + box));
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last[0].part.times.low, 1);
  EXPECT_EQ(last[0].part.kind, HitClass::through);
}

TEST(Carried, OneFrameAloneTellsWhatMeetsInIt) {
  const std::string box = "shape = { box = { min = [-0.5, -0.5], max = [0.5, 0.5] } }\n";
  for (const char* x : {"0.5", "1", "1.0000000000000002"}) {
    const std::vector<Meeting> met = meetings(scene_text(
        24, 0,
        "[[entity]]\nangular_velocity = 10\n" + box + "[[entity]]\nat = [" + x + ", 0]\n" + box));
    ASSERT_EQ(met.size(), std::string(x).size() > 3 ? 0U : 1U);
    if (met.empty()) continue;
    EXPECT_EQ(met[0].part.start, x == std::string("1") ? StartPlace::boundary : StartPlace::inside);
    EXPECT_EQ(met[0].part.times.high, 0);
  }
}

TEST(Carried, WhatOneGroupCarriesStraightIsToldAsItLiesThere) {
  const std::string box = "shape = { box = { min = [0, 0], max = [1, 1] } }\n";
  for (const bool moves : {true, false}) {  // the group, or each in it alike
    const std::string way = "velocity = [0.1, 0.3]\n";
    const std::string one = "[[entity]]\ngroup = \"g\"\n" + (moves ? "" : way) + box;
    const std::vector<Meeting> met =
        meetings(scene_text(24, 2,
                            "[[group]]\nname = \"g\"\nat = [3, 0]\n" + (moves ? way : "") + one +
                                one + "at = [1, 0]\n" + one + "at = [0, 1.0000000000000002]\n"));
    ASSERT_EQ(met.size(), 1U);  // the last lies an ulp above the first
    EXPECT_EQ(met[0].part.kind, HitClass::touch);
    EXPECT_EQ(met[0].part.times.low, 0);
    EXPECT_EQ(met[0].part.times.high, 2);
  }
}

// As what lies in one group does there, whose places in the world are rounded.
TEST(Carried, WhatOneGroupCarriesMeetsInTheLastFrame) {
  const std::string box = "shape = { box = { min = [0, 0], max = [1, 1] } }\n";
  for (const double end : {0.0, 1.0})
    for (const char* x : {"0.5", "1", "1.0000000000000002"}) {
      SCOPED_TRACE(x);
      const std::vector<Meeting> met = meetings(
          scene_text(24, end,
                     fmt::format("[[group]]\nname = \"g\"\nat = [0.1, 0.7]\nangle = 33\n"
                                 "velocity = [3, 1]\nangular_velocity = 7\n"
                                 "[[entity]]\ngroup = \"g\"\n{}at = {{ keys = [[-1, [0, 9]], "
                                 "[{}, [0, 0]]], ease = \"step\" }}\n"
                                 "[[entity]]\ngroup = \"g\"\nat = [{}, 0]\n{}",
                                 box, end, x, box)));
      ASSERT_EQ(met.size(), std::string(x).size() > 3 ? 0U : 1U);
      if (met.empty()) continue;
      EXPECT_EQ(met[0].part.kind, std::string(x) == "1" ? HitClass::touch : HitClass::through);
      EXPECT_EQ(met[0].part.times.low, end);
      EXPECT_EQ(met[0].part.times.high, end);
    }
}

TEST(Carried, WhatTouchesAtFirstAndThenGoesInBeganByTouching) {
  const std::string box = "shape = { box = { min = [-0.5, -0.5], max = [0.5, 0.5] } }\n";
  const std::vector<Meeting> met =
      meetings(scene_text(24, 1,
                          "[[entity]]\nat = { keys = [[0, [0, 0]], [2, [1, 0]]] }\n" + box +
                              "[[entity]]\nat = [1, 0]\n" + box));
  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(met[0].part.start, StartPlace::boundary);
  EXPECT_EQ(met[0].part.kind, HitClass::through);
}

// A bar that turns about its middle is as wide as 2 (2 |cos| + 0.5 |sin|): its box comes to another at
// the side when its half is 2.05, on the way from 2 to sqrt(4.25).
TEST(Carried, BoxesAreThoseOfEachInstant) {
  for (const double fps : {0.5, 1.0, 24.0}) {
    SCOPED_TRACE(fps);
    const std::vector<Meeting> met =
        meetings(scene_text(fps, 2,
                            "[[entity]]\nangular_velocity = 45\n"
                            "shape = { box = { min = [-2, -0.5], max = [2, 0.5] } }\n"
                            "[[entity]]\nat = [3.05, 0]\nshape = { circle = { radius = 1 } }\n"),
                 Outline::box);
    ASSERT_EQ(met.size(), 1U);
    const auto half = [](double t) {
      return 2 * std::cos(t * kPi / 4) + 0.5 * std::sin(t * kPi / 4);
    };
    const MeetingPart& part = met[0].part;
    EXPECT_LE(half(part.times.low), 2.05 + 1e-14);
    EXPECT_GE(half(part.times.low + part.width), 2.05 - 1e-14);
    EXPECT_NEAR(half(part.times.high), 2.05, 1e-11);
    EXPECT_LT(part.width, 1e-11);
    EXPECT_NEAR(part.point.x(), 2.05, 1e-9);
  }
}

// An ellipse of half-diameters 3 and 1 that turns reaches sqrt(9 c^2 + s^2) to the side. Of the last two units
// the squares are no doubles.
TEST(Carried, EllipsesThatTurnMeetWithinProvenTimes) {
  const auto box = [](double u) {
    return fmt::format("box = {{ min = [{}, {}], max = [{}, {}] }}", 2 * u, -9 * u, 4 * u, 9 * u);
  };
  const std::string capsule = "capsule = { from = [3, -9], to = [3, 9], radius = 1 }";
  for (const auto& [u, wall] :
       {std::pair(1.0, box(1)), std::pair(1.0, capsule), std::pair(0x1p-664, box(0x1p-664)),
        std::pair(0x1p-900, box(0x1p-900))}) {
    const std::vector<Meeting> met =
        meetings(scene_text(0.5, 4,
                            fmt::format("[[entity]]\nangle = 90\nangular_velocity = 90\n"
                                        "shape = {{ ellipse = {{ radii = [{}, {}] }} }}\n"
                                        "[[entity]]\nshape = {{ {} }}\n",
                                        3 * u, u, wall)));
    ASSERT_EQ(met.size(), 2U) << wall;
    const double turned = std::acos(std::sqrt(3.0 / 8)) / (kPi / 2);
    const MeetingPart& part = met[0].part;
    EXPECT_TRUE(part.certain) << wall;
    EXPECT_LE(part.times.low, 1 - turned);
    EXPECT_GE(part.times.low + part.width, 1 - turned);
    EXPECT_LT(part.width, 1e-10);
    EXPECT_NEAR(part.times.high, 1 + turned, 1e-10);
    EXPECT_NEAR(met[1].part.times.low, 3 - turned, 1e-10);
  }
}

// It was left out without a word: an ellipse at rest, and a bar that turns.
TEST(Carried, AnEllipseAtRestMeetsWhatTurns) {
  const std::vector<Meeting> met = meetings(scene_text(
      1, 2,
      "[[entity]]\nangular_velocity = 90\nshape = { segment = { from = [0, 0], to = [9, 0] } }\n"
      "[[entity]]\nat = [3, 4]\nshape = { ellipse = { radii = [2, 1] } }\n"));
  ASSERT_EQ(met.size(), 1U);
  // The tangent through the origin of slope m: (4 - 3 m)^2 = 4 m^2 + 1.
  const double m = (12 - std::sqrt(144 - 75.0)) / 5;
  expect_first(met, std::atan(m) / (kPi / 2), 1e-13);
}

TEST(Carried, PathsWithoutEndInOneFrameAreRefused) {
  const Scene scene = scene_of(
      "flatray = 1\nfps = 1\nframes = 3\n[[entity]]\nname = \"mad\"\n"
      "shape = { circle = { radius = 1 } }\n"
      "follow = { path = [[0, 0], [1, 0], [0, 1]], speed = 1e9, closed = true }\n");
  const auto refused = refused_meetings(scene);
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->front().message.find("'mad' passes more than 65536 corners"),
            std::string::npos);
  EXPECT_TRUE(refused->front().where.source);
}

}  // namespace
}  // namespace flatray
