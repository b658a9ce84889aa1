// Rows of long runs: what a run can have counted is kept and read back, one more than that is refused.
#include <gtest/gtest.h>

#include "app/files/chunk_log.h"
#include "base/file.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Of a folder that is not there yet.
class ChunkLogRows : public OwnFolder {
 protected:
  ChunkLogRows() { fs::remove(folder_); }

  // Whether a folder whose log has this one row is opened again.
  template <class Log, class Tally>
  bool is_kept(const ChunkLog::Key& key, const Tally& tally) {
    fs::remove_all(folder_);
    EXPECT_TRUE(Log::open(folder_.string())->add(key, tally, 1.5));
    const auto again = Log::open(folder_.string());
    if (!again) {
      EXPECT_NE(format(again.error()).find(".csv:2: error: is not a row that this program writes"),
                std::string::npos);
      return false;
    }
    EXPECT_TRUE(again->has(key, tally.rays));
    EXPECT_FALSE(again->has(key, tally.rays + 1));
    return true;
  }
};

TEST_F(ChunkLogRows, LeaksAreNoMoreThanRays) {
  LeakTally most;
  most.rays = kRaysALeakBlock;
  most.leaks = most.corners = most.rays;
  most.bounces = most.rays * kLeakBounces;
  const ChunkLog::Key key{"origin", "grid", "avx2", 1, 0};
  const auto kept = [&](const LeakTally& tally) { return is_kept<LeakLog>(key, tally); };
  EXPECT_TRUE(kept({}));
  EXPECT_TRUE(kept(most));
  for (const auto count :
       {&LeakTally::rays, &LeakTally::leaks, &LeakTally::corners, &LeakTally::bounces}) {
    LeakTally more = most;
    more.*count += 1;
    EXPECT_FALSE(kept(more));
  }
  EXPECT_FALSE(is_kept<LeakLog>({"nowhere", "grid", "avx2", 1, 0}, most));
}

TEST_F(ChunkLogRows, NothingIsCountedMoreOftenThanRays) {
  StabilityTally most;
  most.rays = kRaysAChunk;
  most.hits = most.wrong = most.watched = most.timed = most.one_by_one = most.rays;
  const ChunkLog::Key key{oracle::families().front().name, "grid", "avx2", 1, 0};
  const auto kept = [&](const StabilityTally& tally) { return is_kept<StabilityLog>(key, tally); };
  EXPECT_TRUE(kept({}));
  EXPECT_TRUE(kept(most));
  for (const auto count :
       {&StabilityTally::rays, &StabilityTally::hits, &StabilityTally::wrong,
        &StabilityTally::watched, &StabilityTally::timed, &StabilityTally::one_by_one}) {
    StabilityTally more = most;
    more.*count += 1;
    EXPECT_FALSE(kept(more));
  }
  StabilityTally unwatched = most;
  unwatched.watched = 0;
  EXPECT_FALSE(kept(unwatched)) << "decided one by one, of none watched";
}

// All that is counted comes back, of chunks of one key together, and of no other key.
TEST_F(ChunkLogRows, SumsAreOfAllChunksOfTheirKey) {
  StabilityTally one;
  std::uint64_t n = 1;
  for (const auto count :
       {&StabilityTally::rays, &StabilityTally::hits, &StabilityTally::wrong,
        &StabilityTally::missed, &StabilityTally::invented, &StabilityTally::other_wall,
        &StabilityTally::not_nearest, &StabilityTally::off_by_more, &StabilityTally::by_rationals,
        &StabilityTally::watched, &StabilityTally::one_by_one, &StabilityTally::timed,
        &StabilityTally::nanoseconds, &StabilityTally::objects, &StabilityTally::bytes})
    one.*count = n++;
  one.rays = one.watched = 4000;
  for (std::uint64_t& far : one.off_by_far) far = n++;
  one.worst_ulps = 900;
  one.first_wrong = "item 3 ray 1";
  ChunkLog::Key key{oracle::families().front().name, "grid", "avx2", 7, 0};
  {
    auto log = StabilityLog::open(folder_.string());
    for (; key.chunk < 3; ++key.chunk) ASSERT_TRUE(log->add(key, one, 0.25));
    ChunkLog::Key other = key;
    other.chunk = 1, other.tracer = "brute";
    ASSERT_TRUE(log->add(other, one, 0.25));
  }
  const auto log = StabilityLog::open(folder_.string());
  ASSERT_TRUE(log);
  const StabilityTally sum = log->sum(key, 3), two = log->sum(key, 2);
  EXPECT_EQ(two.rays, 8000U);
  EXPECT_EQ(sum.rays, 12000U);
  EXPECT_EQ(sum.nanoseconds, 3 * one.nanoseconds);
  EXPECT_EQ(sum.other_wall, 3 * one.other_wall);
  EXPECT_EQ(sum.off_by_far[5], 3 * one.off_by_far[5]);
  EXPECT_EQ(sum.worst_ulps, 900U) << "the worst is no sum";
  EXPECT_EQ(sum.first_wrong, "item 3 ray 1");
}

// A run of a part of a chunk keeps a row, which a run of more does not take for the whole.
TEST_F(ChunkLogRows, OfAChunkTheRowOfMoreRaysCounts) {
  const ChunkLog::Key key{oracle::families().front().name, "grid", "avx2", 1, 0};
  for (const std::uint64_t rays : {10U, 70U, 30U}) {
    StabilityTally tally;
    tally.rays = rays;
    ASSERT_TRUE(StabilityLog::open(folder_.string())->add(key, tally, 0));
  }
  auto log = StabilityLog::open(folder_.string());
  EXPECT_EQ(log->sum(key, 1).rays, 70U);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> asked;
  const auto check = [&](std::uint64_t first, std::uint64_t count, const auto&) {
    asked.emplace_back(first, count);
    StabilityTally tally;
    tally.rays = count;
    return std::vector{tally};
  };
  ASSERT_TRUE(log->run({key}, {60, 100}, 1, check));
  EXPECT_TRUE(asked.empty()) << "70 are there";
  ASSERT_TRUE(log->run({key}, {230, 100}, 1, check));
  EXPECT_EQ(asked, (decltype(asked){{0, 100}, {100, 100}, {200, 30}}));
  EXPECT_EQ(log->sum(key, 3).rays, 230U);
}

TEST_F(ChunkLogRows, ColumnsAreNamedAndSecondsStandAfterTheFirstSix) {
  const std::string family = oracle::families().front().name;
  auto log = StabilityLog::open(folder_.string());
  EXPECT_FALSE(fs::exists(folder_)) << "what has no row writes nothing";
  ASSERT_TRUE(log->add({family, "grid", "avx2", 1, 0}, {}, 0));
  std::string header = read_file(folder_ / "stability.csv").value();
  header.resize(header.find('\n') + 1);
  EXPECT_EQ(
      header.substr(0, header.find("missed")),
      "family,tracer,isa,seed,chunk,rays,hits,wrong,t_not_nearest,t_off,by_rationals,seconds,");
  EXPECT_TRUE(header.ends_with(",t_off_2^48,first_wrong,check\n")) << header;
  ASSERT_TRUE(LeakLog::open(folder_.string())->add({"origin", "grid", "avx2", 1, 0}, {}, 0));
  std::string leaks = read_file(folder_ / "leaks.csv").value();
  leaks.resize(leaks.find('\n') + 1);
  EXPECT_EQ(leaks,
            "family,tracer,isa,seed,chunk,rays,bounces,leaks,corners,wrong,wrong_t,asked,beside,"
            "nothing,through_end,through,invented,seconds,check\n");
}

}  // namespace
}  // namespace flatray
