// needs: shapes/box
// What a render of several frames leaves out, by counts of work.
#include <unistd.h>

#include <filesystem>

#include "app/frames/render_job.h"
#include "support/pictures.h"

namespace flatray {
namespace {

// Four frames of a box, by one thread.
JobResult four_frames(const std::string& entity, bool keep_all = false,
                      const std::string& pattern = "####.png") {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("flatray_omission" + std::to_string(getpid()));
  const Scene scene = scene_of(
      "flatray = 1\nframes = 4\nfilm = { size = [64, 32], world = [[0, 0], [16, 8]] }\n[[entity]]\n"
      "name = \"box\"\nshape = { box = { min = [0, 0], max = [5, 4] } }\n" +
      entity + "\n");
  const auto output = OutputPattern::parse((folder / pattern).string(), std::nullopt, {});
  const RenderJob job{scene, "boxes", *output, {1, 2, 3, 4}, 4, {}, {}, 0, keep_all};
  const JobResult result = run_job(Work{&job, {}, job.frames}, 1, [] {});
  EXPECT_TRUE(result.problems.empty());
  EXPECT_EQ(result.written.size(), 4U);
  std::filesystem::remove_all(folder);
  return result;
}

TEST(Omissions, OfASceneAtRestOnePictureIsDrawnAndEncodedForAllFrames) {
  for (const char* pattern : {"####.png", "####.hdr"}) {
    const JobResult once = four_frames("at = [3, 2]", false, pattern);
    EXPECT_EQ(once.encoded, 1U);
    EXPECT_EQ(once.drawn.bands, 1U);
    EXPECT_EQ(once.drawn.scans, 1U);
    EXPECT_EQ(once.drawn.kept_bands, 0U) << "nor is it compared with the next";
    const JobResult all = four_frames("at = [3, 2]", true, pattern);
    EXPECT_EQ(all.encoded, 4U);
    EXPECT_EQ(all.drawn.scans, 4U);
    EXPECT_EQ(once.written.back().pixels, all.written.back().pixels);
  }
}

TEST(Omissions, OfASceneThatMovesEachFrameIsDrawn) {
  const JobResult moving = four_frames("velocity = [12, 0]");
  EXPECT_EQ(moving.encoded, 4U);
  EXPECT_EQ(moving.drawn.bands, 4U);
}

// It moves beside the film.
TEST(Omissions, AFrameThatShowsWhatTheOneBeforeDidIsNotEncodedAgain) {
  const JobResult gone = four_frames("at = [-9, 0]\nvelocity = [1, 0]");
  EXPECT_EQ(gone.encoded, 1U);
  EXPECT_EQ(gone.drawn.bands + gone.drawn.kept_bands, 4U);
  EXPECT_EQ(gone.drawn.kept_bands, 3U);
}

}  // namespace
}  // namespace flatray
