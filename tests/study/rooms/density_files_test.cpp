// needs: shapes/box shapes/circle experiments/mean_free_path experiments/phase_portion experiments/poincare
// Distributions that experiments write beside their means.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "study/chamber_scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// The numbers of a CSV, without its first line.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    while (std::getline(cells, cell, ','))
      rows.back().push_back(cell.empty() ? 0 : std::strtod(cell.c_str(), nullptr));
  }
  return rows;
}

// The words of an npy file, behind its head.
std::vector<std::uint64_t> words_of(const std::string& npy) {
  const std::size_t head =
      10U + static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
  std::vector<std::uint64_t> words((npy.size() - head) / 8);
  std::memcpy(words.data(), npy.data() + head, 8 * words.size());
  return words;
}

TEST(DensityFiles, OfThePoincareSectionCountTheListedBouncesPixelByPixel) {
  const Scene scene = sinai("0.3");
  const ExperimentResult result = run("poincare", {scene, 3, 20'000, 2});
  constexpr std::size_t kWidth = 820, kHeight = 410;
  std::vector<std::uint64_t> counts(kWidth * kHeight);
  for (const auto& point : rows_of(content_of(result, "poincare_points.csv"))) {
    const auto x = std::min(kWidth - 1, static_cast<std::size_t>(point[2] * kWidth));
    const auto y = std::min(kHeight - 1, static_cast<std::size_t>((1 - point[3]) / 2 * kHeight));
    ++counts[y * kWidth + x];
  }
  EXPECT_EQ(words_of(content_of(result, "poincare_density.npy")), counts);
  const auto rows = rows_of(content_of(result, "poincare_density.csv"));
  ASSERT_EQ(rows.size(), kHeight);
  std::uint64_t sum = 0;
  for (std::size_t y = 0; y < kHeight; ++y)
    for (std::size_t x = 0; x < kWidth; ++x) {
      EXPECT_EQ(rows[y][x + 1], static_cast<double>(counts[y * kWidth + x]));
      sum += counts[y * kWidth + x];
    }
  EXPECT_GE(sum, 20'000U);
}

// A chord of a circle of radius r is shorter than x with probability 1 - sqrt(1 - (x / 2r)^2) where sines
// are uniform.
TEST(DensityFiles, FlightsInACircleAreSpreadAsItsChordsAre) {
  constexpr double kRadius = 2, kFlights = 40'000;
  const ExperimentResult result =
      run("mean-free-path", {.scene = room("circle = { radius = 2 }"),
                             .count = static_cast<std::uint64_t>(kFlights),
                             .bounces = 1});
  const auto shorter = [](double x) {
    const double share = std::min(1.0, x / (2 * kRadius));
    return 1 - std::sqrt(1 - share * share);
  };
  double sum = 0, chi_squared = 0, bins = 0;
  for (const auto& bin : rows_of(content_of(result, "mean_free_path_flights.csv"))) {
    sum += bin[2];
    const double expected = kFlights * (shorter(bin[1]) - shorter(bin[0]));
    if (expected == 0) {
      EXPECT_EQ(bin[2], 0) << bin[0];
    }
    if (expected < 5) continue;
    chi_squared += (bin[2] - expected) * (bin[2] - expected) / expected;
    ++bins;
  }
  EXPECT_EQ(sum, kFlights);
  ASSERT_GE(bins, 16);
  EXPECT_LT(chi_squared, bins + 5 * std::sqrt(2 * bins));
  const auto words = words_of(content_of(result, "mean_free_path_flights.npy"));
  std::uint64_t counted = 0;
  for (std::size_t i = 2; i < words.size(); i += 4) counted += words[i];
  EXPECT_EQ(static_cast<double>(counted), kFlights);
}

TEST(DensityFiles, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = sinai("0.3");
  for (const char* name : {"poincare", "mean-free-path", "phase-portion"}) {
    expect_same_files(run(name, {scene, 3, 20'000, 1}), run(name, {scene, 3, 20'000, 3}));
  }
}

}  // namespace
}  // namespace flatray
