// needs: shapes/box shapes/capsule shapes/circle shapes/ellipse shapes/ngon shapes/segment
// Experiments on chambers: known numbers, and the same bytes from any number of threads.
#include <gtest/gtest.h>

#include <atomic>
#include <numbers>

#include "full_counts.h"
#include "study/chamber_scenes.h"
#include "study/statistics/estimate.h"

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
  expect_mean_free_path(stadium(), kPi * (4 + kPi) / (2 * kPi + 4), 100'000);
}

// Flights between copies of a disc may be as long as one likes: their mean settles slowly.
TEST(StiffCases, C19MeanFreePathOfTheTorus) {
  const ExperimentResult result = run("mean-free-path", {torus("0.25"), 1, 300'000, 2, 5});
  EXPECT_TRUE(result.holds) << result.summary;
  const Measure found = measure(result, "mean_free_path");
  EXPECT_NEAR(*found.expected, 1.607301, 5e-7);
  EXPECT_NEAR(found.value, *found.expected, 0.01 * *found.expected);
  EXPECT_EQ(measure(result, "orbits_escaped").value, 0);
  // A flight longer than t has odds of some t^-2: there is no variance.
  EXPECT_FALSE(found.standard_error);
  EXPECT_TRUE(has(found.remark, "t^-2"));
}

TEST(StiffCases, C20LyapunovOfTheStadium) {
  const struct {
    const char* half_length;
    double per_length, per_hit;
  } cases[] = {{"0.5", 0.4606, 0.8983}, {"1", 0.4294, 0.9370}, {"2", 0.3443, 0.8438}};
  for (const auto& one : cases) {
    const ExperimentResult result =
        run("lyapunov", {stadium(one.half_length), 1, times(1'000'000, 300'000), 2});
    for (const auto& [name, expected] :
         {std::pair("per_length", one.per_length), std::pair("per_hit", one.per_hit)}) {
      const Measure found = measure(result, name);
      EXPECT_NEAR(found.value, expected, 0.005 * expected + 3 * *found.standard_error)
          << name << " " << one.half_length;
      EXPECT_LT(*found.standard_error, 0.01 * expected) << name;
    }
  }
}

// Of a small disc the exponent is -2 ln r + 1 - 4 ln 2 + 27 zeta(3) / (2 pi^2), as Dahlqvist found;
// r = 0.01 has -0.116 in place of -0.128.
TEST(StiffCases, C21LyapunovOfTheTorus) {
  const double small = -2 * std::log(0.01) - 0.116;
  for (const auto& [radius, expected] : {std::pair("0.1", 4.564), std::pair("0.25", 2.763),
                                         std::pair("0.4", 1.702), std::pair("0.01", small)}) {
    const Measure found = measure(run("lyapunov", {torus(radius), 1, times(1'000'000, 200'000), 2}),
                                  "per_curved_hit");
    EXPECT_NEAR(found.value, expected, 0.01 * expected) << radius;
    EXPECT_LT(*found.standard_error, 0.01 * expected);
  }
}

// Unfolded, the room is the unit torus: the exponent of a unit of length is the same.
TEST(StiffCases, C22LyapunovOfTheBox) {
  for (const auto& [radius, expected] : {std::pair("0.25", 1.719), std::pair("0.4", 2.740)}) {
    const Measure found = measure(run("lyapunov", {sinai(radius), 1, 300'000, 2}), "per_length");
    EXPECT_NEAR(found.value, expected, 0.01 * expected + 2 * *found.standard_error) << radius;
  }
}

// Squares, circles and ellipses part neighbours like t: there is no exponent but 0, and no error of one.
TEST(Lyapunov, OfRoomsThatPartNobodyExponentiallyHasNoError) {
  for (const char* shape : {"box = { min = [0, 0], max = [1, 1] }", "circle = { radius = 2 }",
                            "ellipse = { radii = [3, 2] }"}) {
    const ExperimentResult found = run("lyapunov", {room(shape), 1, 200'000, 2});
    for (const Measure& one : found.measures) EXPECT_FALSE(one.standard_error) << one.name;
    EXPECT_NEAR(measure(found, "power_of_growth").value, 1, 0.1) << shape;
    EXPECT_TRUE(has(found.summary, "like t^1.0"));
    const Measure first = found.measures.front();
    EXPECT_EQ(first.name, shape[0] == 'b' ? "per_length" : "finite_time_per_length");
    EXPECT_EQ(first.value == 0, shape[0] == 'b');
  }
}

TEST(Lyapunov, OfAChaoticRoomHasAnError) {
  const ExperimentResult found = run("lyapunov", {sinai("0.3"), 1, 50'000, 2});
  for (const Measure& one : found.measures)
    EXPECT_TRUE(one.standard_error || one.name.starts_with("spectrum_")) << one.name;
  EXPECT_TRUE(has(found.summary, "neighbours part exponentially"));
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
      "[[entity]]\nname = \"up\"\nmaterial = \"absorb\"\n"
      "shape = { segment = { from = [-9, 9], to = [9, 9] } }\n"
      "[[entity]]\nname = \"down\"\nmaterial = \"absorb\"\n"
      "shape = { segment = { from = [-9, -9], to = [9, -9] } }\n"
      "[[ray]]\nname = \"r\"\nat = [0, 0]\ndirection = [1, 0]\n" +
      mirror_disc("-3, 0", "2.5") + mirror_disc("3, 0", "2.5"));
  const ExperimentResult result = run("escape", {.scene = scene, .count = 1000});
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

// Every line of a path in an ellipse touches one conic with its foci: the product of its distances
// to them stays. Between them it is b^2 - c^2 sin^2 of the angle for a line through the centre.
TEST(Caustic, OfAnEllipseKeepsItsFoci) {
  const Scene scene = scene_of(
      "film = { size = [32, 32] }\n[[chamber]]\nshape = { ellipse = { radii = [5, 3] } }\n"
      "[[ray]]\nname = \"between\"\nat = [1, 0]\ndirection = [0, 1]\n"
      "[[ray]]\nname = \"outside\"\nat = [4.5, 0]\ndirection = [0, 1]\n");
  const ExperimentResult result = run("caustic", {scene});
  EXPECT_TRUE(result.holds) << result.summary;
  EXPECT_NEAR(measure(result, "between: least product of distances to the foci").value, 1 - 16,
              1e-9);
  EXPECT_NEAR(measure(result, "outside: largest").value, 4.5 * 4.5 - 16, 1e-9);
}

TEST(Reflections, OfARoomThatKeepsItsRaysAreALeast) {
  const Scene scene = scene_of(
      "film = { size = [8, 8] }\n[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "[[ray]]\nname = \"r\"\nat = [0.25, 0.5]\ndirection = [1, 0]\n");
  const ExperimentResult result = run("reflections", {scene});
  EXPECT_EQ(measure(result, "r (at least)").value, 1e6);
  EXPECT_EQ(measure(result, "pixels_most").value, 200);
}

// Walls of length 5 end before the ray of (4.9, 0.1) could meet them a second time; one that is
// stopped has no closed form either.
TEST(Reflections, OfAWedgeThatIsTooShortOrCutOffHaveNoClosedForm) {
  const auto wedge = [](const std::string& length, const std::string& direction) {
    return scene_of(
        "film = { size = [8, 8] }\n[[entity]]\nmaterial = \"mirror\"\nshape = { polyline = "
        "{ points = [[" +
        length + ", 0], [0, 0], [0, " + length +
        "]] } }\n"
        "[[ray]]\nname = \"r\"\nat = [4.9, 0.1]\ndirection = " +
        direction + "\n");
  };
  EXPECT_EQ(measure(run("reflections", {wedge("50", "[-1, -0.01]")}), "r").expected, 2);
  EXPECT_EQ(measure(run("reflections", {wedge("5", "[-1, -0.01]")}), "r").expected, std::nullopt);
  const Scene long_enough = wedge("50", "[-1, -0.01]");
  ExperimentContext cut{long_enough};
  cut.bounces = 1;
  EXPECT_EQ(measure(run("reflections", cut), "r (at least)").expected, std::nullopt);
}

// Where they overlap, or leave the room, neither the area nor the length of the walls is what is added
// up; those that touch in points, and lone walls that cross each other, are as they are.
TEST(ClosedRooms, HavePillarsThatLieApartInThem) {
  const auto told = [](const std::string& pillars) {
    const Scene scene = room("box = { min = [0, 0], max = [4, 4] }", pillars);
    const auto result = experiment("mean-free-path").run({scene, 1, 1000, 1});
    return result ? "" : result.error()[0].message;
  };
  const std::string first = "{ shape = { circle = { centre = [1, 1], radius = 0.5 } } }, ";
  EXPECT_EQ(told(first + "{ shape = { circle = { centre = [2, 1], radius = 0.5 } } }"), "");
  EXPECT_NE(told(first + "{ shape = { circle = { centre = [1.9, 1], radius = 0.5 } } }"), "");
  EXPECT_NE(told(first + "{ shape = { segment = { from = [1, 1], to = [3, 1] } } }"), "");
  EXPECT_NE(told(first + "{ shape = { box = { min = [3, 3], max = [5, 3.5] } } }"), "");
  EXPECT_NE(told(first + "{ shape = { box = { min = [5, 3], max = [6, 3.5] } } }"), "");
  EXPECT_NE(told(first + "{ shape = { box = { min = [3, 3], max = [4, 3.5] } } }"), "");
  EXPECT_EQ(told(first + "{ shape = { convex = { points = [[3, 3], [4, 3.2], [3, 3.5]] } } }"), "");
  EXPECT_EQ(told("{ shape = { segment = { from = [1, 1], to = [3, 3] } } }, "
                 "{ shape = { segment = { from = [1, 3], to = [3, 1] } } }"),
            "");
}

// Units of length do not matter to exponents by hit.
TEST(Lyapunov, DoesNotDependOnTheUnitOfLength) {
  const auto by_hit = [](const std::string& side, const std::string& radius) {
    const Scene scene =
        scene_of("[[chamber]]\nshape = { box = { min = [0, 0], max = [" + side + ", " + side +
                 "] } }\n"
                 "[[chamber.pillars]]\nshape = { circle = { centre = [" +
                 radius + ", " + side + "], radius = " + radius + " } }\nat = [" + radius + ", -" +
                 radius + "]\n");
    return measure(run("lyapunov", {scene, 1, 20'000, 1}), "per_hit").value;
  };
  EXPECT_DOUBLE_EQ(by_hit("4", "0.5"), by_hit("0.00390625", "0.00048828125"));
}

TEST(PhasePortion, OfAClosedDiamondIsFourCells) {
  const Scene scene = scene_of(
      "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "[[ray]]\nname = \"diamond\"\nat = [0.75, 0.25]\ndirection = [1, 1]\n");
  const ExperimentResult result = run("phase-portion", {scene, 1, 1000});
  EXPECT_EQ(measure(result, "diamond").value, 4.0 / 10'000);
}

// An ergodic room: one orbit says how sure it is of what many would find.
TEST(Poincare, OfOneOrbitHasAnErrorFromItsStretches) {
  const Scene scene = scene_of(
      "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "pillars = [ { shape = { circle = { centre = [0.5, 0.5], radius = 0.25 } } } ]\n"
      "[[ray]]\nname = \"one\"\nat = [0.1, 0.2]\ndirection = [1, 0.3]\n");
  const Measure found = measure(run("poincare", {scene, 1, 100'000}), "mean_square_sine");
  EXPECT_GT(*found.standard_error, 1e-4);
  EXPECT_LT(*found.standard_error, 1e-2);
  EXPECT_NEAR(found.value, 1.0 / 3, 4 * *found.standard_error);
}

// pi A / P holds where walls that stand alone count with both of their sides.
TEST(MeanFreePath, OfARoomWithALoneWallCountsBothItsSides) {
  const Scene scene = room("box = { min = [0, 0], max = [4, 4] }",
                           "{ shape = { segment = { from = [1, 2], to = [3, 2.5] } } }");
  const Measure found = measure(run("mean-free-path", {scene, 7, 100'000, 1}), "mean_free_path");
  EXPECT_NEAR(*found.expected, 3.141592653589793 * 16 / (16 + 2 * std::hypot(2, 0.5)), 1e-12);
  EXPECT_NEAR(found.value, *found.expected, 4 * *found.standard_error);
}

TEST(MeanFreePath, OfARoomWithoutAnInsideIsRefused) {
  const Scene scene = room("segment = { from = [0, 0], to = [1, 0] }");
  const auto result = experiment("mean-free-path").run({scene, 1, 100, 1});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error()[0].message, "the chamber is open, and orbits leave it");
}

TEST(Divergence, NeighboursPartAtTheRateOfTheRoom) {
  const Scene scene = sinai("0.25");
  const auto result = experiment("divergence").run({scene, 1, 1, 1, 60});
  if (is_unavailable(result)) GTEST_SKIP() << "no MPFR";
  ASSERT_TRUE(result) << format(result.error());
  double sum = 0;
  int orbits = 0;
  for (const Measure& one : result->measures)
    if (one.name.ends_with("growth per bounce")) {
      sum += one.value;
      ++orbits;
    }
  EXPECT_NEAR(sum / orbits, 0.78, 0.25);  // of all bounces, discs and walls
}

// In a torus orbits part at the discs alone, at each by a factor of 1 + 2 flight / (radius cos) and more.
TEST(Divergence, CrossesPeriodicWalls) {
  const auto result = experiment("divergence").run({torus("0.25"), 1, 1, 1, 40});
  if (is_unavailable(result)) GTEST_SKIP() << "no MPFR";
  ASSERT_TRUE(result) << format(result.error());
  double sum = 0, orbits = 0;
  for (const Measure& one : result->measures) {
    if (one.name.ends_with("growth per bounce")) sum += one.value, ++orbits;
    const bool told = one.name.ends_with("right until bounce");
    EXPECT_TRUE(!told || one.value >= 8) << one.name << " " << one.value;
  }
  EXPECT_GT(sum / orbits, 1);
  EXPECT_LT(sum / orbits, 3);
}

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
  std::atomic<int> left = 3;
};

class EveryChamberExperiment : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryChamberExperiment, GivesTheSameBytesForAnyThreads) {
  for (const Scene& scene : {sinai("0.2"), torus("0.2"), stadium()}) {
    ExperimentContext context{scene, 5, 3000, 1, 60};
    const auto alone = experiment(GetParam()).run(context);
    if (is_unavailable(alone)) continue;  // no MPFR
    ASSERT_TRUE(alone) << format(alone.error());
    for (const unsigned threads : {2U, 7U, 64U}) {
      context.threads = threads;
      expect_same_files(run(GetParam(), context), *alone);
    }
  }
}

// Orbits escape by a hole.
Scene scene_for(const std::string& name) {
  return name == "escape" ? with_holes("capsule = { from = [-1, 0], to = [1, 0], radius = 1 }",
                                       "{ edge = 0, from = 0.2, to = 0.3 }")
                          : stadium();
}

TEST_P(EveryChamberExperiment, GivesTheSameBytesForAnyThreadsByQuasiRandomStarts) {
  if (!experiment(GetParam()).uses.starts) GTEST_SKIP() << "draws no starts";
  const Scene scene = scene_for(GetParam());
  ExperimentContext context{scene, 5, 5000, 1, 60};
  context.starts = Starts::quasi;
  const auto alone = experiment(GetParam()).run(context);
  if (is_unavailable(alone)) GTEST_SKIP() << format(alone.error());
  ASSERT_TRUE(alone) << format(alone.error());
  context.threads = 7;
  expect_same_files(run(GetParam(), context), *alone);
}

TEST_P(EveryChamberExperiment, GoesOnFromKeptBlocksToTheSameBytes) {
  const Scene scene = scene_for(GetParam());
  ExperimentContext context{scene, 5, times(20'000), 1, 60};
  if (experiment(GetParam()).uses.starts) context.starts = Starts::quasi;
  const auto whole = experiment(GetParam()).run(context);
  if (is_unavailable(whole)) GTEST_SKIP() << format(whole.error());
  ASSERT_TRUE(whole) << format(whole.error());
  Keeper keeper;
  context.monitor = &keeper;
  context.threads = 2;
  if (const auto part = experiment(GetParam()).run(context); part)
    expect_same_files(*part, *whole);  // it has few blocks
  keeper.left = 1'000;
  expect_same_files(run(GetParam(), context), *whole);
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

TEST(ClosedRooms, AreAskedFor) {
  const Scene open = scene_of("[[ray]]\nname = \"r\"\nat = [0, 0]\ndirection = [1, 0]\n");
  for (const char* name : {"mean-free-path", "lyapunov", "poincare", "phase-portion"})
    EXPECT_FALSE(experiment(name).run({open}).has_value()) << name;
  for (const char* name : {"escape", "reflections", "caustic", "coverage"})
    EXPECT_FALSE(experiment(name).run({open}).has_value()) << name;
}

}  // namespace
}  // namespace flatray
