#include "app/report/progress.h"

#include <gtest/gtest.h>

#include "app/frames/render_job.h"

namespace flatray {
namespace {

TEST(Progress, TheBarShowsWhatIsDoneAtWhatRateAndWhatIsLeft) {
  EXPECT_EQ(progress_bar(0, 120, 2), "[........................]  0/120");
  EXPECT_EQ(progress_bar(60, 120, 30),
            "[############............]  60/120  2.0 frames/s  30 s left");
  EXPECT_EQ(progress_bar(120, 120, 0), "[########################]  120/120");
  EXPECT_EQ(progress_bar(1, 24, 4, "blocks"),
            "[#.......................]  1/24  0.2 blocks/s  92 s left");
  EXPECT_EQ(progress_bar(0, 0, 1), "[########################]  0/0");
}

// Tests have no terminal.
std::string said(std::size_t total, ProgressMode mode) {
  ::testing::internal::CaptureStderr();
  Progress progress(total, mode);
  for (std::size_t i = 0; i < total; ++i) progress.step();
  progress.finish();
  return ::testing::internal::GetCapturedStderr();
}

TEST(Progress, LinesAreFiveAtMostAndTheLastIsTheEnd) {
  EXPECT_EQ(said(100, ProgressMode::always),
            "flatray: 1 %, 1 of 100 frames\nflatray: 25 %, 25 of 100 frames\n"
            "flatray: 50 %, 50 of 100 frames\nflatray: 75 %, 75 of 100 frames\n"
            "flatray: 100 %, 100 of 100 frames\n");
  EXPECT_EQ(said(2, ProgressMode::always),
            "flatray: 50 %, 1 of 2 frames\nflatray: 100 %, 2 of 2 frames\n");
  EXPECT_EQ(said(1, ProgressMode::always), "");
  EXPECT_EQ(said(9, ProgressMode::never), "");
  EXPECT_EQ(said(9, ProgressMode::automatic), "");
}

RenderJob job_of(int width, int height) {
  RenderJob job{{}, "", OutputPattern::parse("a.png", std::nullopt, {}).value(), {}, 1, {}, {}};
  job.scene.film.width = width, job.scene.film.height = height;
  return job;
}

// Many small frames side by side, and few by all threads; never more threads than asked for, and none idle
// where frames are enough.
TEST(Spread, UsesNoMoreThreadsThanThereAre) {
  const RenderJob small = job_of(64, 48);
  for (const unsigned threads : {1U, 2U, 3U, 8U, 16U})
    for (const std::size_t frames : {0U, 1U, 2U, 5U, 100U}) {
      const Spread found = spread(small, frames, threads);
      EXPECT_GE(found.frames_at_once, 1U);
      EXPECT_GE(found.threads_each, 1U);
      EXPECT_LE(found.frames_at_once * found.threads_each, threads);
      EXPECT_GT((found.frames_at_once + 1) * (found.threads_each + 1), threads);
      EXPECT_EQ(found.frames_at_once,
                std::min<std::size_t>(threads, std::max<std::size_t>(frames, 1)));
    }
  // Frames of 1.6 x 10^9 pixels are drawn one after another.
  EXPECT_EQ(spread(job_of(40'000, 40'000), 100, 8).frames_at_once, 1U);
  EXPECT_EQ(spread(job_of(40'000, 40'000), 100, 8).threads_each, 8U);
}

}  // namespace
}  // namespace flatray
