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

}  // namespace
}  // namespace flatray
