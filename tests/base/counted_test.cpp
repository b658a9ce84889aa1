#include "base/counted.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace flatray {
namespace {

TEST(Counted, OneIsSingularAndAllElseIsPlural) {
  EXPECT_EQ(counted(0, "ray"), "0 rays");
  EXPECT_EQ(counted(1, "ray"), "1 ray");
  EXPECT_EQ(counted(2U, "ray"), "2 rays");
  EXPECT_EQ(counted(std::uint64_t{1} << 63, "ray"), "9223372036854775808 rays");
}

TEST(Counted, WordsOfTheirOwnPlural) {
  EXPECT_EQ(counted(1, "entry", "entries"), "1 entry");
  EXPECT_EQ(counted(3, "entry", "entries"), "3 entries");
}

}  // namespace
}  // namespace flatray
