// needs: shapes/box shapes/capsule shapes/circle shapes/ngon shapes/segment
// Experiments on chambers: known numbers, and the same bytes from any number of threads.
#include <gtest/gtest.h>

#include <numbers>

#include "chamber_scenes.h"
#include "study/estimate.h"

namespace flatray {
namespace {

using namespace flatray::testing;

constexpr double kPi = std::numbers::pi;

void expect_mean_free_path(const Scene& scene, double expected, std::uint64_t hits) {
  // A few bounces an orbit: those of a circle or a square are not independent of each other.
  const ExperimentResult result = run("mean-free-path", {scene, 1, hits, 2, 5});
  EXPECT_TRUE(result.holds) << result.summary;
  const Measure found = measure(result, "mean_free_path");
  EXPECT_NEAR(*found.expected, expected, 1e-12);
  EXPECT_NEAR(found.value, expected, 0.003 * expected * std::sqrt(1e6 / static_cast<double>(hits)));
  EXPECT_EQ(measure(result, "orbits_escaped").value, 0);
}

TEST(StiffCases, C19MeanFreePath) {
  expect_mean_free_path(room("box = { min = [0, 0], max = [1, 1] }"), kPi / 4, 100'000);
  expect_mean_free_path(room("circle = { centre = [0, 0], radius = 1 }"), kPi / 2, 100'000);
  expect_mean_free_path(sinai("0.25"), kPi * (1 - kPi / 16) / (4 + kPi / 2), 300'000);
}

TEST(StiffCases, C19MeanFreePathOfTheStadium) {
  expect_mean_free_path(room("capsule = { from = [-1, 0], to = [1, 0], radius = 1 }"),
                        kPi * (4 + kPi) / (2 * kPi + 4), 100'000);
}

TEST(StiffCases, C20LyapunovOfTheStadium) {
  const Scene stadium = room("capsule = { from = [-1, 0], to = [1, 0], radius = 1 }");
  const ExperimentResult result = run("lyapunov", {stadium, 1, 200'000, 2});
  for (const auto& [name, expected] :
       {std::pair("per_length", 0.4294), std::pair("per_hit", 0.9370)}) {
    const Measure found = measure(result, name);
    EXPECT_NEAR(found.value, expected, 0.005 * expected + 3 * found.standard_error) << name;
    EXPECT_LT(found.standard_error, 0.01 * expected) << name;
  }
}

// Unfolded, the room is the unit torus: the exponent of a hit of the disc is the same.
TEST(StiffCases, C21LyapunovOfTheTorus) {
  for (const auto& [radius, expected] :
       {std::pair("0.1", 4.564), std::pair("0.25", 2.763), std::pair("0.4", 1.702)}) {
    const Measure found =
        measure(run("lyapunov", {sinai(radius), 1, 200'000, 2}), "per_curved_hit");
    EXPECT_NEAR(found.value, expected, 0.01 * expected) << radius;
    EXPECT_LT(found.standard_error, 0.01 * expected);
  }
}

TEST(StiffCases, C22LyapunovOfTheBox) {
  for (const auto& [radius, expected] : {std::pair("0.25", 1.719), std::pair("0.4", 2.740)}) {
    const Measure found = measure(run("lyapunov", {sinai(radius), 1, 300'000, 2}), "per_length");
    EXPECT_NEAR(found.value, expected, 0.01 * expected + 2 * found.standard_error) << radius;
  }
}

TEST(Poincare, TheSineIsUniformForRandomStartsInAnyRoom) {
  for (const Scene& scene :
       {sinai("0.3"), room("ngon = { sides = 5, radius = 1 }"), room("circle = { radius = 2 }")}) {
    const ExperimentResult result = run("poincare", {scene, 3, 20'000, 2});
    EXPECT_TRUE(result.holds) << result.summary;
  }
}

TEST(Reflections, OfAWedgeAreTheDigitsOfPi) {
  const Scene scene = scene_of(
      "film = { size = [2, 2] }\n"
      "[[entity]]\nname = \"a\"\nmaterial = \"mirror\"\n"
      "shape = { segment = { from = [0, 0], to = [1e6, 0] } }\n"
      "[[entity]]\nname = \"b\"\nmaterial = \"mirror\"\n"
      "shape = { segment = { from = [1e6, 1e3], to = [0, 0] } }\n"
      "[[ray]]\nname = \"pi\"\nat = [9e4, 1]\ndirection = [-1, 0]\n");
  const Measure found = measure(run("reflections", {scene}), "pi");
  EXPECT_EQ(found.value, 3141);
  EXPECT_EQ(found.expected, 3141);
}

TEST(Escape, ExitsShareByMirrorSymmetry) {
  // Two mirrors side by side, an absorber above and one below; starts across the middle.
  const Scene scene = scene_of(
      "film = { size = [64, 64], world = [[-1, -1], [1, 1]] }\n"
      "[[entity]]\nname = \"left\"\nmaterial = \"mirror\"\n"
      "shape = { circle = { centre = [-3, 0], radius = 2.5 } }\n"
      "[[entity]]\nname = \"right\"\nmaterial = \"mirror\"\n"
      "shape = { circle = { centre = [3, 0], radius = 2.5 } }\n"
      "[[entity]]\nname = \"up\"\nmaterial = \"absorb\"\n"
      "shape = { segment = { from = [-9, 9], to = [9, 9] } }\n"
      "[[entity]]\nname = \"down\"\nmaterial = \"absorb\"\n"
      "shape = { segment = { from = [-9, -9], to = [9, -9] } }\n"
      "[[ray]]\nname = \"r\"\nat = [0, 0]\ndirection = [1, 0]\n");
  const ExperimentResult result = run("escape", {scene});
  EXPECT_EQ(measure(result, "into up").value, measure(result, "into down").value);
  EXPECT_GT(measure(result, "into up").value, 0.4);
  EXPECT_EQ(measure(result, "trapped").value, 0);
}

TEST(Caustic, OfACircleKeepsItsDistance) {
  const Scene scene = scene_of(
      "film = { size = [32, 32] }\n[[chamber]]\nshape = { circle = { radius = 1 } }\n"
      "[[ray]]\nname = \"r\"\nat = [0.5, 0.25]\ndirection = [-1, 2]\n");
  const ExperimentResult result = run("caustic", {scene});
  EXPECT_TRUE(result.holds) << result.summary;
  EXPECT_NEAR(measure(result, "r: nearest line to the middle").value, 0.55901699437494742, 1e-10);
}

TEST(PhasePortion, OfAClosedDiamondIsFourCells) {
  const Scene scene = scene_of(
      "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "[[ray]]\nname = \"diamond\"\nat = [0.75, 0.25]\ndirection = [1, 1]\n");
  const ExperimentResult result = run("phase-portion", {scene, 1, 1000});
  EXPECT_EQ(measure(result, "diamond").value, 4.0 / 10'000);
}

TEST(Divergence, NeighboursPartAtTheRateOfTheRoom) {
  const Scene scene = sinai("0.25");
  const auto result = experiment("divergence").run({scene, 1, 1, 1, 60});
  if (!result) GTEST_SKIP() << "no MPFR";
  double sum = 0;
  int orbits = 0;
  for (const Measure& one : result->measures)
    if (one.name.ends_with("growth per bounce")) {
      sum += one.value;
      ++orbits;
    }
  EXPECT_NEAR(sum / orbits, 0.78, 0.25);  // of all bounces, discs and walls
}

class EveryChamberExperiment : public ::testing::TestWithParam<const char*> {};

// Also with its blocks from an earlier run.
TEST_P(EveryChamberExperiment, GivesTheSameBytesForAnyThreads) {
  const Scene scene = sinai("0.2");
  ExperimentContext context{scene, 5, 3000, 1, 60};
  const auto alone = experiment(GetParam()).run(context);
  if (!alone) GTEST_SKIP() << format(alone.error());
  for (const unsigned threads : {2U, 7U}) {
    context.threads = threads;
    const ExperimentResult many = run(GetParam(), context);
    ASSERT_EQ(many.files.size(), alone->files.size());
    for (std::size_t i = 0; i < many.files.size(); ++i)
      EXPECT_EQ(many.files[i].content, alone->files[i].content) << many.files[i].name;
  }
}
INSTANTIATE_TEST_SUITE_P(All, EveryChamberExperiment,
                         ::testing::Values("caustic", "coverage", "divergence", "escape",
                                           "lyapunov", "mean-free-path", "phase-portion",
                                           "poincare", "reflections"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::erase(name, '-');
                           return name;
                         });

// Stops after some blocks, keeps them, and goes on from them.
class Keeper : public RunMonitor {
 public:
  void begin(std::size_t) override {}
  std::optional<Numbers> kept(std::size_t block) override {
    return blocks[block].empty() ? std::nullopt : std::optional(blocks[block]);
  }
  void done(std::size_t block, const Numbers& result) override {
    blocks[block] = result;
    --left;
  }
  bool stopped() override { return left <= 0; }

  std::vector<Numbers> blocks = std::vector<Numbers>(1000);
  int left = 3;
};

TEST(Blocks, AResumedRunGivesTheBytesOfAnUnbrokenOne) {
  const Scene scene = sinai("0.2");
  ExperimentContext context{scene, 5, 20'000};
  const ExperimentResult whole = run("mean-free-path", context);
  Keeper keeper;
  context.monitor = &keeper;
  EXPECT_FALSE(experiment("mean-free-path").run(context).has_value());
  keeper.left = 1'000;
  const ExperimentResult resumed = run("mean-free-path", context);
  for (std::size_t i = 0; i < whole.files.size(); ++i)
    EXPECT_EQ(resumed.files[i].content, whole.files[i].content);
}

TEST(ClosedRooms, AreAskedFor) {
  const Scene open = scene_of("[[ray]]\nname = \"r\"\nat = [0, 0]\ndirection = [1, 0]\n");
  for (const char* name : {"mean-free-path", "lyapunov", "poincare", "phase-portion"})
    EXPECT_FALSE(experiment(name).run({open}).has_value()) << name;
  for (const char* name : {"escape", "reflections", "caustic", "coverage"})
    EXPECT_FALSE(experiment(name).run({open}).has_value()) << name;
}

}  // namespace
}  // namespace flatray
