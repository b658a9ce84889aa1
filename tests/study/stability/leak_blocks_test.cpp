// needs: tracers/grid
#include <gtest/gtest.h>

#include "study/stability/leaks.h"

namespace flatray {
namespace {

// The room, its pillars and the rays of a block are the same for ever, and the tracer is exact: so are
// the reflections, and the rays that end in corners.
TEST(Leaks, BlocksAreTheSameForEver) {
  const struct {
    std::uint64_t block, bounces, corners;
  } facts[] = {{0, 185'200, 98}, {1, 188'600, 81}};
  for (const auto& fact : facts) {
    const LeakTally tally = count_leaks(*find_tracer("grid"), room_places().front(), 1, fact.block);
    EXPECT_EQ(tally.bounces, fact.bounces);
    EXPECT_EQ(tally.corners, fact.corners);
  }
}

// Which are the first of the block: more of them bounce at least as often.
TEST(Leaks, AreOfAsManyRaysAsAreAsked) {
  std::uint64_t bounces = 0;
  for (const std::uint64_t count : {1U, 2U, 100U}) {
    const LeakTally tally = count_leaks(*find_tracer("grid"), room_places().front(), 1, 0, count);
    EXPECT_EQ(tally.rays, count);
    EXPECT_GE(tally.bounces, bounces);
    EXPECT_LE(tally.bounces, count * kLeakBounces);
    bounces = tally.bounces;
  }
}

}  // namespace
}  // namespace flatray
