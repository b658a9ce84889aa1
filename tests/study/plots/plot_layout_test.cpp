// Where a figure has its words, that what it says of its points is drawn, and that it is seen.
#include <gtest/gtest.h>

#include <cmath>

#include "study/drawn_marks.h"
#include "study/plots/plot.h"
#include "study/texts.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// Words of a drawing that stand upright, or that do not, as spans along their reading.
std::vector<Range> word_spans(const Drawing& drawing, bool upright) {
  std::vector<Range> spans;
  for (const auto& words : marks_of<Drawing::Words>(drawing))
    if (words.upright == upright) {
      const double width = words_width(words.words), at = upright ? words.at.y() : words.at.x();
      spans.push_back({at - words.anchor * width, at + (1 - words.anchor) * width});
    }
  return spans;
}

// Found by the caustic of an ellipse, whose bar had a label longer than the figure is high.
TEST(Plot, LabelsOfLowAndNarrowMapsAreNotCutOff) {
  const std::string words = "a label of many words, which say what is counted, in world units";
  for (const auto& [width, height] : {std::pair(20, 2), {2, 20}, {8, 5}}) {
    Plot plot{"t", words, words, {}};
    plot.map.emplace(Plot::Map{Image(width, height, 3), {{0, 0}, {1.0 * width, 1.0 * height}}});
    plot.bar = bar_of(words, 200, &heat);
    const Drawing drawing = drawing_of(plot);
    for (const int axis : {0, 1})
      for (const Range& span : word_spans(drawing, axis == 1)) {
        EXPECT_GE(span.low, 0) << width << "x" << height;
        EXPECT_LE(span.high, drawing.size[axis]) << width << "x" << height;
      }
  }
}

TEST(Plot, LabelsOfTheLastTicksAreNotCutOff) {
  for (const double most : {0.0035, 0.007, 700000.0}) {
    Plot plot{"t", "x", "y", {}};
    plot.map.emplace(Plot::Map{Image(40, 10, 3), {{0, 0}, {most, 1}}});
    const Drawing drawing = drawing_of(plot);
    for (const Range& span : word_spans(drawing, false)) {
      EXPECT_GE(span.low, 0) << most;
      EXPECT_LE(span.high, drawing.size.x()) << most;
    }
  }
}

// WCAG 2.1, 1.4.11: what a graphic is understood by has a contrast of 3 or more to what lies beside it.
TEST(Plot, CurvesAreSeenOnTheirPaper) {
  for (const bool dark : {false, true}) {
    const auto level = [&](const std::string& ink) {
      const LinearRgb light = light_of_hex(ink_colour(ink, dark));
      return 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b + 0.05;
    };
    for (std::size_t i = 0; i < 7; ++i) {
      const double ratio = level("paper") / level(series_ink(i));
      EXPECT_GE(std::max(ratio, 1 / ratio), 3) << series_ink(i) << (dark ? ", dark" : "");
    }
  }
}

// What was estimated has its interval where points are joined, too.
TEST(Plot, LinesHaveTheIntervalsOfTheirPoints) {
  const Plot plot{"t", "x", "y", {{"", {{0, 1, 0.5}, {1, 2, 0.25}, {2, 2}}}}};
  std::vector<double> heights;
  for (const auto& path : marks_of<Drawing::Path>(drawing_of(plot)))
    if (path.pen.stroke == "blue")
      heights.push_back(std::fabs(path.points[0].y() - path.points[1].y()));
  ASSERT_EQ(heights.size(), 3U) << "two intervals and the line";
  EXPECT_NEAR(heights[0], 2 * heights[1], 1e-9);
}

TEST(Plot, NoLabelLiesOverAnInterval) {
  const Plot plot{"t", "x", "y", {{"s", {{5, 5, 0, "a label", 4}, {0, 0}, {10, 10}}, true}}};
  double interval = 0;
  const Drawing drawing = drawing_of(plot);
  for (const auto& path : marks_of<Drawing::Path>(drawing))
    if (path.pen.stroke == "blue") interval = path.points[0].y();
  for (const auto& words : marks_of<Drawing::Words>(drawing))
    if (words.words == "a label") {
      EXPECT_GT(std::fabs(words.at.y() - interval), 7);
    }
  EXPECT_GT(interval, 0);
}

// Words of the ticks of x: all that stand in the row of the first of them.
std::vector<std::string> words_below(const Drawing& drawing) {
  double row = 0;
  std::vector<std::string> found;
  for (const auto& words : marks_of<Drawing::Words>(drawing))
    if (!words.bold) {
      if (row == 0) row = words.at.y();
      if (words.at.y() == row) found.push_back(words.words);
    }
  return found;
}

TEST(Plot, CountsHaveTicksAtWholeNumbers) {
  Plot plot{"t", "x", "y", {{"", {{1, 0.25}, {2, 0.5}, {3, 0.5}}, true}}};
  EXPECT_EQ(words_below(drawing_of(plot)), (std::vector<std::string>{"1", "2", "3"}));
  plot.series[0].points[1].x = 1.75;
  EXPECT_GT(words_below(drawing_of(plot)).size(), 3U);
}

TEST(Plot, TicksFarFromTheOriginDoNotOverlap) {
  const Plot plot{"t", "x", "y", {{"", {{1e15, 0}, {1e15 + 40, 1}}, true}}};
  const Drawing drawing = drawing_of(plot);
  const std::size_t count = words_below(drawing).size();
  EXPECT_GE(count, 1U);
  const std::vector<Range> spans = word_spans(drawing, false);  // the title is the first
  for (std::size_t i = 2; i <= count; ++i) EXPECT_LT(spans[i - 1].high, spans[i].low);
}

TEST(Plot, TheLegendNamesWhatIsShownAlone) {
  const Plot plot{"t", "x", "y", {{"some", {{1, 1}, {2, 2}}}, {"zeros", {{1, 0}, {2, 0}}}}, true};
  const std::string text = svg(plot);
  EXPECT_TRUE(has(text, ">some</text>"));
  EXPECT_FALSE(has(text, ">zeros</text>")) << "no logarithm, no mark, no name";
}

// Each looked at all others for a place that was not there: 8000 took 19 s.
TEST(Plot, ACrowdOfPointsHasFewWordsAndSaysHowManyAreLeftOut) {
  Plot plot{"t", "x", "y", {{"", {}, true}}};
  const auto named = [&] {
    int count = 0;
    for (const auto& words : marks_of<Drawing::Words>(drawing_of(plot)))
      if (words.words == "a point") ++count;
    return count;
  };
  const auto add = [&](int count) {
    for (int i = 0; i < count; ++i) plot.series[0].points.push_back({1, 1, 0, "a point"});
  };
  add(300);
  const int few = named();
  EXPECT_GT(few, 0);
  EXPECT_LT(few, 100);
  EXPECT_FALSE(has(svg(plot), "without words"));
  add(1700);
  EXPECT_EQ(named(), few);
  EXPECT_TRUE(has(svg(plot), ">" + std::to_string(2000 - few) + " points without words</text>"));
}

// Found by a caustic as bright as it gets at less than its largest number.
TEST(Plot, NumbersOfAColourBarDoNotOverlap) {
  for (const int height : {2, 20}) {
    Plot plot{"t", "x", "y", {}};
    plot.map.emplace(Plot::Map{Image(20, height, 3), {{0, 0}, {1, 1}}});
    plot.bar = bar_of("b", 101'500, &heat, [](double n) { return 1 - std::exp(-n / 100); });
    EXPECT_EQ(plot.bar->ticks.back().second, "1.015e5");
    std::vector<Drawing::Words> shown;
    for (const auto& words : marks_of<Drawing::Words>(drawing_of(plot)))
      if (words.anchor == 0 && !words.upright) shown.push_back(words);
    ASSERT_GE(shown.size(), 2U);
    EXPECT_EQ(shown.front().words, "0");
    EXPECT_EQ(shown.back().words, "1.015e5");
    for (std::size_t i = 1; i < shown.size(); ++i)
      EXPECT_GE(shown[i - 1].at.y() - shown[i].at.y(), 13) << shown[i].words;
  }
}

}  // namespace
}  // namespace flatray
