// needs: shapes/arc shapes/bezier shapes/box shapes/capsule shapes/circle shapes/polygon shapes/segment choices/contact choices/motion choices/tracer
#include "study/accuracy/accuracy.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/processor_time.h"
#include "precise/certified_orbit.h"
#include "scene/scene_text.h"
#include "study/accuracy/accuracy_report.h"
#include "study/accuracy_scenes.h"
#include "study/chamber_scenes.h"

namespace flatray {
namespace {

AccuracyPoint point(double n, double error) {
  AccuracyPoint made;
  made.n = n;
  made.outcome.error = error;
  return made;
}

TEST(FittedOrder, IsTheExponentOfAPower) {
  std::vector<AccuracyPoint> points;
  for (const double n : {1.0, 4.0, 64.0, 1000.0}) points.push_back(point(n, 3 / std::sqrt(n)));
  points.push_back(point(0, 7));   // beside the row
  points.push_back(point(16, 0));  // no error has no logarithm
  const auto order = fit_order(points);
  ASSERT_TRUE(order);
  EXPECT_NEAR(order->slope, -0.5, 1e-14);
  EXPECT_LT(order->rest, 1e-28);
}

TEST(FittedOrder, IsOfOneSeriesAlone) {
  std::vector<AccuracyPoint> points;
  for (const double n : {1.0, 4.0, 64.0})
    for (const bool even : {false, true}) {
      points.push_back(point(n, even ? 2 / n : 3 / std::sqrt(n)));
      points.back().series = even ? "even" : "random";
    }
  EXPECT_EQ(series_of(points), (std::vector<std::string>{"random", "even"}));
  EXPECT_NEAR(fit_order(points, "random")->slope, -0.5, 1e-14);
  EXPECT_NEAR(fit_order(points, "even")->slope, -1, 1e-14);
  EXPECT_FALSE(fit_order(points));
}

TEST(FittedOrder, OfTwoPointsIsNone) {
  EXPECT_FALSE(fit_order({point(1, 1), point(2, 0.5)}));
  EXPECT_FALSE(fit_order({point(2, 1), point(2, 0.5), point(2, 0.25)}));
}

TEST(FittedOrder, IsTheExponentOfAnExponentialBelowItsEnd) {
  std::vector<AccuracyPoint> points;
  for (const double n : {1.0, 2.0, 8.0, 20.0})
    points.push_back(point(n, 1e-16 * std::exp(0.75 * n)));
  points.push_back(point(100, 1));
  const auto order = fit_order(points, "", Law::exponential, 1e-3);
  ASSERT_TRUE(order);
  EXPECT_NEAR(order->slope, 0.75, 1e-12);
  EXPECT_EQ(words(*order, "bounces"), "error ~ e^(0.750 bounces)");
  EXPECT_LT(order->rest, 1e-20);
  EXPECT_GT(fit_order(points, "", Law::power, 1e-3)->rest, 1);
}

TEST(FittedOrder, OfErrorsThatDoNotChangeIsNone) {
  EXPECT_FALSE(fit_order({point(1, 0.5), point(2, 0.5), point(4, 0.5)}));
}

// By tangents: experiment lyapunov.
TEST(Accuracy, ErrorOfOrbitsGrowsByTheLyapunovExponentOfTheirRoom) {
  if (!can_certify()) GTEST_SKIP() << "there is no MPFR";
  for (const Scene& scene : {testing::sinai("0.3"), testing::stadium()}) {
    const ChoiceReport report = testing::report_of("precision", scene, 1e6);
    ASSERT_EQ(report.orders.size(), 1U) << report.left_out;
    EXPECT_EQ(report.orders[0].law, Law::exponential);
    const Measure exponent =
        testing::measure(testing::run("lyapunov", {.scene = scene, .count = 200000}), "per_hit");
    EXPECT_NEAR(report.orders[0].slope, exponent.value, 0.1 * exponent.value);
  }
}

TEST(Accuracy, ErrorOfOrbitsInAPolygonGrowsLikeAPower) {
  if (!can_certify()) GTEST_SKIP() << "there is no MPFR";
  const Scene scene =
      testing::room("polygon = { points = [[0, 0], [4, 0], [5, 2], [2, 4], [-1, 2]] }");
  const ChoiceReport report = testing::report_of("precision", scene, 1e6);
  ASSERT_EQ(report.orders.size(), 1U) << report.left_out;
  EXPECT_EQ(report.orders[0].law, Law::power);
  EXPECT_GT(report.orders[0].slope, 0.5);
  EXPECT_LT(report.orders[0].slope, 2);
}

void spin(double seconds) {
  for (const double end = processor_seconds() + seconds; processor_seconds() < end;) {
  }
}

Setting setting(const char* words, double n, double seconds, double error) {
  return {words, n, [seconds] { spin(seconds); }, [error] { return Outcome{error}; }};
}

Result<ChoiceSettings> three(const AccuracyContext&) {
  return ChoiceSettings{{"the truth", "m", "steps"},
                        {setting("short", 1, 0, 0.5), setting("long and far", 2, 0.01, 0.75),
                         setting("long and near", 4, 0.01, 0.25)}};
}

TEST(Accuracy, BestIsWhatNoOtherSettingBeatsInBothTimeAndError) {
  const ChoiceReport report = testing::report_of(&three, 1e6);
  ASSERT_EQ(report.points.size(), 3U);
  EXPECT_TRUE(report.points[0].best);
  EXPECT_FALSE(report.points[1].best);
  EXPECT_TRUE(report.points[2].best);
  EXPECT_GT(report.points[2].seconds, 0.009);  // 0.01 but for rounding of the clock
  EXPECT_EQ(report.cut, "");
}

TEST(Accuracy, WhatTheBudgetCutsIsNamed) {
  const ChoiceReport report = testing::report_of(&three, 1e-9);
  EXPECT_EQ(report.points.size(), 1U);
  EXPECT_EQ(report.cut, "long and far, long and near");
}

Result<ChoiceSettings> dear(const AccuracyContext& context) {
  spin(0.05);
  auto made = three(context);
  made->missing.push_back({"far", "no road"});
  made->cut = "reference of less";
  return made;
}

TEST(Accuracy, TheBudgetIsOfTheReferenceToo) {
  const ChoiceReport report = testing::report_of(&dear, 0.04);
  EXPECT_GT(report.reference_seconds, 0.049);
  EXPECT_GE(report.seconds, report.reference_seconds);
  EXPECT_EQ(report.points.size(), 1U);
  EXPECT_EQ(report.cut, "reference of less, long and far, long and near");
  EXPECT_EQ(report.rounds, 1U);
}

TEST(Accuracy, WhatIsMissingHereIsNamedWithItsReason) {
  const ChoiceReport reports[] = {testing::report_of(&dear, 1e6)};
  const ExperimentResult result = accuracy_report("scene", reports);
  EXPECT_TRUE(testing::has(result.summary, "not here: far: no road"));
  for (const char* name : {"accuracy.json", "accuracy.html"})
    EXPECT_TRUE(testing::has(testing::content_of(result, name), "far: no road")) << name;
}

TEST(Accuracy, TheBestUnderASecondAndTheCheapestUnderAThousandthAreMarked) {
  ChoiceReport report;
  const auto add = [&](const char* words, double seconds, double error) {
    report.points.push_back({words, 0, seconds, 0, {error}, true});
  };
  add("fast", 0.5, 0.1);
  add("fair", 0.9, 0.01);
  add("near", 2, 0.0009);
  add("nearest", 9, 0.0001);
  EXPECT_EQ(advice(report, report.points[0]), "");
  EXPECT_EQ(advice(report, report.points[1]), "best under 1 s");
  EXPECT_EQ(advice(report, report.points[2]), "cheapest under 0.001");
  report.points[2].seconds = 0.95;
  EXPECT_EQ(advice(report, report.points[2]), "best under 1 s and cheapest under 0.001");
}

// Times of one round have no spread that could be told; it was told to be 0.
TEST(Accuracy, TheRangeOfTimesIsUnknownAfterOneRound) {
  ChoiceReport report;
  report.name = "one";
  report.rounds = 1;
  report.points.push_back({"once", 0, 0.5, 0, {0.1}});
  const auto file = [&](const char* name) {
    return testing::content_of(accuracy_report("scene", {&report, 1}), name);
  };
  EXPECT_TRUE(testing::has(file("accuracy.csv"), "0.5,unknown,"));
  EXPECT_TRUE(testing::has(file("accuracy.html"), "<td>0.5</td>"));
  report.rounds = 3;
  report.points[0].spread = 0.25;
  EXPECT_TRUE(testing::has(file("accuracy.csv"), "0.5,0.25,"));
  EXPECT_TRUE(testing::has(file("accuracy.html"), "<td>0.5 &plusmn; 0.2</td>"));
  EXPECT_TRUE(testing::has(accuracy_report("scene", {&report, 1}).summary, "half_range"));
}

constexpr const char* kHead =
    "flatray = 1\nfilm = { size = [24, 16], world = [[0, 0], [24, 16]] }\n";
const std::string kDisc =
    "[[entity]]\nshape = { circle = { centre = [11.3, 7.9], radius = 5.1 } }\n";
const std::string kBox = "[[entity]]\nshape = { box = { min = [3, 2], max = [9, 7] } }\n";

ChoiceReport report_of(std::string_view name, const std::string& text, double seconds = 10) {
  return testing::report_of(name, loaded(kHead + text).scene, seconds);
}

// 20 rays of each tracer of this build, against arithmetic that none of them has.
TEST(Accuracy, ExactTracersAreRightByTheIndependentReference) {
  const ChoiceReport report = report_of("tracer", kDisc + kBox, 0.5);
  EXPECT_TRUE(testing::has(report.reference, "oracle/long_orbit"));
  for (const AccuracyPoint& one : report.points)
    if (one.setting == "--tracer exact" || one.setting == "--tracer brute") {
      EXPECT_EQ(one.outcome.error, 0) << one.setting;
    }
}

// Of a point lamp in the open, with the root of random directions, with the 3/2 of those of a net.
TEST(Accuracy, OfLightFallsAsItsSamplerSays) {
  const ChoiceReport report =
      report_of("light", "[[lamp]]\nsource = { point = {} }\nat = [11.3, 7.9]\n", 4);
  ASSERT_EQ(report.left_out, "");
  if (report.orders.size() < 2) GTEST_SKIP() << "too slow for an order within 4 s";
  for (const FittedOrder& order : report.orders) {
    if (order.series == "backward") continue;
    EXPECT_NEAR(order.slope, order.series == "forward, sorted" ? -1.5 : -0.5, 0.2) << order.series;
  }
  EXPECT_NE(report_of("light", "").left_out, "");
}

ChoiceReport coverage_of(const std::string& text) { return report_of("coverage", text); }

double error_of(const ChoiceReport& report, const std::string& setting) {
  for (const AccuracyPoint& one : report.points)
    if (one.setting == setting) return one.outcome.error;
  return std::nan("");
}

TEST(Accuracy, OfCoverageIsNothingWhereOutlinesLieBetweenPixels) {
  const ChoiceReport report = coverage_of(kBox);
  EXPECT_EQ(error_of(report, "pixel centres"), 0);
  EXPECT_EQ(error_of(report, "exact area"), 0);
  EXPECT_EQ(error_of(report, "64 samples a pixel"), 0);
}

// Sides that grids of samples see in the same places: between two columns of them, or before the first.
TEST(Accuracy, ExactAreaOfABoxIsAsNearAsTheReferenceTellsWhereverItsSidesLie) {
  for (const double off : {0.49, 0.02, 0.98, 0.001}) {
    const auto corner = [off](int x, int y) { return fmt::format("[{}, {}]", x + off, y + off); };
    const ChoiceReport report = coverage_of("[[entity]]\nshape = { box = { min = " + corner(3, 2) +
                                            ", max = " + corner(9, 7) + " } }\n");
    const double area = error_of(report, "exact area");
    EXPECT_GT(area, 0) << off;
    EXPECT_LT(area, 0.002) << off;
    for (const AccuracyPoint& one : report.points) {
      EXPECT_GE(one.outcome.error, area) << off << one.setting;
      EXPECT_TRUE(one.outcome.at_most || one.setting != "exact area") << off;
    }
    if (off > 0.01) {
      EXPECT_GT(error_of(report, "pixel centres"), area) << off;
    }
  }
}

TEST(Accuracy, ExactAreaIsNearerThanFewSamplesToADisc) {
  const ChoiceReport report = coverage_of(kDisc);
  const double area = error_of(report, "exact area");
  EXPECT_GT(area, 0);
  EXPECT_LT(area, error_of(report, "16 samples a pixel"));
  EXPECT_LT(error_of(report, "16 samples a pixel"), error_of(report, "pixel centres"));
}

// Red over blue in one place: no blue shows at the rim.
TEST(Accuracy, AreasOfThingsOnEachOtherAreThoseOfTheUppermost) {
  const ChoiceReport report =
      coverage_of(kDisc + "fill = \"#0000ff\"\n" + kDisc + "fill = \"#ff0000\"\n");
  EXPECT_LT(error_of(report, "exact area"), error_of(report, "16 samples a pixel"));
}

TEST(Accuracy, OfChordsFallsLikeTheSquareOfTheirNumber) {
  const ChoiceReport report = report_of("flattening", kDisc);
  ASSERT_EQ(report.orders.size(), 1U);
  EXPECT_NEAR(report.orders.front().slope, -2, 0.2);
  EXPECT_LT(error_of(report, "curves as they are"), 1e-4);
  EXPECT_NE(report_of("flattening", "").left_out, "");
}

// Fine chords are a crowd in pixels in which few curves are none, so that strips were called nearer
// than what is exact.
TEST(Accuracy, NoChordsAreNearerThanTheCurvesWhereLinesCrossThem) {
  std::string text = "[[entity]]\nshape = { circle = { centre = [16, 10], radius = 8.3 } }\n";
  for (int i = 0; i < 3; ++i)
    text += "[[entity]]\nshape = { circle = { centre = [" + std::to_string(15.8 + 0.15 * i) +
            ", 10.1], radius = 8.2 } }\nfill = \"#ff0000\"\n";
  const ChoiceReport report = report_of("flattening", text);
  ASSERT_FALSE(report.points.empty());
  EXPECT_TRUE(report.points.back().outcome.at_most) << report.reference;
  EXPECT_LT(report.points.back().outcome.error, 2e-6);
}

// A line along a curve is a polygon in any case, whatever the scene holds.
TEST(Accuracy, OfChordsSaysThatNoCurveBoundsWhatIsFilled) {
  for (const char* shape : {"arc = { centre = [16, 10], radius = 5, from = 0, to = 200 }",
                            "bezier = { points = [[4, 4], [8, 20], [20, 20], [28, 4]] }"})
    EXPECT_TRUE(report_of("flattening", std::string("[[entity]]\nshape = { ") + shape +
                                            " }\nstroke = { width = 2, colour = \"#000000\" }\n")
                    .left_out.starts_with("no curve bounds what "))
        << shape;
}

// A disc flies through a wall, and a bar turns over a disc, both between two frames; the first ends
// beside a third disc, which only its box meets.
constexpr const char* kBent = R"(
[[entity]]
shape    = { circle = { radius = 0.25 } }
at       = [0, 4.125]
velocity = [15.5, 0]
[[entity]]
shape = { box = { min = [8, 0], max = [8.125, 8] } }
[[entity]]
shape            = { box = { min = [0, -0.1], max = [3, 0.1] } }
at               = [0, 20]
angular_velocity = 90
[[entity]]
shape = { circle = { radius = 0.2 } }
at    = [1.5, 21.5]
[[entity]]
shape = { circle = { radius = 0.25 } }
at    = [15.9, 4.525]
)";

void expect_that_instants_miss(const std::string& entities) {
  const Scene scene = loaded("flatray = 1\nfps = 1\nframes = 2\n" + entities).scene;
  const ChoiceReport contact = testing::report_of("contact", scene),
                     motion = testing::report_of("motion", scene);
  EXPECT_EQ(error_of(contact, "--method minkowski"), 0);
  EXPECT_GT(error_of(contact, "--method boxes"), 0);
  EXPECT_GT(error_of(contact, "--method edge-rays"), 0);
  EXPECT_EQ(error_of(motion, "all instants"), 0);
  EXPECT_GT(error_of(motion, "1 instant a frame"), 0);
  EXPECT_EQ(error_of(motion, "64 instants a frame"), 0);
  for (const ChoiceReport& report : {contact, motion})
    EXPECT_FALSE(error_parts(report, report.points.at(0))[3]) << "rounding is not defined";
}

TEST(Accuracy, OfMotionIsWhatFliesByBetweenInstants) {
  expect_that_instants_miss(testing::kBullet);
}

TEST(Accuracy, OfMotionIsOfDiscsAndOfWhatTurnsToo) { expect_that_instants_miss(kBent); }

TEST(Accuracy, PartsThatAreNotDefinedAreSaidToBeSo) {
  ChoiceReport report;
  report.name = "made";
  report.points.push_back({"one", 1, 0.5, 0, {0.25, 0, {}, {0.125, {}, 0.25, {}}}});
  report.points.push_back({"two", 2, 0.5, 0, {0.5}});
  report.kind = ErrorKind::discretisation;
  const ErrorParts none = {std::nullopt, std::nullopt, 0.5, std::nullopt};
  EXPECT_EQ(error_parts(report, report.points[1]), none);
  const ExperimentResult result = accuracy_report("scene", {&report, 1});
  EXPECT_TRUE(testing::has(result.files.front().content, ",0.125,not defined,0.25,not defined,"));
  EXPECT_TRUE(testing::has(result.summary, "not defined for its error: truncation, rounding"));
}

TEST(Accuracy, OfDepthIsTheShareOfOrbitsThatAreStillInside) {
  const ChoiceReport report = report_of("depth", R"(
[[entity]]
shape    = { segment = { from = [2, 2], to = [2, 14] } }
material = "mirror"
[[ray]]
at        = [12, 8]
direction = [-1, 0]
bounces   = 3
)");
  // 22 of 24 columns of pixels are right of the mirror, 12 of 16 rows between its ends.
  EXPECT_EQ(error_of(report, "1 bounce"), 22 * 12.0 / (24 * 16));
  EXPECT_EQ(error_of(report, "2 bounces"), 0);
  EXPECT_EQ(report.points.size(), 2U);  // all have ended
}

TEST(Accuracy, AChoiceASceneLacksIsLeftOutWithItsReason) {
  const Scene scene = loaded(kHead).scene;
  std::vector<ChoiceReport> reports;
  for (const Choice* choice : choices()) reports.push_back(measure_choice(*choice, {scene}));
  for (const ChoiceReport& report : reports)
    if (report.name != "coverage") {
      EXPECT_TRUE(report.points.empty()) << report.name;
      EXPECT_NE(report.left_out, "") << report.name;
    }
  const ExperimentResult result = accuracy_report("<&>", reports);
  const std::string& page = result.files.back().content;
  EXPECT_TRUE(testing::has(page, "&lt;&amp;&gt;: error against run time"));
  EXPECT_EQ(page.find("http:"), page.find("http://www.w3.org"));  // a name, nothing to fetch
  EXPECT_TRUE(testing::has(page, "src=\"data:image/png;base64,iVBORw0KGgo"));
}

}  // namespace
}  // namespace flatray
