#include "app/answers/cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/philox.h"

namespace flatray {
namespace {

constexpr const char* kUnknown = "not measurable";

// Seconds of `count` rounds of the same work beside other jobs: mostly a few percent more than it
// takes, at times several times as much.
CostRounds noisy(double seconds, std::uint64_t set, std::uint64_t which, std::size_t count = 12) {
  CostRounds rounds;
  for (std::size_t i = 0; i < count; ++i) {
    const double u =
        unit_double(random_bits(1, Stream::test, set, which, static_cast<std::uint32_t>(i)));
    rounds.values.push_back(seconds * (1 + 0.02 / (1.01 - u)));
  }
  return rounds;
}

// One in a hundred at the most, so 4 of 400; 12 are four standard deviations more.
TEST(Cost, TheSameWorkAgainIsNoSaving) {
  int measured = 0;
  for (std::uint64_t set = 0; set < 400; ++set)
    measured += saving_words(noisy(1, set, 0), noisy(1, set, 1)) != kUnknown ? 1 : 0;
  EXPECT_LE(measured, 12);
}

TEST(Cost, ASavingBeyondTheNoiseIsToldWithAnIntervalThatHoldsIt) {
  int held = 0;
  for (std::uint64_t set = 0; set < 400; ++set) {
    const std::string words = saving_words(noisy(0.8, set, 0, 40), noisy(1, set, 1, 40));
    ASSERT_NE(words, kUnknown) << set;
    const double low = std::strtod(words.c_str() + words.find('(') + 1, nullptr);
    const double high = std::strtod(words.c_str() + words.find(" to ") + 4, nullptr);
    ASSERT_LT(low, high);
    held += low - 0.05 <= 20 && 20 <= high + 0.05 ? 1 : 0;
  }
  EXPECT_GE(held, 388);
}

TEST(Cost, SavingsAreSharesOfWhatIsKept) {
  const CostRounds without{std::vector<double>(8, 3), true}, with{std::vector<double>(8, 4), true};
  EXPECT_EQ(saving_words(without, with), "25 % (25 to 25)");
  EXPECT_EQ(saving_words(with, without), "costs 33.3 % (33.3 to 33.3)");
  EXPECT_EQ(saving_words(with, with), kUnknown);
}

TEST(Cost, TooFewRoundsMeasureNothing) {
  const CostRounds without{std::vector<double>(7, 3)}, with{std::vector<double>(7, 4)};
  EXPECT_EQ(saving_words(without, with), kUnknown);
  EXPECT_GE(rounds_for(1e9), 8U);
  EXPECT_LE(rounds_for(0), 20U);
}

TEST(Cost, InstructionsCountOnlyWhereEveryRoundHasThem) {
  const Cost both{2, 1e6}, time{3, std::nullopt};
  auto units = in_one_unit({{both, both}, {both, both}});
  EXPECT_TRUE(units[0].instructions);
  EXPECT_EQ(units[1].values, (std::vector<double>{1e6, 1e6}));
  EXPECT_EQ(amount_words(units[0], 2), "0.5 million instructions a frame (0.5 to 0.5)");
  units = in_one_unit({{both, both}, {both, time}});
  EXPECT_FALSE(units[0].instructions);
  EXPECT_EQ(units[0].values, (std::vector<double>{2, 2}));
  EXPECT_EQ(units[1].values, (std::vector<double>{2, 3}));
  EXPECT_EQ(amount_words(units[0], 2), "1e+03 ms a frame (1e+03 to 1e+03)");
}

}  // namespace
}  // namespace flatray
