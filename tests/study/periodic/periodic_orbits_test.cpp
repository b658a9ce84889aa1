// needs: shapes/box shapes/capsule shapes/circle shapes/ellipse experiments/periodic
// Periodic orbits against counts of words, closed forms, orbits that are proven otherwise, and published rates.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "precise/certified_orbit.h"
#include "study/chamber_scenes.h"
#include "study/periodic/cycle_expansion.h"
#include "study/periodic/symmetry.h"
#include "study/periodic/words.h"

namespace flatray {
namespace {

using namespace flatray::testing;

Scene three_discs_6() { return scene_of(three_discs_6_apart()); }

struct Found {
  explicit Found(Scene scene_, std::size_t symbols)
      : scene(std::move(scene_)), room(scene), mirrors(*MirrorRoom::of(room)) {
    auto found = orbits_by_word({scene}, mirrors, symbols);
    FLATRAY_CHECK(found.has_value());
    orbits = std::move(*found);
  }
  std::size_t count(std::size_t bounces, Verdict verdict) const {
    std::size_t all = 0;
    for (const ClosedOrbit& one : orbits)
      all += one.word.size() == bounces && one.verdict == verdict ? 1 : 0;
    return all;
  }
  const ClosedOrbit& of(const std::string& word) const {
    for (const ClosedOrbit& one : orbits)
      if (mirrors.text(one.word) == word) return one;
    throw std::logic_error("no word " + word);
  }

  Scene scene;
  Room room;
  MirrorRoom mirrors;
  std::vector<ClosedOrbit> orbits;
};

void expect_within(const Near& number, double truth) {
  EXPECT_LE(number.low(), truth + 1e-15 * std::fabs(truth));
  EXPECT_GE(number.high(), truth - 1e-15 * std::fabs(truth));
  EXPECT_LT(number.high() - number.low(), 1e-9 * std::fabs(truth));
}

// The orbit that sets off between the first two bounces is followed in as many bits as it takes: the
// walls of the word in order, and at the end where it was.
void expect_followed(const Found& found) {
  std::size_t followed = 0;
  for (const ClosedOrbit& one : found.orbits) {
    if (!one.is_there()) continue;
    const std::size_t n = one.word.size();
    ASSERT_EQ(one.points.size(), n);
    const Vec2 way = one.points[1 % n] - one.points[0];
    const auto orbit = certified_orbit(found.room.walls(), {one.points[0] + 0.5 * way, way}, n);
    ASSERT_TRUE(orbit.has_value());
    ASSERT_EQ(orbit->bounces.size(), n) << found.mirrors.text(one.word);
    for (std::size_t i = 0; i < n; ++i) {
      const auto& bounce = orbit->bounces[i];
      EXPECT_EQ(bounce.surface, found.mirrors.mirrors[one.word[(i + 1) % n]].surface);
      EXPECT_LT((bounce.point - one.points[(i + 1) % n]).norm(), 1e-6)
          << found.mirrors.text(one.word);
    }
    ++followed;
  }
  EXPECT_GT(followed, 10U);
}

// Source of the counts: Chaos: Classical and Quantum, table of prime cycles of the three-disc pinball.
TEST(PeriodicOrbits, OfThreeDiscsAreAsManyAsWords) {
  const Found found(three_discs_6(), 10);
  const std::size_t expected[] = {0, 3, 2, 3, 6, 9, 18, 30, 56, 99};
  std::size_t all = 0;
  for (std::size_t n = 1; n <= 10; ++n) {
    EXPECT_EQ(found.count(n, Verdict::proven), expected[n - 1]) << n;
    all += expected[n - 1];
  }
  EXPECT_EQ(found.orbits.size(), all);
}

TEST(PeriodicOrbits, OfThreeDiscsReducedBySymmetryAreAsManyAsBinaryWords) {
  const Scene scene = three_discs_6();
  const Room room(scene);
  const auto mirrors = MirrorRoom::of(room);
  const auto group = symmetries(*mirrors);
  EXPECT_EQ(group.size(), 6U);
  const std::size_t expected[] = {2, 1, 2, 3, 6, 9, 18, 30};
  for (std::size_t n = 1; n <= 8; ++n) {
    const auto words = reduced_words(group, 3, n);
    ASSERT_TRUE(words.has_value());
    EXPECT_EQ(words->size(), expected[n - 1]) << n;
    for (const ReducedWord& one : *words)
      EXPECT_EQ(disc_orbit(*mirrors, one.word).verdict, Verdict::proven);
  }
}

// To and fro between two discs 4 apart a round doubles what is across 5 + 2 sqrt(6) times, twice.
TEST(PeriodicOrbits, HaveTheLengthsAndEigenvaluesOfClosedForms) {
  const Found discs(three_discs_6(), 3);
  const double half = 5 + 2 * std::sqrt(6.0), third = -11.77145518;
  expect_within(discs.of("23").length, 8);
  expect_within(*discs.of("23").eigenvalue(), half * half);
  // The discs of the other two are off by the rounding of their centres.
  EXPECT_NEAR(discs.of("123").length.value(), 3 * (6 - std::sqrt(3.0)), 1e-13);
  EXPECT_NEAR(discs.of("123").eigenvalue()->value() / (third * third * third), 1, 1e-8);
  const Found stadium_orbits(stadium(), 4), sinai_orbits(sinai("0.25"), 2);
  expect_within(stadium_orbits.of("13").length, 8);
  expect_within(*stadium_orbits.of("13").eigenvalue(), 17 + 12 * std::sqrt(2.0));
  expect_within(stadium_orbits.of("1234").length, 4 * std::sqrt(5.0));
  expect_within(sinai_orbits.of("15").length, 0.5);
  expect_within(*sinai_orbits.of("15").eigenvalue(), 3 + 2 * std::sqrt(2.0));
}

TEST(PeriodicOrbits, AreThoseThatCertifiedOrbitsFollow) {
  if (!can_certify()) GTEST_SKIP() << "no certified module";
  expect_followed(Found(three_discs_6(), 5));
  expect_followed(Found(sinai("0.25"), 6));
  expect_followed(Found(stadium(), 4));
}

// Bouncing balls of the stadium and of the room beside its disc are families; all else of Sinai's room
// is proven, there or not.
TEST(PeriodicOrbits, OfSinaiAreAllDecided) {
  const Found found(sinai("0.25"), 6);
  std::map<Verdict, std::size_t> counts;
  for (const ClosedOrbit& one : found.orbits) ++counts[one.verdict];
  EXPECT_EQ(counts[Verdict::undecided] + counts[Verdict::not_found], 0U);
  EXPECT_EQ(found.count(2, Verdict::proven), 4U);
  EXPECT_EQ(found.count(2, Verdict::family), 2U);
  EXPECT_EQ(found.of("13").verdict, Verdict::family);
  EXPECT_EQ(Found(stadium(), 2).of("24").verdict, Verdict::family);
}

// Found by a reviewer: what tells one orbit from another was a length.
TEST(PeriodicOrbits, AreAsManyInRoomsOfAnySize) {
  const auto of = [](const std::string& radius) {
    return Found(room("capsule = { from = [-" + radius + ", 0], to = [" + radius +
                      ", 0], radius = " + radius + " }"),
                 4);
  };
  const Found one = of("1"), small = of("2.98023223876953125e-8"), large = of("1073741824");
  for (std::size_t bounces = 1; bounces <= 4; ++bounces)
    for (const Verdict verdict : {Verdict::proven, Verdict::family, Verdict::pruned}) {
      EXPECT_EQ(small.count(bounces, verdict), one.count(bounces, verdict)) << bounces;
      EXPECT_EQ(large.count(bounces, verdict), one.count(bounces, verdict)) << bounces;
    }
}

// Newton's method from anywhere, which knows nothing of shortest polygons, finds the orbits that are
// proven and no others.
TEST(PeriodicOrbits, ThatArePrunedAreNotFoundByOtherMeans) {
  const Found found(sinai("0.25"), 4);
  std::size_t tried = 0;
  for (const ClosedOrbit& one : found.orbits) {
    if (curved_places(found.mirrors, one.word).empty()) continue;
    const auto drawn = drawn_orbits(found.mirrors, one.word);
    ASSERT_EQ(drawn.size(), 1U);
    const bool there = drawn[0].verdict == Verdict::proven;
    EXPECT_EQ(there, one.verdict == Verdict::proven) << found.mirrors.text(one.word);
    if (there) {
      EXPECT_NEAR(drawn[0].length.value(), one.length.value(), 1e-9);
    }
    ++tried;
  }
  EXPECT_GT(tried, 50U);
}

// Boxes of places know nothing of shortest polygons either: they rule out no orbit that is there.
TEST(PeriodicOrbits, ThatAreThereAreNotRuledOutByBoxes) {
  const Found found(sinai("0.25"), 4);
  std::size_t ruled_out = 0;
  for (const ClosedOrbit& one : found.orbits) {
    if (!is_ruled_out(found.mirrors, one.word)) continue;
    ++ruled_out;
    EXPECT_EQ(one.verdict, Verdict::pruned) << found.mirrors.text(one.word);
  }
  EXPECT_GT(ruled_out, 10U);
  const Found stadium_orbits(stadium(), 3);
  EXPECT_EQ(stadium_orbits.of("124").verdict, Verdict::pruned);
  EXPECT_EQ(stadium_orbits.count(3, Verdict::proven), 8U);
}

// Triangles of a circle are no repeats of its word, and are not alone: none is proven, and the word is told.
TEST(PeriodicOrbits, EveryWordHasAnAnswer) {
  const Found found(room("circle = { centre = [0, 0], radius = 1 }"), 4);
  EXPECT_EQ(found.orbits.size(), 4U);
  EXPECT_EQ(found.of("111").verdict, Verdict::not_found);
  EXPECT_EQ(found.count(1, Verdict::pruned), 1U);
}

// An ellipse has its two axes, of one word: each line and each name is of one of them.
TEST(Periodic, OrbitsOfOneWordAreNumbered) {
  const Scene scene = room("ellipse = { radii = [3, 2] }");
  const ExperimentResult found = run("periodic", {.scene = scene, .symbols = 2});
  const std::string& table = content_of(found, "periodic_orbits.csv");
  const std::string& picture = content_of(found, "periodic.svg");
  EXPECT_TRUE(has(table, "\n11,1,2,proven,1,"));
  EXPECT_TRUE(has(table, "\n11,2,2,proven,1,"));
  for (const char* name : {">11 (1)</text>", ">11 (2)</text>"})
    EXPECT_TRUE(has(picture, name)) << name;
  EXPECT_FALSE(has(picture, ">11</text>"));
}

// Discs that stand in a row: the middle one is in the way of the outer two.
TEST(PeriodicOrbits, BehindADiscArePruned) {
  const Found found(scene_of(mirror_disc("0, 0") + mirror_disc("4, 0.25") + mirror_disc("8, 0")),
                    3);
  EXPECT_EQ(found.of("12").verdict, Verdict::proven);
  EXPECT_EQ(found.of("23").verdict, Verdict::proven);
  EXPECT_EQ(found.of("13").verdict, Verdict::pruned);
  EXPECT_EQ(found.of("123").verdict, Verdict::pruned);
}

// Source: Chaos: Classical and Quantum gives 0.4103384077693464893384613078192 for R : a = 6.
TEST(CycleExpansion, GivesThePublishedEscapeRateOfThreeDiscs) {
  const Scene scene = three_discs_6();
  const ExperimentResult result = run("periodic", {.scene = scene, .symbols = 7});
  EXPECT_NEAR(measure(result, "escape_rate").value, 0.4103384077693465, 1e-13);
  EXPECT_TRUE(has(measure(result, "escape_rate").remark, "proven: from"));
  EXPECT_TRUE(has(measure(result, "mean_flight").remark, "not proven"));
}

// All words of two letters, each of length 1 and stretched by 3: what stays is 2/3 after each bounce.
TEST(CycleExpansion, HasTheZeroOfFreeWords) {
  std::vector<Cycle> cycles;
  const std::size_t primes[] = {2, 1, 2, 3, 6, 9, 18, 30, 56, 99, 186, 335};
  for (std::size_t n = 1; n <= 12; ++n)
    for (std::size_t i = 0; i < primes[n - 1]; ++i)
      cycles.push_back({n, static_cast<double>(n), std::pow(3.0, static_cast<double>(n))});
  const auto means = cycle_means(cycles, 12);
  ASSERT_FALSE(means.empty());
  EXPECT_EQ(means.back().bounces, 12U);
  EXPECT_NEAR(means.back().escape_rate, std::log(1.5), 1e-11);
  EXPECT_NEAR(means.back().escape_rate_bounce, std::log(1.5), 1e-11);
  EXPECT_NEAR(means.back().flight, 1, 1e-11);
  EXPECT_NEAR(means.back().lyapunov, std::log(3.0), 1e-9);
}

TEST(Periodic, RefusesWhatItCannotProve) {
  const Scene scene = sinai("0.25"), other = torus("0.25");
  const auto words = experiment("periodic").run({.scene = scene, .symbols = 20});
  ASSERT_FALSE(words.has_value());
  EXPECT_TRUE(has(words.error().front().message, "more than 200000 words"));
  EXPECT_FALSE(experiment("periodic").run({other}).has_value());
  const Scene dark = scene_of(
      "[[entity]]\nname = \"hole\"\nmaterial = \"absorb\"\n"
      "shape = { circle = { radius = 1 } }\n");
  EXPECT_TRUE(has(experiment("periodic").run({dark}).error().front().message, "no mirrors"));
}

// Orbits of three discs 6 apart, with a wall that absorbs from one point to another.
ExperimentResult with_absorber(const char* from, const char* to) {
  const Scene scene = scene_of(fmt::format("[[entity]]\nname = \"exit\"\nmaterial = \"absorb\"\n"
                                           "shape = {{ segment = {{ from = [{}], to = [{}] }} }}\n",
                                           from, to) +
                               three_discs_6_apart());
  return run("periodic", {.scene = scene, .symbols = 4});
}

double value_of(const ExperimentResult& result, const std::string& name) {
  for (const Measure& one : result.measures)
    if (one.name == name) return one.value;
  return 0;
}

// An exit beside the discs changes nothing. Between the upper and the lower one it leaves the words in which neither
// follows the other: of up to four bounces the ways to and fro between two pairs, and 1213.
TEST(Periodic, WhatAbsorbsRulesOutWhatMeetsIt) {
  const ExperimentResult beside = with_absorber("-9, 12", "12, 12"),
                         between = with_absorber("-5, 0", "-1, 0");
  EXPECT_EQ(value_of(beside, "orbits proven"), 8);
  EXPECT_EQ(value_of(between, "orbits proven"), 3);
  EXPECT_EQ(value_of(between, "words pruned"), 5);
  EXPECT_NEAR(value_of(beside, "escape_rate"), 0.41033840776, 1e-6);
  EXPECT_TRUE(has(beside.summary, "are bounded by all words of 10 bounces"));
  EXPECT_FALSE(has(between.summary, "bounded"));
}

// One that no orbit so short meets may stand in the way of longer ones.
TEST(Periodic, WhatMayAbsorbLongerOrbitsLeavesNoBounds) {
  const ExperimentResult found = with_absorber("-1.75, 1.99", "-1.77, 1.9");
  EXPECT_EQ(value_of(found, "orbits proven"), 8);
  EXPECT_TRUE(has(found.summary, "no bounds of escape rates: a wall that is no mirror may stand"));
}

// The same bytes whatever the number of threads.
TEST(Periodic, DoesNotDependOnThreads) {
  const Scene scene = stadium();
  expect_same_files(run("periodic", {.scene = scene, .symbols = 4}),
                    run("periodic", {.scene = scene, .threads = 3, .symbols = 4}));
}

}  // namespace
}  // namespace flatray
