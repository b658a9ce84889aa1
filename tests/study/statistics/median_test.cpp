#include "study/statistics/median.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/philox.h"

namespace flatray {
namespace {

std::vector<double> one_to(int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  std::iota(values.rbegin(), values.rend(), 1.0);
  return values;
}

// Tables of the interval for a median: which of the sorted values, and 1 - 2 P(binomial <= k - 1).
TEST(MedianInterval, IsThatOfTheTables) {
  struct Row {
    int count;
    double confidence, low, high, reached;
  };
  for (const Row& row : {Row{8, 0.99, 1, 8, 1 - 2.0 / 256}, Row{9, 0.95, 2, 8, 1 - 20.0 / 512},
                         Row{12, 0.99, 2, 11, 1 - 26.0 / 4096}, Row{6, 0.95, 1, 6, 1 - 2.0 / 64},
                         Row{20, 0.95, 6, 15, 0.9586}, Row{100, 0.95, 40, 61, 0.9648}}) {
    const MedianInterval found = median_interval(one_to(row.count), row.confidence);
    EXPECT_EQ(found.low, row.low) << row.count;
    EXPECT_EQ(found.high, row.high) << row.count;
    EXPECT_NEAR(found.confidence, row.reached, 5e-5) << row.count;
    EXPECT_EQ(found.median, (row.count + 1) / 2.0);
  }
}

// 1000 less and more 0.98 times the root of 2000; 2^-2000 is no double.
TEST(MedianInterval, OfThousandsOfValuesIsNoWiderThanItMustBe) {
  const MedianInterval found = median_interval(one_to(2000), 0.95);
  EXPECT_EQ(found.low, 956);
  EXPECT_EQ(found.high, 1045);
  EXPECT_GE(found.confidence, 0.95);
  EXPECT_LE(found.confidence, 0.954);
}

TEST(MedianInterval, OfTooFewValuesIsTheirRangeAndSaysSo) {
  const MedianInterval three = median_interval({3, 1, 2}, 0.99);
  EXPECT_EQ(three.low, 1);
  EXPECT_EQ(three.high, 3);
  EXPECT_EQ(three.confidence, 0.75);
  EXPECT_EQ(median_interval({5}, 0.99).confidence, 0);
}

// Of tan(pi u), which has no mean; 2000 sets of 12, of which 0.63 % should miss the median 0: 12.7,
// and 28 are four standard deviations more.
TEST(MedianInterval, HoldsTheMedianAsOftenAsItSays) {
  int missed = 0;
  for (std::uint64_t set = 0; set < 2000; ++set) {
    std::vector<double> values;
    for (std::uint32_t i = 0; i < 12; ++i) {
      const double u = unit_double(random_bits(1, Stream::test, set, 0, i));
      values.push_back(std::tan(3.141592653589793 * (u - 0.5)));
    }
    const MedianInterval found = median_interval(values, 0.99);
    missed += found.low > 0 || found.high < 0 ? 1 : 0;
  }
  EXPECT_LE(missed, 28);
  EXPECT_GE(missed, 2);
}

}  // namespace
}  // namespace flatray
