// needs: shapes/box shapes/circle
#include "study/rooms/starts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "study/accuracy/accuracy.h"
#include "study/chamber_scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

double apart(double a, double b) { return std::fabs(a - b - std::round(a - b)); }

TEST(QuasiPoint, OfOneShiftIsStepsOfThePlasticNumberModuloOne) {
  const double p = 1.3247179572447460260;  // p^3 = p + 1
  const UnitPoint first = quasi_point(7, 3);
  for (const std::uint64_t n : {1U, 2U, 1000U}) {
    const UnitPoint point = quasi_point(7, 3 + n * kShifts);
    EXPECT_LT(apart(point.x, first.x + static_cast<double>(n) / p), 1e-12) << n;
    EXPECT_LT(apart(point.y, first.y + static_cast<double>(n) / (p * p)), 1e-12) << n;
  }
}

TEST(QuasiPoint, HasAnotherShiftForEveryNumberBelowTheirCountAndEverySeed) {
  for (std::uint64_t shift = 1; shift < kShifts; ++shift) {
    EXPECT_NE(quasi_point(7, shift).x, quasi_point(7, 0).x);
    EXPECT_NE(quasi_point(7, shift).y, quasi_point(7, 0).y);
  }
  EXPECT_NE(quasi_point(8, 0).x, quasi_point(7, 0).x);
  EXPECT_NE(quasi_point(7, 0).x, quasi_point(7, 0).y);
}

// Of 1024 points 16 are to be in each of 64 cells; random ones would be 10 off in some.
TEST(QuasiPoint, FillsTheSquareEvenly) {
  std::array<int, 64> cells{};
  for (std::uint64_t n = 0; n < 1024; ++n) {
    const UnitPoint point = quasi_point(1, n * kShifts);
    ++cells[static_cast<std::size_t>(point.x * 8) * 8 + static_cast<std::size_t>(point.y * 8)];
  }
  for (const int count : cells) EXPECT_NEAR(count, 16, 3);
}

TEST(StartSums, TakeEachRandomOrbitAndEachShiftForASample) {
  StartSums random(Starts::random), quasi(Starts::quasi);
  for (std::uint64_t i = 0; i < 10 * kShifts; ++i)
    for (StartSums* sums : {&random, &quasi}) sums->add(i, static_cast<double>(i), 2);
  EXPECT_EQ(random.all().samples, 10 * kShifts);
  EXPECT_EQ(quasi.all().samples, kShifts);
  EXPECT_EQ(random.all().ratio(), quasi.all().ratio());
  StartSums read(Starts::quasi);
  ASSERT_EQ(sums_of(quasi).size(), sums_of(read).size());
  add(sums_of(read), numbers_of(sums_of(quasi)));
  EXPECT_EQ(read.all().standard_error(), quasi.all().standard_error());
}

// How the error of a mean of one flight an orbit falls with their number: root mean square over
// seeds.
double order_of(const Scene& scene, Starts starts) {
  std::vector<AccuracyPoint> points;
  for (std::uint64_t count = 512; count <= 32'768; count *= 4) {
    constexpr std::uint64_t kSeeds = 12;
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Measure found = measure(
          run("mean-free-path",
              {.scene = scene, .seed = seed, .count = count, .bounces = 1, .starts = starts}),
          "mean_free_path");
      sum += std::pow(found.value / *found.expected - 1, 2) / kSeeds;
    }
    points.emplace_back().n = static_cast<double>(count);
    points.back().outcome.error = std::sqrt(sum);
  }
  return fit_order(points)->slope;
}

TEST(Starts, RandomOnesHaveOrderOneHalfAndQuasiRandomOnesNearlyOne) {
  const Scene circle = room("circle = { centre = [0, 0], radius = 1 }");
  EXPECT_NEAR(order_of(circle, Starts::random), -0.5, 0.1);
  EXPECT_NEAR(order_of(circle, Starts::quasi), -1, 0.1);
  const Scene square = room("box = { min = [0, 0], max = [1, 1] }");
  EXPECT_NEAR(order_of(square, Starts::random), -0.5, 0.1);
  EXPECT_LT(order_of(square, Starts::quasi), -0.75);
}

TEST(Starts, QuasiRandomOnesKnowTheirError) {
  int holds = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Measure found = measure(run("mean-free-path", {.scene = sinai("0.25"),
                                                         .seed = seed,
                                                         .count = 4096,
                                                         .bounces = 1,
                                                         .starts = Starts::quasi}),
                                  "mean_free_path");
    if (std::fabs(found.value - *found.expected) <= *half_interval(found)) ++holds;
  }
  EXPECT_GE(holds, 43);  // of 95 %
}

TEST(Starts, OfFewerOrbitsThanShiftsCanTellAreRefused) {
  const Scene scene = sinai("0.25");
  const ExperimentContext context{
      .scene = scene, .count = 2 * kShifts - 1, .bounces = 1, .starts = Starts::quasi};
  const auto refused = experiment("mean-free-path").run(context);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().front().hint, "say --count 64 or more, or fewer --bounces");
}

}  // namespace
}  // namespace flatray
