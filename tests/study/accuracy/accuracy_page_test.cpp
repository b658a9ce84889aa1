#include "study/accuracy/accuracy_page.h"

#include <gtest/gtest.h>

#include "study/accuracy/accuracy.h"
#include "study/texts.h"

namespace flatray {
namespace {

// The best setting may have no error at all, and then no place on a logarithm.
TEST(AccuracyPage, APlotRingsWhatItShowsAndSaysWhatItCannot) {
  ChoiceReport report;
  report.name = "made";
  report.one_question = true;
  report.points.push_back({"right", 0.25, 0, 0, {0}});
  report.points.push_back({"wrong", 0.125, 0, 0, {0.5}});
  for (AccuracyPoint& point : report.points) point.best = true;
  const std::string text = accuracy_plot(report);
  EXPECT_TRUE(testing::has(text, "Without any error: right, best under 1 s"));
  EXPECT_FALSE(testing::has(text, "Ringed"));
  report.points[0].outcome.error = 0.25;
  EXPECT_TRUE(testing::has(accuracy_plot(report), "Ringed: right, best under 1 s"));
}

// Where each choice has one setting all of them would be 1.
TEST(AccuracyPage, HasAnOverviewWhereThereIsSomethingToCompare) {
  ChoiceReport report;
  report.name = "made";
  report.points.push_back({"one", 0.25, 0, 0, {0.5}});
  const auto page = [&] { return accuracy_page("scene", {&report, 1}, std::nullopt); };
  EXPECT_FALSE(testing::has(page(), "All choices: error"));
  report.points.push_back({"two", 0.5, 0, 0, {0.25}});
  EXPECT_TRUE(testing::has(page(), "All choices: error"));
}

}  // namespace
}  // namespace flatray
