// needs: shapes/arc shapes/circle
#include <gtest/gtest.h>

#include "base/processor_time.h"
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

// A row of discs and arcs, of which those of `moving` move.
Scene row_of(int count, bool (*moving)(int), bool (*is_arc)(int)) {
  std::string text = "flatray = 1\nfps = 1\nframes = 2\n";
  for (int i = 0; i < count; ++i) {
    text += is_arc(i) ? "[[entity]]\nshape = { arc = { radius = 1, from = 0, to = 90 } }\n"
                      : "[[entity]]\nshape = { circle = { radius = 1 } }\n";
    text += "at = [" + std::to_string(5 * i) + ", 0]\n";
    if (moving(i)) text += "velocity = [1, 0.25]\n";
  }
  return loaded(text).scene;
}

TEST(PairTruth, TellsOfEachPairOfWhichOneMovesOnce) {
  for (int count = 2; count < 10; ++count) {
    const auto moving = [](int i) { return i % 3 != 1; };
    const auto is_arc = [](int i) { return i % 4 == 3; };
    std::set<PairTruth::Pair> expected;
    std::size_t left_out = 0;
    for (int a = 0; a < count; ++a)
      for (int b = a + 1; b < count; ++b) {
        if (!moving(a) && !moving(b)) continue;
        if (is_arc(a) || is_arc(b))
          ++left_out;
        else
          expected.emplace(a, b);
      }
    const Scene scene = row_of(count, moving, is_arc);
    const PairTruth truth = pair_truth(Timeline(scene, 1, scene.frames), scene.frames, 1e6);
    EXPECT_EQ(truth.compared, expected) << count;
    EXPECT_EQ(truth.left_out, left_out) << count;
  }
}

// There are 4.5 million pairs: a list of them, drawn into an order, would take seconds.
TEST(PairTruth, StopsInTimeHoweverManyPairsThereAre) {
  const Scene scene = row_of(
      3000, [](int) { return true; }, [](int) { return false; });
  const Timeline timeline(scene, 1, scene.frames);
  const double start = processor_seconds();
  const PairTruth truth = pair_truth(timeline, scene.frames, 0);
  EXPECT_LT(processor_seconds() - start, 1);
  EXPECT_EQ(truth.cut, 3000U * 2999 / 2 - 1);
}

}  // namespace
}  // namespace flatray
