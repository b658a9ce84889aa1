#include "base/shuffled.h"

#include <gtest/gtest.h>

#include <vector>

namespace flatray {
namespace {

TEST(Shuffled, HasEveryNumberOnceUnderEverySeed) {
  for (const std::uint64_t count : {1U, 2U, 3U, 4U, 5U, 10U, 99U, 100U, 101U, 4096U})
    for (const std::uint64_t seed : {1U, 2U, 77U}) {
      const Shuffled order(count, seed, Stream::test);
      std::vector<bool> seen(count);
      for (std::uint64_t i = 0; i < order.size(); ++i) {
        ASSERT_LT(order[i], count);
        ASSERT_FALSE(seen[order[i]]) << count << " has " << order[i] << " twice";
        seen[order[i]] = true;
      }
    }
}

// A thousandth of a million numbers: each tenth of them has about a tenth of it, under another seed by
// others.
TEST(Shuffled, BeginsWithNumbersFromEverywhere) {
  const Shuffled order(1'000'000, 1, Stream::test), other(1'000'000, 2, Stream::test);
  std::vector<int> tenths(10);
  int same = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    ++tenths[order[i] / 100'000];
    if (order[i] == other[i]) ++same;
  }
  for (const int count : tenths) EXPECT_NEAR(count, 100, 40);
  EXPECT_LT(same, 3);
}

}  // namespace
}  // namespace flatray
