// needs: shapes/circle
#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "study/stability/pair_truth.h"

namespace flatray {
namespace {

// Five discs have ten pairs: one is always told, and the nine others are counted where there is no time.
TEST(PairTruth, TellsHowManyPairsItHadNoTimeFor) {
  std::string text = "flatray = 1\nfps = 1\nframes = 2\n";
  for (int i = 0; i < 5; ++i)
    text += "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [" + std::to_string(i) +
            ", 0.5]\nvelocity = [1, " + std::to_string(i) + "]\n";
  const Scene scene = loaded(text).scene;
  const Timeline timeline(scene, 1, scene.frames);
  for (const double seconds : {-1.0, 0.0}) {
    const PairTruth truth = pair_truth(timeline, scene.frames, seconds);
    EXPECT_EQ(truth.cut, 9U) << seconds;
    EXPECT_EQ(truth.compared.size() + truth.grazing, 1U);
  }
  const PairTruth all = pair_truth(timeline, scene.frames, 1e6);
  EXPECT_EQ(all.cut, 0U);
  EXPECT_EQ(all.compared.size() + all.grazing, 10U);
}

}  // namespace
}  // namespace flatray
