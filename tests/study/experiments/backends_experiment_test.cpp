// needs: gl shapes/box experiments/backends backends/gl passes/entities
#include <gtest/gtest.h>

#include "study/chamber_scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// Of three frames with 4 samples and with 16: whole pixels do not differ, and the text says so.
TEST(BackendsExperiment, SaysThatSamplesExplainAllDifferences) {
  const Scene scene = scene_of(
      "frames = 5\nfilm = { size = [24, 16], world = [[0, 0], [24, 16]] }\n"
      "[[entity]]\nshape = { box = { min = [2, 2], max = [9.25, 9] } }\nvelocity = [1, 2.5]\nfill "
      "= \"#c03020\"\n");
  const ExperimentResult result = run("backends", {scene});
  EXPECT_TRUE(result.holds);
  EXPECT_TRUE(has(result.summary, "all differences are those between exact areas and samples\n"));
  ASSERT_EQ(result.files.size(), 2U);
  const std::string& rows = result.files[0].content;
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + 2 * 3);
  for (const char* frame : {",1,4,", ",3,4,", ",5,4,", ",1,16,", ",3,16,", ",5,16,"})
    EXPECT_TRUE(has(rows, frame)) << frame;
  EXPECT_TRUE(has(result.files[1].content, "\"faults\": 0"));
}

}  // namespace
}  // namespace flatray
