// needs: shapes/box choices/coverage passes/entities lamps/point
#include <gtest/gtest.h>

#include <set>

#include "scene/scene_text.h"
#include "study/accuracy/linear_error.h"
#include "study/accuracy_scenes.h"

namespace flatray {
namespace {

// Pixels are measured in the middle of the scene's frames, where this box has come from the left into
// view: samples find an error in it, which they do not in the frame before it comes.
TEST(Accuracy, OfCoverageIsThatOfTheFrameInTheMiddle) {
  for (const auto& [frames, middle] : {std::pair(1, 1), std::pair(2, 1), std::pair(9, 5)}) {
    const Scene scene =
        loaded("flatray = 1\nfps = 1\nframes = " + std::to_string(frames) +
               "\nfilm = { size = [12, 8], world = [[0, 0], [12, 8]] }\n"
               "[[entity]]\nshape = { box = { min = [-4.75, 2], max = [-0.25, 5.5] } }\n"
               "velocity = [1.25, 0]\nfill = \"#ff0000\"\n")
            .scene;
    const ChoiceReport report = testing::report_of("coverage", scene, 0.5);
    EXPECT_TRUE(report.reference.starts_with("frame " + std::to_string(middle) + " by "))
        << report.reference;
    ASSERT_FALSE(report.points.empty());
    EXPECT_EQ(report.points[0].outcome.error > 0, middle > 1);
  }
}

// What was called so was drawn as the scene asks.
TEST(Accuracy, ExactAreaIsThatOfAnySceneAndChosenSo) {
  for (const char* coverage : {"\"rows\"\nfilm.rows = 1", "\"centre\""}) {
    const Scene scene =
        loaded(std::string("flatray = 1\nfilm.size = [12, 8]\nfilm.world = [[0, 0], [12, 8]]\n"
                           "film.coverage = ") +
               coverage +
               "\n[[entity]]\nshape = { box = { min = [1.3, 2.3], max = [9.2, 5.7] } }\n")
            .scene;
    EXPECT_EQ(frame_to_draw({scene}).value()->list.coverage, Coverage::area) << coverage;
    for (const AccuracyPoint& one : testing::report_of("coverage", scene, 0.5).points)
      if (one.setting == "exact area") {
        EXPECT_LT(one.outcome.error, 0.01) << coverage;
        EXPECT_EQ(one.options, (RenderOptions{{"define", "film.coverage=\"area\""}}));
      }
  }
}

// Light is beside the question there, and all its rays would take longer than any budget.
TEST(Accuracy, TheFrameInTheMiddleHasFewRaysOfLight) {
  const auto light_of = [](const std::string& rays) {
    const Scene scene =
        loaded(
            "flatray = 1\nfilm = { size = [12, 8], world = [[0, 0], [12, 8]] }\nlight = { rays = " +
            rays + " }\n[[lamp]]\nsource = { point = {} }\nat = [6, 4]\n")
            .scene;
    const auto frame = frame_to_draw({scene}).value();
    for (const DrawItem& item : frame->list.items)
      if (item.light) return item.light->rgb;
    return std::vector<float>();
  };
  EXPECT_FALSE(light_of("4096").empty());
  EXPECT_EQ(light_of("1000000"), light_of("4096"));
}

// How much of a pixel a thing covers has nothing to do with rays.
TEST(Accuracy, AMagneticFieldLeavesOutWhatTracesRays) {
  const Scene scene = loaded(
                          "flatray = 1\nfilm = { size = [12, 8], world = [[0, 0], [12, 8]] }\n"
                          "[[chamber]]\nshape = { box = { min = [1, 1], max = [9, 7] } }\n"
                          "field = 0.1\n[[ray]]\nat = [4, 4]\ndirection = [1, 0]\n")
                          .scene;
  const std::set<std::string> straight = {"depth", "precision", "samples", "tracer"};
  for (const Choice* choice : choices())
    EXPECT_EQ(choice->left_out(scene) == kRaysAreBent, straight.contains(choice->name))
        << choice->name;
}

}  // namespace
}  // namespace flatray
