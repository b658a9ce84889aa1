// needs: shapes/box shapes/circle experiments/coverage experiments/escape experiments/caustic experiments/phase_portion
// What experiments must come to by what they do, on scenes where it can be counted.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "study/accuracy_scenes.h"
#include "study/chamber_scenes.h"
#include "study/stability/stability.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// A line of y = 0.9 in a periodic cell passes the disc for ever: all cells of its row, of those whose
// centre lies outside the disc.
TEST(Coverage, CountsWhatLiesBetweenPeriodicWalls) {
  const Scene scene = scene_of(
      "film = { size = [16, 16], world = [[0, 0], [1, 1]] }\n[[chamber]]\n"
      "shape = { box = { min = [0, 0], max = [1, 1] } }\nmaterial = \"periodic\"\n"
      "pillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = 0.25 } } }]\n"
      "[[ray]]\nname = \"r\"\nat = [0.1, 0.9]\ndirection = [1, 0]\n");
  const ExperimentResult result = run("coverage", {scene, 1, 1000, 1, 5});
  ASSERT_EQ(result.measures.size(), 1U);
  const std::string& words = result.summary;
  const std::size_t of = words.find("of the ");
  ASSERT_NE(of, std::string::npos);
  const double cells = std::stod(words.substr(of + 7));
  const double width = std::stod(words.substr(words.find("Part of ") + 8));
  EXPECT_NEAR(cells, width * width * (1 - 3.14159265 / 16), 0.02 * width * width);
  EXPECT_NEAR(result.measures[0].value * cells, width, 1e-6);
}

// Without a ray of the scene, pixels stand for orbits about its middle, to the right.
TEST(Escape, WithoutARayIsThatOfOneInTheMiddle) {
  const std::string discs = "film = { size = [24, 20], world = [[-2, -1], [4, 5]] }\n" +
                            mirror_disc("3, 0") + mirror_disc("0, 4");
  const Scene without = scene_of(discs),
              with = scene_of(discs + "[[ray]]\nat = [1, 2]\ndirection = [1, 0]\n");
  for (const PixelMap map : {PixelMap::angle, PixelMap::position}) {
    ExperimentContext a{without}, b{with};
    a.map = b.map = map;
    a.count = b.count = 1000;
    const auto one = run("escape", a), other = run("escape", b);
    ASSERT_EQ(one.measures.size(), other.measures.size());
    for (std::size_t i = 0; i < one.measures.size(); ++i)
      EXPECT_NEAR(one.measures[i].value, other.measures[i].value, 1e-12) << one.measures[i].name;
    EXPECT_TRUE(content_of(one, "escape.png") == content_of(other, "escape.png"));
  }
}

// Of each experiment as many orbits as it says, where the scene has no ray.
TEST(EveryChamberExperiment, DrawsAsManyOrbitsAsItNeeds) {
  const Scene scene = sinai("0.25");
  const auto names = [&](const char* name) {
    const ExperimentResult result = run(name, {scene, 1, 4000, 1, 20});
    std::vector<std::string> found;
    for (const Measure& one : result.measures) {
      std::string orbit = one.name.substr(0, one.name.find(':'));
      if (orbit.rfind("random", 0) == 0 && (found.empty() || found.back() != orbit))
        found.push_back(orbit);
    }
    return found;
  };
  EXPECT_EQ(names("caustic"), std::vector<std::string>{"random 1"});
  EXPECT_EQ(names("coverage"), std::vector<std::string>{"random 1"});
  EXPECT_EQ(names("phase-portion").size(), 8U);
}

// The curve of a long orbit has points ever further apart, so that it stays small.
TEST(PhasePortion, ACurveHasPointsByTheLogarithm) {
  const ExperimentResult result = run("phase-portion", {sinai("0.25"), 1, 1'000'000, 1, 5000});
  const auto lines = std::ranges::count(content_of(result, "phase_portion.svg"), 'L');
  EXPECT_GT(lines, 9 * 20);
  EXPECT_LT(lines, 9 * 60);
}

// Work that differs from run to run, in nine settings: what is told of each is the middle of all runs,
// so that half of their range is never below 0.
Result<ChoiceSettings> uneven(const AccuracyContext&) {
  ChoiceSettings made{{"the truth", "m", "steps"}};
  for (int n = 1; n <= 9; ++n)
    made.settings.push_back({fmt::format("{}", n), 1.0 * n,
                             [runs = std::make_shared<int>(n)] {
                               volatile double sum = 0;
                               for (int i = 0; i < 200 * (*runs * 7 % 13); ++i) sum = sum + i;
                               *runs += 1;
                             },
                             [n] { return Outcome{1.0 / n}; }});
  return made;
}

TEST(Accuracy, SpreadsAreRanges) {
  const ChoiceReport report = report_of(&uneven, 1e6);
  EXPECT_GE(report.rounds, 3);
  ASSERT_EQ(report.points.size(), 9U);
  for (const AccuracyPoint& point : report.points) {
    EXPECT_GE(point.spread, 0) << point.setting;
    EXPECT_GT(point.seconds, 0) << point.setting;
  }
}

TEST(Stability, NothingIsCountedBeforeAnythingIsAsked) {
  StabilityTally none, twice;
  twice.add(none), twice.add(none);
  for (const StabilityTally* one : {&none, &twice})
    for (const std::uint64_t count :
         {one->rays, one->hits, one->wrong, one->missed, one->invented, one->other_wall,
          one->not_nearest, one->off_by_more, one->by_rationals, one->watched, one->one_by_one,
          one->worst_ulps, one->timed, one->nanoseconds, one->objects, one->bytes})
      EXPECT_EQ(count, 0U);
}

}  // namespace
}  // namespace flatray
