// needs: shapes/box shapes/circle shapes/segment shapes/mushroom
// What an experiment cannot tell it does not print as a number with an error: it says why.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "full_counts.h"
#include "study/chamber_scenes.h"
#include "study/rooms/survival.h"

namespace flatray {
namespace {

using namespace flatray::testing;

const std::string kFilm = "film = { size = [8, 8] }\n";

std::string chamber(const std::string& shape, const std::string& more = "") {
  return kFilm + "[[chamber]]\nshape = { " + shape + " }\n" + more;
}
std::string ray(const std::string& name, const std::string& at, const std::string& direction) {
  return "[[ray]]\nname = \"" + name + "\"\nat = " + at + "\ndirection = " + direction + "\n";
}

TEST(Remarks, RaysWithoutNamesAreCalledByTheirNumbers) {
  const Scene scene = scene_of(chamber("box = { min = [0, 0], max = [4, 4] }") +
                               ray("", "[1, 1]", "[1, 0.3]") + ray("", "[2, 1]", "[1, 0.7]"));
  const auto found = run("reflections", {.scene = scene, .bounces = 10});
  EXPECT_EQ(found.measures[0].name, "ray 1 (at least)");
  EXPECT_EQ(found.measures[1].name, "ray 2 (at least)");
}

// A ray from outside says nothing of the room: every experiment that watches rays refuses it, where it
// is written. Of what stands on a wall, or in a room of entities alone, nothing is known against it.
TEST(Remarks, RaysFromOutsideARoomAreRefusedByAll) {
  const std::string box =
      chamber("box = { min = [0, 0], max = [4, 4] }",
              "pillars = [{ name = \"post\", shape = { circle = { centre = [2, 2], "
              "radius = 1 } } }]\n");
  for (const char* name :
       {"poincare", "phase-portion", "caustic", "coverage", "reflections", "divergence"}) {
    for (const char* at : {"[9, 9]", "[2, 1.5]"}) {
      const Scene scene =
          scene_of(box + ray("good", "[0.5, 0.5]", "[1, 0.3]") + ray("stray", at, "[-1, -0.9]"));
      const auto result = experiment(name).run({.scene = scene, .count = 100, .bounces = 10});
      ASSERT_FALSE(result) << name;
      EXPECT_EQ(result.error().front().message, "ray 'stray' starts outside the room") << name;
      EXPECT_EQ(result.error().size(), 1U);
      EXPECT_TRUE(result.error().front().where);
    }
    const Scene scene = scene_of(box + ray("wall", "[0, 1]", "[1, 0.3]"));
    const auto result = experiment(name).run({.scene = scene, .count = 100, .bounces = 10});
    EXPECT_TRUE(result || is_unavailable(result)) << name;
  }
}

TEST(Remarks, AClosedOrbitHasNoErrorOfItsMean) {
  const auto sines = [](const std::string& text) {
    return measure(run("poincare", {.scene = scene_of(text), .count = 20'000}), "mean_square_sine");
  };
  const std::string box = chamber("box = { min = [0, 0], max = [20, 20] }");
  const Measure diamond = sines(box + ray("diamond", "[15, 5]", "[1, 1]"));
  EXPECT_FALSE(diamond.standard_error);
  EXPECT_EQ(diamond.remark, "no error: a closed orbit");
  EXPECT_NEAR(diamond.value, 0.5, 1e-6);
  const Measure slanted =
      sines(box + ray("slanted", "[15, 5]", "[4, 3]"));  // its points are rounded
  EXPECT_FALSE(slanted.standard_error);
  EXPECT_EQ(slanted.remark, "no error: a closed orbit");
  const std::string open = ray("open", "[15, 5]", "[1, 0.6180339887498949]");
  EXPECT_FALSE(has(sines(box + open).remark, "closed"));
  EXPECT_EQ(sines(box + open + ray("diamond", "[15, 5]", "[1, 1]")).remark,
            "no error: 1 of 2 orbits are closed");
}

// After seven bounces it is as near its start as floats tell, and a little farther each time.
TEST(Remarks, AnOrbitThatTurnsAboutACircleIsNotClosed) {
  const double distance = std::cos(3.141592653589793 * (1.0 / 7 + 1e-8));
  const Scene scene = scene_of(chamber("circle = { centre = [0, 0], radius = 1 }") +
                               ray("turns", fmt::format("[{:.17g}, 0]", distance), "[0, 1]"));
  const Measure turning =
      measure(run("poincare", {.scene = scene, .count = 50'000}), "mean_square_sine");
  EXPECT_FALSE(has(turning.remark, "closed"));
}

TEST(Remarks, BetweenStraightWallsNothingGrowsExponentially) {
  for (const std::string& rays : {std::string(), ray("one", "[1, 1]", "[1, 0.3]")}) {
    const Scene scene = scene_of(chamber("box = { min = [0, 0], max = [4, 3] }") + rays);
    const auto result = experiment("divergence").run({.scene = scene, .bounces = 30});
    if (is_unavailable(result)) GTEST_SKIP() << "no MPFR";
    ASSERT_TRUE(result);
    int told = 0;
    for (const Measure& one : result->measures) {
      if (one.name.find("growth") == std::string::npos) continue;
      ++told;
      EXPECT_EQ(one.value, 0);
      EXPECT_FALSE(one.standard_error);
      EXPECT_TRUE(has(one.remark, "straight"));
    }
    EXPECT_EQ(told, rays.empty() ? 16 : 1);
  }
}

// Of Bunimovich's mushroom orbits stay in the cap or come down the stem: an exponent is a mean of both.
// The part of phase space that stays is known (Bunimovich 2001): orbits in the cap that keep farther from
// its middle than the stem is wide. A Sinai room has one kind alone.
TEST(Remarks, AnExponentOfTwoKindsOfOrbitsSaysSo) {
  const ExperimentContext few{
      .scene = scene_of(chamber("mushroom = { radius = 1, width = 0.6, height = 0.8 }")),
      .count = 300'000};
  const ExperimentResult mixed = run("lyapunov", few);
  const Measure rate = measure(mixed, "per_hit"), share = measure(mixed, "part_like_a_power");
  EXPECT_TRUE(has(rate.remark, "mean over both kinds of orbits"));
  ASSERT_TRUE(rate.standard_error && share.standard_error);
  // Bounces on the half circle at sine s > w stay in it, w half the width of the stem; with those on the
  // cap's straight sides from there to x = 1, of height 2 sqrt(1 - w^2 / x^2).
  const double w = 0.3, pi = 3.141592653589793;
  const double sides = 2 * 2 * (std::sqrt(1 - w * w) - w * std::acos(w));
  const double perimeter = pi + 2 * (1 - w) + 2 * 0.8 + 2 * w;
  EXPECT_NEAR(share.value, (pi * 2 * (1 - w) + sides) / (2 * perimeter),
              4 * *share.standard_error + 0.01);
  const ExperimentResult one = run("lyapunov", {.scene = sinai("0.25"), .count = 300'000});
  EXPECT_EQ(measure(one, "per_hit").remark, "");
  for (const Measure& each : one.measures) EXPECT_NE(each.name, "part_like_a_power");
}

// Of orbits that leave with odds of 1 / 5 at each bounce some few stay as long as they may, like n^-1:
// the first hundred bounces are exponential, and no rate is that of the decay.
TEST(Remarks, ADecayOfTwoKindsHasNoRate) {
  const auto unit = [](std::uint64_t seed, std::uint64_t item) {
    return unit_double(random_bits(seed, Stream::test, 7, item));
  };
  int mixed = 0, pure = 0;
  const std::uint64_t runs = times(200, 40);
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    std::vector<LeavingOrbit> orbits;
    for (std::uint64_t i = 0; i < 20'000; ++i)
      orbits.push_back({std::floor(std::log(unit(seed, i)) / std::log(0.8)), 1, true});
    pure += survival(orbits).law == Survival::Law::exponential ? 1 : 0;
    for (std::uint64_t i = 20'000; i < 20'040; ++i) {
      const double bounces = std::floor(20 / unit(seed, i));
      orbits.push_back({std::min(bounces, 1000.0), 1, bounces < 1000});
    }
    mixed += survival(orbits).law == Survival::Law::exponential ? 1 : 0;
  }
  EXPECT_GE(pure, 0.85 * static_cast<double>(runs));
  EXPECT_LE(mixed, 0.02 * static_cast<double>(runs));
}

// A power law of few orbits is exponential as far as stretches of it tell, but for those that stay longest.
TEST(Remarks, OrbitsThatOutlastARateRefuteIt) {
  const auto unit = [](std::uint64_t seed, std::uint64_t item) {
    return unit_double(random_bits(seed, Stream::test, 8, item));
  };
  int powers = 0, rates = 0, outlasted = 0;
  constexpr int kRuns = 100, kOrbits = 300;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    std::vector<LeavingOrbit> power, decay;
    for (std::uint64_t i = 0; i < kOrbits; ++i) {
      power.push_back({std::floor(4 / unit(seed, i)), 1, true});
      decay.push_back({std::floor(std::log(unit(seed, i)) / std::log(0.9)), 1, true});
    }
    powers += survival(power).law == Survival::Law::exponential ? 1 : 0;
    rates += survival(decay).law == Survival::Law::exponential ? 1 : 0;
    decay.back() = {300, 1, true};  // where 300 * 0.9^300 orbits are to be left
    outlasted += survival(decay).law == Survival::Law::exponential ? 1 : 0;
  }
  EXPECT_LE(powers, kRuns / 20);
  EXPECT_GE(rates, kRuns * 95 / 100);
  EXPECT_EQ(outlasted, 0);
}

// Nor does it make a power of what squares tell to be none.
TEST(Remarks, OneThatOutlastsARateIsTold) {
  const Scene scene = scene_of(
      "film = { size = [8, 8], world = [[-0.05, -0.05], [1.05, 1.05]] }\n"
      "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "holes = [{ edge = 0, from = 0.3, to = 0.45 }]\n"
      "pillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = 0.25 } } }]\n");
  for (const std::uint64_t seed : {13U, 28U, 88U}) {
    const std::string told = run("escape", {.scene = scene, .seed = seed, .count = 1000}).summary;
    EXPECT_NE(told.find("after which the rate leaves"), std::string::npos) << told;
    EXPECT_EQ(told.find("there is no rate"), std::string::npos) << told;
  }
}

// Sinai's room with a hole loses most orbits exponentially; those that fly up and down beside the disc stay.
TEST(Remarks, SinaisRoomWithAHoleHasNoRate) {
  const Scene scene = scene_of(
      "film = { size = [8, 8], world = [[-0.05, -0.05], [1.05, 1.05]] }\n"
      "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "pillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = 0.25 } } }]\n"
      "[[entity]]\nname = \"hole\"\nmaterial = \"absorb\"\n"
      "shape = { segment = { from = [0.4, 0.0001], to = [0.6, 0.0001] } }\n" +
      ray("one", "[0.1, 0.15]", "[1, 0.31]"));
  const ExperimentResult found = run("escape", {.scene = scene, .count = 10'000});
  EXPECT_TRUE(has(found.summary, "fall like neither"));
  for (const Measure& one : found.measures)
    EXPECT_FALSE(has(one.name, "escape_rate")) << found.summary;
}

}  // namespace
}  // namespace flatray
