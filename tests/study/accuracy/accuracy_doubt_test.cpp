// needs: shapes/box shapes/polygon choices/contact choices/motion
// What is told of an error that the reference leaves in doubt.
#include <gtest/gtest.h>

#include "base/processor_time.h"
#include "scene/scene_text.h"
#include "study/accuracy/accuracy_report.h"
#include "study/accuracy_scenes.h"
#include "study/stability/pair_scene.h"
#include "study/texts.h"

namespace flatray {
namespace {

TEST(Accuracy, ADoubtThatReachesBeyondAnErrorLeavesNoAdvice) {
  ChoiceReport report;
  report.points.push_back({"none seen wrong", 0, 0.5, 0, {0, 0.79}, true});
  report.points.push_back({"half wrong", 0, 0.25, 0, {0.5, 0.26}, true});
  EXPECT_EQ(advice(report, report.points[0]), "");
  EXPECT_EQ(advice(report, report.points[1]), "");
  report.points[0].outcome.half = 0.0009;
  EXPECT_EQ(advice(report, report.points[0]), "best under 1 s and cheapest under 0.001");
}

// z^2 / (n + z^2) where none is wrong; [0.2366, 0.7634] of 5 in 10.
TEST(Accuracy, AShareIsInDoubtThoughNoneIsWrong) {
  EXPECT_EQ(share_of(0, 0).half, 1);
  EXPECT_EQ(share_of(0, 1).value, 0);
  EXPECT_NEAR(share_of(0, 1).half, 1.96 * 1.96 / (1 + 1.96 * 1.96), 1e-15);
  EXPECT_NEAR(share_of(0, 100).half, 0.036995, 1e-6);
  EXPECT_NEAR(share_of(5, 10).half, 0.263410, 1e-6);
  EXPECT_NEAR(share_of(7, 7).half, share_of(0, 7).half, 1e-15);
}

Result<ChoiceSettings> doubtful(const AccuracyContext&) {
  const auto setting = [](const char* words, double n, double error) {
    return Setting{words, n, [] {}, [error] { return Outcome{error}; }};
  };
  ChoiceSettings made{{"the truth", "m", "steps"},
                      {setting("far", 1, 0.5), setting("near", 2, 0.25)}};
  made.doubt = 0.3;
  return made;
}

TEST(Accuracy, AnErrorBelowTheDoubtOfTheReferenceIsAtMostThat) {
  const ChoiceReport reports[] = {testing::report_of(&doubtful, 1e6)};
  const std::vector<AccuracyPoint>& points = reports[0].points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].outcome.error, 0.5);
  EXPECT_FALSE(points[0].outcome.at_most);
  EXPECT_EQ(points[1].outcome.error, 0.3);
  EXPECT_TRUE(points[1].outcome.at_most);
  const std::string summary = accuracy_report("scene", reports).summary;
  EXPECT_TRUE(testing::has(summary, "<= 0.3"));
  EXPECT_TRUE(testing::has(summary, "nearer than the reference tells: near"));
}

// Boxes met too often for a list of them, which ended the program.
Result<ChoiceSettings> one_fails(const AccuracyContext& context) {
  auto made = doubtful(context);
  made->settings.insert(
      made->settings.begin(),
      {"boxes", 0, [] {}, []() -> Result<Outcome> { return fail({}, "too many"); }});
  return made;
}

TEST(Accuracy, ASettingThatComesToNothingIsNamedWithItsReason) {
  const ChoiceReport report = testing::report_of(&one_fails, 1e6);
  EXPECT_EQ(report.points.size(), 2U);
  ASSERT_EQ(report.missing.size(), 1U);
  EXPECT_EQ(report.missing[0].words + ": " + report.missing[0].why, "boxes: too many");
}

Result<ChoiceSettings> long_reference(const AccuracyContext& context) {
  for (const double end = processor_seconds() + 0.05; processor_seconds() < end;) {
  }
  return doubtful(context);
}

TEST(Accuracy, WhatTheBudgetHasNoTimeForIsLeftOutButOneSetting) {
  const auto choice = [](const char* name, auto* settings) {
    return Choice{name, "?", ErrorKind::truncation, [](const Scene&) { return std::string(); },
                  settings};
  };
  const Choice all[] = {choice("late", &doubtful), choice("long", &long_reference),
                        choice("early", &doubtful)};
  const Choice* turns[] = {&all[0], &all[1], &all[2]};
  const Scene scene;
  const auto reports = measure_choices(turns, {scene, 1, 1, 0.05});
  EXPECT_EQ(reports[2].left_out, "");
  EXPECT_GE(reports[2].points.size(), 1U);
  EXPECT_EQ(reports[1].left_out, "its reference took all of its part of the budget");
  EXPECT_TRUE(reports[1].points.empty());
  EXPECT_EQ(reports[0].left_out, "no time of the budget is left");
  EXPECT_EQ(reports[0].seconds, 0);
  const auto alone = measure_choices(std::span(turns).first(2), {scene, 1, 1, 0x1p-30});
  EXPECT_EQ(alone[1].points.size(), 1U);
  EXPECT_EQ(alone[0].left_out, "no time of the budget is left");
}

TEST(Accuracy, PairsThatAreNotToldAreNotJudged) {
  const Scene scene =
      loaded("flatray = 1\nfps = 1\nframes = 2\n" + std::string(testing::kBullet)).scene;
  const auto pairs = pair_scene({scene}).value();
  pairs->tell(fail({}, "too many"));
  EXPECT_EQ(judged_pairs(pairs)().error().front().message, "too many");
  pairs->tell(std::vector<Meeting>{});
  EXPECT_EQ(judged_pairs(pairs)().value().error, 1);
}

TEST(Accuracy, OneOfManyPairsTellsNothing) {
  const Scene scene =
      loaded("flatray = 1\nfps = 1\nframes = 2\n" + std::string(testing::kBullet)).scene;
  for (const char* name : {"contact", "motion"}) {
    const ChoiceReport report = testing::report_of(name, scene, 0);
    ASSERT_TRUE(testing::has(report.cut, "reference for 2 pairs more"));
    for (const AccuracyPoint& one : report.points) {
      EXPECT_GT(one.outcome.half, 0.2) << one.setting;
      // An error of 1 is known to within itself.
      EXPECT_EQ(advice(report, one), one.outcome.error == 1 ? "best under 1 s" : "") << one.setting;
    }
  }
}

}  // namespace
}  // namespace flatray
