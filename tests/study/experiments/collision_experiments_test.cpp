// needs: shapes/box shapes/circle
#include <gtest/gtest.h>

#include <cmath>

#include "study/chamber_scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// Three discs among four walls, all lengths times s.
std::string gas(double s) {
  const auto box = [s](double x0, double y0, double x1, double y1) {
    return fmt::format("[[entity]]\nshape = {{ box = {{ min = [{}, {}], max = [{}, {}] }} }}\n",
                       x0 * s, y0 * s, x1 * s, y1 * s);
  };
  const auto disc = [s](double x, double y, double r, double vx, double vy) {
    return fmt::format(
        "[[entity]]\nshape = {{ circle = {{ radius = {} }} }}\nat = [{}, {}]\nvelocity = [{}, "
        "{}]\n",
        r * s, x * s, y * s, vx * s, vy * s);
  };
  return box(-1, -1, 0, 9) + box(8, -1, 9, 9) + box(0, -1, 8, 0) + box(0, 8, 8, 9) +
         disc(2, 2, 1, 1.5, 0.75) + disc(5, 6, 0.75, -2, 1) + disc(6, 2, 0.5, 0.25, -3);
}

ExperimentResult run_gas(const std::string& text, std::uint64_t count) {
  return run("gas", {.scene = scene_of(text), .count = count});
}

Diagnostic refusal(const std::string& text, const char* name = "gas") {
  const auto result = experiment(name).run({.scene = scene_of(text), .count = 10});
  FLATRAY_CHECK(!result.has_value());
  return result.error().front();
}

TEST(Gas, IsMeasuredInItsOwnSize) {
  bool overlaps = false;
  for (const std::uint64_t count : {200U, 1000U, 1001U, 3000U}) {
    const ExperimentResult one = run_gas(gas(1), count);
    EXPECT_TRUE(one.holds) << one.summary;
    overlaps = overlaps || measure(one, "deepest_overlap").value > 0;
    for (const int scale : {-600, -20, 10, 60, 600}) {
      const ExperimentResult other = run_gas(gas(std::ldexp(1, scale)), count);
      for (const char* name : {"energy_off", "deepest_overlap", "events_a_second", "jammed"})
        EXPECT_EQ(measure(one, name).value, measure(other, name).value)
            << scale << ' ' << count << ' ' << name;
    }
  }
  EXPECT_TRUE(overlaps) << "no rounding to measure";
}

// They meet once.
const std::string kTwoDiscs =
    "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [0, 0]\nvelocity = [4, 0]\n"
    "[[entity]]\nname = \"ram\"\nshape = { circle = { radius = 1 } }\nat = [8, 0]\n"
    "velocity = [-1, 0]\n";

TEST(Gas, WhatMovesThoughNothingMovesItIsRefused) {
  EXPECT_TRUE(run_gas(kTwoDiscs, 10).holds);
  const Diagnostic refused = refusal(kTwoDiscs + "mass = \"fixed\"\n");
  EXPECT_TRUE(has(refused.message, "'ram' moves though nothing moves it"));
  EXPECT_TRUE(refused.where);
}

// Fewer events than asked for are all there are, and the summary says so.
TEST(Gas, ThatMeetsNoMoreSaysSo) {
  const char* words = "none meet again";
  EXPECT_TRUE(has(run_gas(kTwoDiscs, 10).summary, words));
  EXPECT_FALSE(has(run_gas(gas(1), 100).summary, words));
}

TEST(Gas, AllAtOnceHasNoRate) {
  const ExperimentResult result = run_gas(
      "[[entity]]\nshape = { circle = { radius = 1 } }\nvelocity = [1, 0]\n"
      "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [2, 0]\nvelocity = [-1, 0]\n",
      10);
  EXPECT_TRUE(result.holds);
  for (const Measure& one : result.measures) {
    EXPECT_NE(one.name, "events_a_second");
    EXPECT_TRUE(std::isfinite(one.value)) << one.name;
  }
}

TEST(CollisionExperiments, AnEmptySceneIsNamed) {
  for (const char* name : {"gas", "avoidance"}) {
    const std::string text = format(refusal("", name));
    EXPECT_EQ(text.find("room.toml: error: "), 0U) << text;
  }
}

TEST(CollisionExperiments, WhatMovesInAGroupIsToldSo) {
  const std::string box = "shape = { box = { min = [0, 0], max = [1, 1] } }\n";
  const std::string text =
      format(refusal("frames = 10\n[[entity]]\nname = 'ship'\nvelocity = [1, 0]\n" + box +
                         "[[group]]\nname = 'dock'\n[[entity]]\nat = [5, 0]\n"
                         "velocity = [0, 1]\ngroup = 'dock'\n" +
                         box,
                     "avoidance"));
  EXPECT_NE(text.find("moves in a group"), std::string::npos) << text;
}

}  // namespace
}  // namespace flatray
