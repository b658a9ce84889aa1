#include "app/frames/frames.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

using Frames = std::vector<unsigned>;

Frames frames(std::string_view text) { return parse_frames(text, {}).value_or(Frames{}); }

TEST(Frames, ListsRangesAndStepsAreSortedAndEachOnce) {
  EXPECT_EQ(frames("7"), Frames({7}));
  EXPECT_EQ(frames("3..6"), Frames({3, 4, 5, 6}));
  EXPECT_EQ(frames("1..9:4"), Frames({1, 5, 9}));
  EXPECT_EQ(frames("300,1..6:2,5"), Frames({1, 3, 5, 300}));
  EXPECT_EQ(frames("4..4:100"), Frames({4}));
}

TEST(Frames, TheDesignsExampleHas121Frames) {
  const Frames listed = frames("1..240:2,300");
  EXPECT_EQ(listed.size(), 121U);
  EXPECT_EQ(listed[119], 239U);
  EXPECT_EQ(listed.back(), 300U);
}

TEST(Frames, WhatIsNoListOfFramesIsAUsageError) {
  for (const char* text :
       {"", "0", "-1", "1,", ",1", "a", "1..", "..5", "5..1", "1..5:0", "1:2", "1..5:", "1...5",
        "1.5", " 1", "10000000", "99999999999999999999", "1..5:-1"}) {
    const auto result = parse_frames(text, {});
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(result.error().front().trouble, Trouble::usage) << text;
    EXPECT_NE(result.error().front().hint, "") << text;
  }
}

TEST(Frames, AStepNoNumberHoldsEndsTheRange) {
  EXPECT_EQ(frames("2..5:18446744073709551615"), Frames({2}));
}

TEST(Shards, AreDisjointAndMakeUpTheList) {
  const Frames all = frames("1..240:2,300");
  for (const unsigned count : {1U, 2U, 3U, 7U, 200U}) {
    Frames together;
    for (unsigned index = 0; index < count; ++index) {
      const Frames part = frames_of({index, count}, all);
      EXPECT_LE(part.size(), all.size() / count + 1);
      together.insert(together.end(), part.begin(), part.end());
    }
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together, all) << count;
  }
}

TEST(Shards, AreWrittenIOfNWithIFromZero) {
  const auto shard = parse_shard("2/3", {});
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->index, 2U);
  EXPECT_EQ(shard->count, 3U);
  for (const char* text :
       {"", "3/3", "1", "/3", "1/", "-1/3", "0/0", "a/b", "1/2/3", "0/99999999999"})
    EXPECT_FALSE(parse_shard(text, {})) << text;
}

}  // namespace
}  // namespace flatray
