// needs: shapes/box shapes/circle shapes/segment experiments/mean_free_path experiments/lyapunov experiments/escape experiments/caustic experiments/coverage experiments/phase_portion experiments/poincare experiments/divergence
// Experiments on what they cannot be done on, and on the same room at another scale.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study/chamber_scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

const std::string kBox = "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n";
const std::string kPillar =
    "pillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = 0.25 } } }]\n";

std::string refusal(const std::string& text, ExperimentContext context, const std::string& name) {
  const auto result = experiment(name).run(context);
  EXPECT_FALSE(result) << text;
  return result ? "" : format(result.error());
}

void expect_refused(const std::string& text, const std::string& words, std::uint64_t bounces = 5,
                    std::uint64_t count = 1000) {
  const Scene scene = scene_of(text);
  const std::string said = refusal(text, {scene, 1, count, 1, bounces}, "mean-free-path");
  EXPECT_TRUE(has(said, words));
}

TEST(EveryChamberExperiment, RefusesWhatItCannotMeasure) {
  expect_refused("film = { size = [9, 9] }\n",
                 ".toml: error: has no chamber for orbits to stay in");
  expect_refused("[[chamber]]\nshape = { segment = { from = [0, 0], to = [1, 0] } }\n",
                 "the chamber is open");
  expect_refused(kBox + "material = \"absorb\"\n", "room.toml:2:1: error: has walls that absorb");
  expect_refused(kBox + "material = \"periodic\"\n", "has nothing to bounce off");
  expect_refused(
      kBox + "[[entity]]\nmaterial = \"mirror\"\nshape = { circle = { radius = 0.1 } }\n",
      "rays meet this entity beside the chamber");
  expect_refused(kBox, "an orbit without bounces measures nothing", 0);
  expect_refused(kBox, "one orbit alone has no error", 1000, 1000);
  const Scene scene = scene_of(kBox);
  ExperimentContext few{scene, 1, 1000, 1, 100};
  few.starts = Starts::quasi;
  const std::string said = refusal(kBox, few, "mean-free-path");
  EXPECT_TRUE(has(said, "need more than 10 orbits"));
  EXPECT_TRUE(experiment("mean-free-path").run({scene, 1, 1000, 1, 5}));
  const Scene torus = scene_of(kBox + "material = \"periodic\"\n" + kPillar);
  EXPECT_TRUE(experiment("mean-free-path").run({torus, 1, 1000, 1, 5}));
}

// By powers of two all doubles are the same but for their exponents: numbers stay, lengths and what is
// counted by length are scaled.
TEST(EveryChamberExperiment, MeasuresTheSameAtAnotherScale) {
  const auto scaled = [](const std::string& experiment, double scale) {
    const auto number = [&](double x) { return fmt::format("{}", scale * x); };
    std::string text = fmt::format(
        "film = {{ size = [24, 24], world = [[{0}, {0}], [{1}, {1}]] }}\n", number(-1), number(2));
    if (experiment == "escape") {
      for (const auto& [x, y] : {std::pair(-0.5, -0.5), std::pair(1.5, -0.5), std::pair(0.5, 1.25)})
        text += mirror_disc(number(x) + ", " + number(y), number(0.75));
      text +=
          fmt::format("[[ray]]\nat = [{}, {}]\ndirection = [1, 0.25]\n", number(0.5), number(0.25));
    } else {
      text += fmt::format(
          "[[chamber]]\nshape = {{ box = {{ min = [0, 0], max = [{0}, {0}] }} }}\n"
          "pillars = [{{ shape = {{ circle = {{ centre = [{1}, {2}], radius = {3} }} }} }}]\n",
          number(1), number(0.375), number(0.5), number(0.25));
      text += fmt::format("[[ray]]\nname = \"r\"\nat = [{}, {}]\ndirection = [1, 0.3]\n",
                          number(0.0625), number(0.125));
    }
    const Scene scene = scene_of(text);
    ExperimentContext context{scene, 1, 20'000, 2, 40};
    context.apart = scale * 0x1p-30;
    return run(experiment, context).measures;
  };
  for (const char* name : {"mean-free-path", "lyapunov", "escape", "caustic", "coverage",
                           "phase-portion", "poincare", "divergence"}) {
    const auto one = scaled(name, 1), small = scaled(name, 0x1p-12);
    ASSERT_EQ(one.size(), small.size()) << name;
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].name, small[i].name);
      if (one[i].value == 0) {
        EXPECT_EQ(small[i].value, 0) << name << ": " << one[i].name;
        continue;
      }
      const double power = std::log2(small[i].value / one[i].value);
      const bool lengths = one[i].name.find("length") != std::string::npos ||
                           one[i].name.find("path") != std::string::npos || power == 24 ||
                           power == -24 || power == 12 || power == -12;
      EXPECT_NEAR(power, lengths ? 12 * std::round(power / 12) : 0, 1e-9)
          << name << ": " << one[i].name;
      EXPECT_LE(std::fabs(power), 24.5) << name << ": " << one[i].name;
    }
  }
}

// Far away coordinates round by more than the room's extent tells, and fourth powers of huge and tiny
// ones are beyond the doubles.
TEST(Caustic, OfEllipsesKeepsTheirFociWhereverAndHoweverLargeTheyAre) {
  for (const auto& [scale, centre] :
       {std::pair(1.0, 1e3), {1.0, 1e6}, {1.0, 1e10}, {1e-100, 0.0}, {0x1p260, 0.0}}) {
    const Scene scene =
        scene_of(fmt::format("film = {{ size = [8, 8] }}\n[[chamber]]\n"
                             "shape = {{ ellipse = {{ radii = [{}, {}], centre = [{}, 0] }} }}\n"
                             "[[ray]]\nname = \"r\"\nat = [{}, {}]\ndirection = [1, 0.7]\n",
                             2 * scale, scale, centre, centre, 0.3 * scale));
    const ExperimentResult result = run("caustic", {.scene = scene, .bounces = 2000});
    EXPECT_TRUE(result.holds) << scale << ' ' << centre << '\n' << result.summary;
    EXPECT_NEAR(measure(result, "r: largest").value / scale / scale, -0.926174, 1e-3);
  }
  const Scene disc = scene_of(
      "film = { size = [8, 8] }\n[[chamber]]\n"
      "shape = { circle = { centre = [1e10, 0], radius = 1 } }\n"
      "[[ray]]\nname = \"r\"\nat = [1e10, 0.3]\ndirection = [1, 0.7]\n");
  EXPECT_TRUE(run("caustic", {.scene = disc, .bounces = 2000}).holds);
}

// From (0.5, 0.9) to (1, 0.95), and on from (0, 0.95) to (0.5, 1), which passes the middle farther off.
TEST(Caustic, OfATorusSeesLinesThatComeInByItsEdges) {
  Scene scene = torus("0.05");
  const Scene rays = scene_of("[[ray]]\nname = \"r\"\nat = [0.5, 0.9]\ndirection = [1, 0.1]\n");
  scene.rays = rays.rays;
  const ExperimentResult result = run("caustic", {.scene = scene, .bounces = 1});
  EXPECT_GE(measure(result, "r: farthest line").value, 0.5 / std::sqrt(1.01) - 1e-9);
}

}  // namespace
}  // namespace flatray
