#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace flatray {
namespace {

TEST(ParallelFor, RunsEveryIndexOnceForAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 2U, 3U, 7U, 16U})
    for (const std::size_t count : {0U, 1U, 2U, 5U, 1000U}) {
      std::vector<std::atomic<int>> runs(count);
      parallel_for(count, threads, [&](std::size_t i) { runs[i].fetch_add(1); });
      for (const std::atomic<int>& run : runs) EXPECT_EQ(run.load(), 1) << threads << " threads";
    }
}

TEST(ParallelFor, TheExceptionOfATaskIsThrownAgain) {
  for (const unsigned threads : {1U, 2U, 3U, 7U, 16U})
    EXPECT_THROW(parallel_for(100, threads,
                              [](std::size_t i) {
                                if (i == 37) throw std::runtime_error("37");
                              }),
                 std::runtime_error)
        << threads << " threads";
}

TEST(ParallelFor, AfterAFailureNoNewTaskStarts) {
  std::atomic<int> runs{0};
  EXPECT_ANY_THROW(parallel_for(1000, 1, [&](std::size_t) {
    ++runs;
    throw std::runtime_error("first");
  }));
  EXPECT_EQ(runs.load(), 1);
}

TEST(ParallelFor, CallsMayNest) {
  std::atomic<int> runs{0};
  parallel_for(4, 2,
               [&](std::size_t) { parallel_for(8, 2, [&](std::size_t) { runs.fetch_add(1); }); });
  EXPECT_EQ(runs.load(), 32);
}

TEST(HardwareThreads, IsAtLeastOne) { EXPECT_GE(hardware_threads(), 1U); }

}  // namespace
}  // namespace flatray
