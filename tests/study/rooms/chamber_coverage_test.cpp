// needs: shapes/box shapes/capsule shapes/cell shapes/circle shapes/mushroom shapes/penrose shapes/tokarsky
// Every number with an interval that an experiment prints of a scene of scenes/chamber: over a thousand
// seeds 93 to 97 % of the intervals hold the truth. At full counts; else 200 seeds of three scenes.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "base/parallel.h"
#include "full_counts.h"
#include "study/chamber_scenes.h"
#include "study/interval_runs.h"
#include "support/paths.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// A short run of an experiment; the truth is a run of so many times its count, or, of 1, the mean of all
// short ones, where no closed form is known.
struct Trial {
  const char* experiment;
  std::uint64_t count, bounces, longer;
  double apart = 1e-9;
  std::vector<std::string> scenes{};  // where it is not asked of all
  OrbitPrecision precision = OrbitPrecision::exact;
  Starts starts = Starts::random;
};

std::vector<std::string> chambers() {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("/scenes/chamber")))
    if (entry.path().extension() == ".toml") found.push_back(entry.path().stem());
  std::sort(found.begin(), found.end());
  return found;
}

Scene chamber(const std::string& name, const Trial& trial) {
  auto loaded = load_scene(source_path("/scenes/chamber/" + name + ".toml"));
  FLATRAY_CHECK(loaded.has_value(), name);
  Scene scene = std::move(loaded->scene);
  scene.film.width = scene.film.height = 4;  // pixels of escape have no errors
  if (trial.experiment != std::string_view("escape"))
    scene.rays.clear();  // so that starts are drawn
  return scene;
}

const Measure* find(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& one : measures)
    if (one.name == name && std::isfinite(one.value)) return &one;
  return nullptr;
}

// Of three discs by cycle expansion: `experiment periodic --symbols 12`, of three_discs without its exits.
constexpr std::tuple<const char*, const char*, double> kKnown[] = {
    {"three_discs", "escape_rate_per_length", 0.723842717014},
    {"three_discs", "escape_rate_per_bounce", 0.481165699433},
    {"three_discs_6", "escape_rate_per_length", 0.4103384077693465},
    {"three_discs_6", "escape_rate_per_bounce", 1.6981063230203446}};

// Truth of one number, and where it is from.
struct Truth {
  std::optional<double> value;
  const char* source;
};

class ChamberRuns {
 public:
  ChamberRuns(const std::string& chamber_name, const Trial& trial, std::uint64_t seeds)
      : name_(chamber_name), trial_(trial), scene_(chamber(chamber_name, trial)), runs_(seeds) {
    if (!may_be_asked()) return;
    parallel_for(seeds, 2, [&](std::size_t i) { runs_[i] = measures(i + 1, trial.count); });
    if (trial.longer > 1) longer_ = measures(kOtherSeed, trial.longer * trial.count);
  }

  void expect_cover() const {
    for (const std::string& number : numbers_with_intervals()) {
      const Truth truth = truth_of(number);
      Runs all;
      for (const auto& run : runs_)
        if (const Measure* one = find(run, number)) all.add(*one, truth.value.value_or(0));
      fmt::print("| {} | {} | {} | {} | ", name_, trial_.experiment, number, all.runs());
      if (truth.value)
        fmt::print("{:.1f} | {:.2f} | {:.2f} | {} |\n", 100 * all.held(), all.mean_z(), all.rms_z(),
                   truth.source);
      else
        fmt::print("- | - | - | {} |\n", truth.source);
      std::fflush(stdout);
      const double slack = 3.5 * std::sqrt(0.95 * 0.05 / all.runs());
      if (!truth.value || all.runs() < kFewest) continue;
      EXPECT_GE(all.held(), 0.93 - slack) << name_ << " " << number;
      EXPECT_LE(all.held(), 0.97 + slack) << name_ << " " << number;
    }
  }

 private:
  static constexpr std::uint64_t kOtherSeed = 999'999'937;
  static constexpr double kFewest = 50;  // runs with an interval, for a share of them

  ExperimentContext context(std::uint64_t seed, std::uint64_t count) const {
    return {.scene = scene_,
            .seed = seed,
            .count = count,
            .bounces = trial_.bounces,
            .apart = trial_.apart,
            .starts = trial_.starts,
            .precision = trial_.precision};
  }
  bool may_be_asked() const {
    return (experiment(trial_.experiment).uses.field || scene_.field() == 0) &&
           experiment(trial_.experiment).run(context(1, trial_.count)).has_value();
  }
  std::vector<Measure> measures(std::uint64_t seed, std::uint64_t count) const {
    auto found = experiment(trial_.experiment).run(context(seed, count));
    return found ? std::move(found->measures) : std::vector<Measure>();
  }
  std::set<std::string> numbers_with_intervals() const {
    std::set<std::string> names;
    for (const auto& run : runs_)
      for (const Measure& one : run)
        if (one.standard_error) names.insert(one.name);
    return names;
  }
  Truth truth_of(const std::string& number) const {
    for (const auto& [scene, name, value] : kKnown)
      if (name_ == scene && number == name) return {value, "cycle expansion"};
    double sum = 0, count = 0;
    for (const auto& run : runs_)
      if (const Measure* one = find(run, number)) {
        if (one->expected) return {one->expected, "closed form"};
        sum += one->value;
        ++count;
      }
    if (trial_.longer == 1) return {sum / count, "mean of the runs"};
    const Measure* one = find(longer_, number);
    if (one == nullptr || !one->standard_error) return {{}, "none: a longer run has no interval"};
    return {one->value, "longer run"};
  }

  std::string name_;
  Trial trial_;
  Scene scene_;
  std::vector<std::vector<Measure>> runs_;
  std::vector<Measure> longer_;
};

void expect_cover(const Trial& trial) {
  for (const std::string& name : trial.scenes.empty() ? chambers() : trial.scenes)
    ChamberRuns(name, trial, times(1000, 200)).expect_cover();
}

// What takes longer: by night alone.
void expect_cover_at_full_counts(const Trial& trial) {
  if (!at_full_counts()) GTEST_SKIP() << "at full counts: set FLATRAY_FULL_COUNTS";
  expect_cover(trial);
}

const std::vector<std::string> kDiscs{"three_discs", "three_discs_6"}, kHole{"stadium_hole"};
constexpr OrbitPrecision kFast = OrbitPrecision::fast;

TEST(ErrorCoverage, OfThreeChambers) {
  expect_cover({"mean-free-path", 1600, 50, 0, 0, {"sinai", "stadium", "hall"}});
}
TEST(ErrorCoverage, OfChambersByMeanFreePath) {
  expect_cover_at_full_counts({"mean-free-path", 3200, 100, 100});
}
TEST(ErrorCoverage, OfChambersByLyapunov) {
  expect_cover_at_full_counts({"lyapunov", 12'800, 100, 500});
}
TEST(ErrorCoverage, OfChambersByPoincare) {
  expect_cover_at_full_counts({"poincare", 3200, 50, 100});
}
TEST(ErrorCoverage, OfChambersByTransport) {
  expect_cover_at_full_counts({"transport", 12'800, 128, 200});
}
TEST(ErrorCoverage, OfChambersByEscape) {
  expect_cover_at_full_counts({"escape", 80'000, 1000, 0, 0, kDiscs, kFast});
}
TEST(ErrorCoverage, OfChambersByExits) {
  expect_cover_at_full_counts({"escape", 2000, 10'000, 30, 0, kHole, kFast});
}
TEST(ErrorCoverage, OfChambersByConditionalStarts) {
  expect_cover_at_full_counts({"escape", 200'000, 1000, 0, 0, kDiscs, kFast, Starts::conditional});
}
TEST(ErrorCoverage, OfChambersByRecurrence) {
  expect_cover_at_full_counts({"recurrence", 1000, 1'000'000, 20, 0, kHole, kFast});
}
TEST(ErrorCoverage, OfChambersBySplitting) {
  expect_cover_at_full_counts({"splitting", 1'600'000, 20, 20, 0.1, {"three_discs"}, kFast});
  expect_cover_at_full_counts({"splitting", 800'000, 11, 20, 0.1, {"three_discs_6"}, kFast});
}
TEST(ErrorCoverage, OfChambersByDivergence) {
  expect_cover_at_full_counts({"divergence", 1, 30, 1, 1e-6});
}

}  // namespace
}  // namespace flatray
