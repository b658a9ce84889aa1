#include "study/stability/pair_stability.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

TEST(PairStability, NoContactOfAnyFamilyIsWrong) {
  for (const PairFamily& family : pair_families()) {
    // Grazing pairs keep the oracle busy for some 50 ms each.
    const std::uint64_t count = family.name == "turning-grazing" ? 8 : 48;
    const std::vector<StabilityTally> tallies = check_pairs(family, 11, 100, count);
    ASSERT_EQ(tallies.size(), family.methods.size());
    for (const StabilityTally& tally : tallies) {
      EXPECT_EQ(tally.rays, count) << family.name;
      EXPECT_GT(tally.hits, 0U) << family.name;
      EXPECT_EQ(tally.wrong, 0U) << family.name << " " << tally.first_wrong;
      EXPECT_EQ(tally.off_by_more, 0U) << family.name;
    }
  }
}

}  // namespace
}  // namespace flatray
