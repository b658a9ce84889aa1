#include "study/stability/leaks.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

TEST(Leaks, ThereAreNoneByTheGridInAnyPlace) {
  for (const RoomPlace& place : room_places()) {
    const LeakTally tally = count_leaks(*find_tracer("grid"), place, 1, 0);
    EXPECT_EQ(tally.rays, kRaysALeakBlock);
    EXPECT_EQ(tally.leaks, 0U) << place.name;
    EXPECT_EQ(tally.wrong + tally.wrong_t, 0U) << place.name;
    EXPECT_EQ(tally.asked, 0U) << place.name;
    EXPECT_GT(tally.bounces, tally.rays * kLeakBounces / 4) << place.name;
  }
}

TEST(Leaks, AreCountedWhereFirstWallsAreWrong) {
  const LeakTally tally = count_leaks(*find_tracer("float"), room_places().front(), 1, 0);
  EXPECT_GT(tally.wrong, 0U);
  EXPECT_GT(tally.leaks, 0U);
  // Single precision errs at vertices alone where coordinates are near 1.
  EXPECT_GT(tally.asked, tally.rays * kLeakBounces / 2);
  EXPECT_GT(tally.beside, 0U);
  EXPECT_EQ(tally.through, 0U);
  EXPECT_LT(tally.beside + tally.nothing + tally.through_end + tally.invented, tally.asked / 100);
}

// Where it names a wall that the exact ray misses, there is no exact place to go on from.
TEST(Leaks, InexactTracersAreFollowedInEveryPlace) {
  for (const RoomPlace& place : room_places()) {
    if (!place.round && place.x == 0) continue;  // as the one above
    const LeakTally tally = count_leaks(*find_tracer("float"), place, 1, 0);
    EXPECT_EQ(tally.rays, kRaysALeakBlock) << place.name;
  }
}

}  // namespace
}  // namespace flatray
