// Where pictures of numbers have their marks: by their own axes, read back from the text.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>

#include "geom/bounds.h"
#include "image/png.h"
#include "study/drawn_marks.h"
#include "study/plots/plot.h"
#include "study/plots/plot_axes.h"
#include "study/plots/state_graph.h"
#include "study/texts.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// All places that a pattern of two numbers finds.
std::vector<Vec2> places(const std::string& text, const std::string& pattern) {
  std::vector<Vec2> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  return found;
}

std::vector<Vec2> labels(const std::string& text, const std::string& words) {
  return places(text, "<text x=\"([0-9.-]+)\" y=\"([0-9.-]+)\"[^>]*>" + words + "</text>");
}

Vec2 label(const std::string& text, const std::string& words) {
  const auto at = labels(text, words);
  EXPECT_EQ(at.size(), 1U) << words;
  return at.empty() ? Vec2(0, 0) : at.front();
}

TEST(Plot, PointsLieAtTheirNumbersOnTheAxes) {
  Plot plot{"t", "x", "y", {{"", {{0, -3}, {1, 0}, {2, 3}, {4, 7, 2}}, true}}};
  const std::string text = svg(plot);
  const auto points = places(text, "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"3\"");
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(points[2].x() - points[1].x(), points[1].x() - points[0].x(), 0.02);
  EXPECT_NEAR(points[3].x() - points[2].x(), 2 * (points[2].x() - points[1].x()), 0.02);
  EXPECT_NEAR(points[1].y() - points[2].y(), points[0].y() - points[1].y(), 0.02);
  EXPECT_GT(points[0].y(), points[1].y());  // y goes up
  EXPECT_GT(points[1].x(), points[0].x());
  for (const auto& [words, x] : std::map<std::string, double>{{"1", 1}, {"3", 3}})
    EXPECT_NEAR(label(text, words).x(), points[0].x() + x * (points[1].x() - points[0].x()), 0.02);
  for (const auto& [words, y] : std::map<std::string, double>{{"6", 6}})
    EXPECT_NEAR(label(text, words).y(), points[1].y() + y * (points[2].y() - points[1].y()) / 3,
                0.02);
  // The interval of the last, of 2 to either side.
  const auto bar =
      places(text, "<path d=\"M[0-9.]+ ([0-9.]+)L[0-9.]+ ([0-9.]+)\" class=\"s-blue\"");
  ASSERT_EQ(bar.size(), 1U);
  EXPECT_NEAR(std::fabs(bar[0].x() - bar[0].y()), 4 * (points[1].y() - points[2].y()) / 3, 0.03);
  EXPECT_NEAR(0.5 * (bar[0].x() + bar[0].y()), points[3].y(), 0.02);
  const auto frame = places(text, "<path d=\"M([0-9.]+) ([0-9.]+)L[^\"]*Z\" class=\"s-axis\"");
  ASSERT_EQ(frame.size(), 1U);
  for (const Vec2& point : points) {  // in the frame
    EXPECT_GT(point.x(), frame[0].x());
    EXPECT_LT(point.x(), 500);
    EXPECT_GT(point.y(), frame[0].y());
    EXPECT_LT(point.y(), frame[0].y() + 281);
  }
}

TEST(Plot, LogarithmsAreEvenlySpacedAndTheirTicksArePowersOfTen) {
  Plot plot{"t",  "x", "y", {{"", {{1e-4, 1}, {1e-2, 100}, {1, 1e4}, {-1, 5}, {5, 0}}, true}},
            true, true};
  plot.series[0].points[1].label = "here";
  plot.series[0].points[1].ringed = true;
  const std::string text = svg(plot);
  const auto points = places(text, "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"3\"");
  ASSERT_EQ(points.size(), 3U) << "what is not above 0 is left out";
  EXPECT_LT((points[2] - points[1] - (points[1] - points[0])).norm(), 0.03);
  const auto ring = places(text, "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"6\"");
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_LT((ring[0] - points[1]).norm(), 0.02);
  EXPECT_NEAR(label(text, "here").y(), ring[0].y(), 0.02);
  for (const auto& [words, share] :
       std::map<std::string, double>{{"0.0001", 0}, {"0.001", 0.5}, {"0.1", 1.5}})
    EXPECT_NEAR(label(text, words).x(), points[0].x() + share * (points[1].x() - points[0].x()),
                0.02)
        << words;
  for (const auto& [words, share] : std::map<std::string, double>{{"10", 0.5}, {"1000", 1.5}})
    EXPECT_NEAR(label(text, words).y(), points[0].y() + share * (points[1].y() - points[0].y()),
                0.02)
        << words;
}

// Pieces of a drawing that hold words, as boxes of the widest letters.
std::vector<Bounds> word_boxes(const Drawing& drawing, const std::string& beginning = "") {
  std::vector<Bounds> boxes;
  for (const auto& words : marks_of<Drawing::Words>(drawing))
    if (!words.upright && words.words.starts_with(beginning)) {
      const double width = words_width(words.words);
      const Vec2 low = words.at - Vec2(words.anchor * width, 6);
      boxes.push_back({low, low + Vec2(width, 12)});
    }
  return boxes;
}

// Whether more than their borders have a point in common.
bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x() < b.high.x() && b.low.x() < a.high.x() && a.low.y() < b.high.y() &&
         b.low.y() < a.high.y();
}

// Whatever way curves take, and however many there are: names stand below the axes.
TEST(Plot, TheLegendCoversNoCurveAndNoWordsOverlap) {
  for (const std::size_t count : {1U, 3U, 17U}) {
    Plot plot{"t", "x", "y", {}};
    for (std::size_t k = 0; k < count; ++k) {
      Plot::Series& series = plot.series.emplace_back(
          Plot::Series{"a name of series " + std::to_string(k), {}, k % 2 == 1});
      for (int i = 0; i <= 10; ++i)
        series.points.push_back({1.0 * i, i * (3.0 - 1.0 * static_cast<double>(k))});
    }
    const Drawing drawing = drawing_of(plot);
    const std::vector<Bounds> boxes = word_boxes(drawing);
    double lowest = 0;
    for (const auto& path : marks_of<Drawing::Path>(drawing))
      if (path.points.size() > 5)
        for (const Vec2& point : path.points) {
          lowest = std::max(lowest, point.y());
          for (const Bounds& box : boxes) EXPECT_FALSE(box.contains(point));
        }
    EXPECT_GT(lowest, 100);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_GE(boxes[i].low.x(), 0);
      EXPECT_LE(boxes[i].high.x(), drawing.size.x());
      EXPECT_LE(boxes[i].high.y(), drawing.size.y());
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(overlap(boxes[i], boxes[k])) << i << " " << k;
    }
  }
}

// A dozen points in a heap: each has its label, none over a point or another label.
TEST(Plot, LabelsOfPointsOverlapNothing) {
  Plot plot{"t", "x", "y", {{"s", {}, true}}};
  for (int i = 0; i < 12; ++i)
    plot.series[0].points.push_back(
        {5 + 0.1 * (i % 4), 5 + 0.1 * i, 0, "point " + std::to_string(i)});
  plot.series[0].points.push_back({0, 0});
  plot.series[0].points.push_back({10, 10});
  const Drawing drawing = drawing_of(plot);
  const std::vector<Bounds> labels = word_boxes(drawing, "point");
  ASSERT_EQ(labels.size(), 12U);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(labels[i], labels[k]));
    for (const auto& disc : marks_of<Drawing::Disc>(drawing))
      EXPECT_FALSE(labels[i].contains(disc.centre));
  }
}

// Also on logarithms, and where an interval reaches 0 or below.
TEST(Plot, IntervalsLieWithinTheAxes) {
  Plot plot{"t", "x", "y", {{"", {{1, 1, 0.5, "", 0.9}, {2, 5, 6, "", 3}}, true}}, true, true};
  std::vector<std::vector<Vec2>> bars;
  Bounds frame;
  for (const auto& path : marks_of<Drawing::Path>(drawing_of(plot))) {
    if (path.pen.stroke == "blue") bars.push_back(path.points);
    if (path.closed && path.pen.stroke == "axis") frame.add(box_about(path.points));
  }
  ASSERT_EQ(bars.size(), 4U);
  for (const auto& bar : bars)
    for (const Vec2& end : bar) EXPECT_TRUE(frame.contains(end)) << end.transpose();
  EXPECT_NEAR(bars[2][0].y(), frame.high.y(), 1) << "down to the border, as 0 is nowhere";
  EXPECT_GT(bars[0][0].y(), bars[0][1].y());
}

TEST(Plot, LinesEndAtTheAxes) {
  Plot plot{
      "t", "x", "y", {{"", {{-5, 0.5}, {0.5, 0.5}, {0.5, 9}, Plot::gap(), {0.2, -3}, {0.2, 0.1}}}}};
  plot.window = Bounds{{0, 0}, {1, 1}};
  std::vector<std::vector<Vec2>> ways;
  for (const auto& path : marks_of<Drawing::Path>(drawing_of(plot)))
    if (path.pen.stroke == "blue") ways.push_back(path.points);
  ASSERT_EQ(ways.size(), 2U);
  ASSERT_EQ(ways[0].size(), 3U);
  const Vec2 middle = ways[0][1];
  EXPECT_NEAR(ways[0][0].y(), middle.y(), 1e-9);
  EXPECT_NEAR(ways[0][2].x(), middle.x(), 1e-9);
  ASSERT_EQ(ways[1].size(), 2U);
  EXPECT_NEAR(ways[1][0].y() - middle.y(), middle.y() - ways[0][2].y(), 1e-9)
      << "from border to border";
}

TEST(Plot, AColourBarEndsAtTheNumbersOfTheData) {
  const Plot::Bar even = bar_of("b", 37.5, &heat);
  EXPECT_EQ(even.ticks.front(), (std::pair<double, std::string>(0, "0")));
  EXPECT_EQ(even.ticks.back(), (std::pair<double, std::string>(1, "37.5")));
  for (const auto& [part, words] : even.ticks) EXPECT_NEAR(part, std::stod(words) / 37.5, 1e-12);
  const Plot::Bar by_log =
      bar_of("b", 200, &heat, [](double number) { return log_share(number, 200); });
  EXPECT_EQ(by_log.ticks.back(), (std::pair<double, std::string>(1, "200")));
  const std::vector<std::pair<double, std::string>> whole = {
      {0, "0"}, {0.25, "1"}, {0.5, "2"}, {0.75, "3"}, {1, "4"}};
  EXPECT_EQ(bar_of("b", 4, &heat).ticks, whole) << "each number once";
  for (const auto& [part, words] : by_log.ticks)
    EXPECT_NEAR(part, std::log(1 + std::stod(words)) / std::log(201), 1e-9) << words;
  EXPECT_EQ(even.strip.at(0, 0)[2], 255) << "white on top";
  EXPECT_EQ(even.strip.at(0, 255)[0], 0) << "black below";
}

// Found by a wedge in whose picture no ray is reflected.
TEST(Plot, ABarOfNothingButZerosAndAxesFarFromTheOriginHaveFewTicks) {
  const auto share = [](double number) { return log_share(number, 0); };
  for (const Plot::Bar& bar : {bar_of("b", 0, &heat), bar_of("b", 0, &heat, share)}) {
    ASSERT_EQ(bar.ticks.size(), 1U);
    EXPECT_EQ(bar.ticks.front(), (std::pair<double, std::string>(0, "0")));
  }
  EXPECT_TRUE(ticks(0x1p60, 0x1p60 + 512, 6).empty());
  EXPECT_TRUE(ticks(1, 1, 6).size() <= 1);
  EXPECT_TRUE(log_ticks(-kInfinity, 3, 6).empty());
}

// The picture's pixels are those of the map, its corners at the ends of the axes.
TEST(Plot, AMapIsDrawnPixelByPixelInBothWriters) {
  Plot plot{"t", "x", "y", {}};
  plot.map.emplace(Plot::Map{Image(2, 1, 3), {{0, 0}, {2, 1}}});
  plot.map->image.pixels = {255, 0, 0, 0, 0, 255};
  const Drawing drawing = drawing_of(plot);
  const Image image = pixels(drawing, 2);
  EXPECT_EQ(image.width, 2 * drawing.size.x());
  std::size_t red = 0, blue = 0;
  int first_blue = image.width, last_red = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      if (p[0] == 255 && p[1] == 0) ++red, last_red = std::max(last_red, x);
      if (p[2] == 255 && p[1] == 0) ++blue, first_blue = std::min(first_blue, x);
    }
  EXPECT_GT(red, 1000U);
  EXPECT_EQ(red, blue);
  EXPECT_EQ(first_blue, last_red + 1);
  EXPECT_TRUE(has(svg(drawing), "<image"));
  ExperimentResult result;
  add_plot(result, "map", plot, 1);
  ASSERT_EQ(result.files.size(), 2U);
  const auto png = decode_png(std::as_bytes(std::span(result.files[1].content)), "map.png");
  ASSERT_TRUE(png);
  EXPECT_EQ(std::max(png->width, png->height), 1000);
  add_map(result, "map", plot, 1, [](std::size_t i) { return std::to_string(i); });
  EXPECT_EQ(result.files.back().name, "map_pixels.csv");
  EXPECT_EQ(result.files.back().content, "y,0.5,1.5\n0.5,0,1\n");
}

TEST(Plot, TicksAreNumbersAsPeopleWriteThem) {
  EXPECT_EQ(tick_words(0.001), "0.001");
  EXPECT_EQ(tick_words(1e20), "1e20");
  EXPECT_EQ(tick_words(-2.5e-7), "-2.5e-7");
  EXPECT_EQ(tick_words(-0.0), "0");
  std::vector<std::string> words;
  for (const Tick& tick : log_ticks(-7, 7, 20)) words.push_back(tick.words);
  EXPECT_EQ(words,
            (std::vector<std::string>{"1e-7", "1e-6", "1e-5", "0.0001", "0.001", "0.01", "0.1", "1",
                                      "10", "100", "1000", "10000", "100000", "1e6", "1e7"}));
}

TEST(Plot, TicksOfAnAxisHaveOneExponentAndDiffer) {
  using Words = std::vector<std::string>;
  const auto words = [](double low, double high) {
    Words all;
    for (const Tick& tick : ticks(low, high, 5)) all.push_back(tick.words);
    return all;
  };
  EXPECT_EQ(words(0, 2e15), (Words{"0", "0.5e15", "1e15", "1.5e15", "2e15"}));
  EXPECT_EQ(words(999'999e9, 1'000'001e9),
            (Words{"0.999999e15", "0.9999995e15", "1e15", "1.0000005e15", "1.000001e15"}));
  EXPECT_EQ(words(1e15 - 2, 1e15 + 2),
            (Words{"999999999999998", "999999999999999", "1000000000000000", "1000000000000001",
                   "1000000000000002"}));
  EXPECT_EQ(words(-1e-5, 1e-5), (Words{"-1e-5", "-0.5e-5", "0", "0.5e-5", "1e-5"}));
  EXPECT_EQ(words(-1, 1), (Words{"-1", "-0.5", "0", "0.5", "1"}));
  EXPECT_EQ(words(0, 1e6), (Words{"0", "0.2e6", "0.4e6", "0.6e6", "0.8e6", "1e6"}));
  EXPECT_EQ(words(99'996, 100'004), (Words{"99996", "99998", "100000", "100002", "100004"}));
}

TEST(Plot, LogarithmsOfNumbersCloseTogetherHaveTicksToo) {
  const std::vector<Tick> all = log_ticks(std::log10(0.0033), std::log10(0.0038), 7);
  ASSERT_GE(all.size(), 3U);
  for (const Tick& tick : all) EXPECT_NEAR(tick.at, std::log10(std::stod(tick.words)), 1e-9);
}

TEST(HeatMap, CellsLieByTheirNumbers) {
  const HeatMap map{"title", "along", "up", {1, 2, 3, 4}, {10, 20}, {0, 0.5, 0, 0, 0, 0, 0, 1}};
  const Plot plot = plot_of(map);
  EXPECT_EQ(plot.map->bounds.low, Vec2(0.5, 5));
  EXPECT_EQ(plot.map->bounds.high, Vec2(4.5, 25));
  const auto colour = [](const Image& image, int x, int y) {
    return std::vector<int>(image.at(x, y), image.at(x, y) + 3);
  };
  // As dark as the bar says.
  const auto bar = [&](const std::string& words) {
    for (const auto& [part, shown] : plot.bar->ticks)
      if (shown == words)
        return colour(plot.bar->strip, 0, static_cast<int>(std::lround(255 * (1 - part))));
    ADD_FAILURE() << words;
    return std::vector<int>{};
  };
  EXPECT_EQ(colour(plot.map->image, 3, 0), bar("100"));
  EXPECT_EQ(colour(plot.map->image, 0, 0), bar("0"));
  for (int part = 0; part < 3; ++part)
    EXPECT_NEAR(colour(plot.map->image, 1, 1)[static_cast<std::size_t>(part)],
                bar("50")[static_cast<std::size_t>(part)], 1);
  const std::string text = svg(plot);
  for (const char* words : {"100", "50", "10", "1", "0", "title", "along", "20", "up", "share, %"})
    EXPECT_FALSE(labels(text, words).empty()) << words;
}

// Arrows go from rim to rim, those there and back on two sides; a loop stays outside of the ring.
TEST(StateGraph, ArrowsGoFromRimToRim) {
  const StateGraph graph{
      "t", {"A", "B", "C"}, {{0, 1, "ab"}, {1, 0, "ba"}, {2, 2, "cc"}, {1, 2, "bc"}}};
  const std::string text = svg(drawing_of(graph)), number = "([0-9.-]+)", other = "[0-9.-]+";
  const auto states = places(text, "<circle cx=\"" + number + "\" cy=\"" + number + "\"");
  ASSERT_EQ(states.size(), 3U);
  const double radius = std::stod(text.substr(text.find(" r=\"") + 4));
  const Vec2 centre = (states[0] + states[1] + states[2]) / 3;
  for (const Vec2& state : states)
    EXPECT_NEAR((state - centre).norm(), (states[0] - centre).norm(), 0.03);
  EXPECT_LT(states[0].y(), states[1].y()) << "the first is on top";
  const std::string way = "<path d=\"M" + number + " " + number;
  const auto starts = places(text, way + "[QC]"), ends = places(text, way + "L[^QZ]*Z\""),
             bends = places(text, "Q" + number + " " + number);
  ASSERT_EQ(starts.size(), 4U);  // the loop is the third
  ASSERT_EQ(ends.size(), 4U);    // tips
  const std::size_t from[] = {0, 1, 1}, to[] = {1, 0, 2}, start[] = {0, 1, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = states[from[i]], b = states[to[i]];
    EXPECT_NEAR((starts[start[i]] - a).norm(), radius, 0.02);
    EXPECT_NEAR((ends[start[i]] - b).norm(), radius, 0.02);
    EXPECT_NEAR((bends[i] - a).norm(), (bends[i] - b).norm(), 0.03) << "as far from both";
    EXPECT_LT((bends[i] - 0.5 * (a + b)).norm(), 0.5 * (a - b).norm());
  }
  EXPECT_GT((bends[0] - bends[1]).norm(), 10) << "not the same way back";
  EXPECT_NEAR((0.5 * (bends[0] + bends[1]) - 0.5 * (states[0] + states[1])).norm(), 0, 0.03);
  EXPECT_NEAR((starts[2] - states[2]).norm(), radius, 0.02);
  const Vec2 name = label(text, "cc");
  EXPECT_GT((name - centre).norm(), (states[2] - centre).norm() + radius);
  for (const auto& [words, i] :
       std::map<std::string, std::size_t>{{"ab", 0}, {"ba", 1}, {"bc", 2}}) {
    const Vec2 side = bends[i] - 0.5 * (states[from[i]] + states[to[i]]);
    EXPECT_GT((label(text, words) - 0.5 * (states[from[i]] + states[to[i]])).dot(side), 0) << words;
  }
}

}  // namespace
}  // namespace flatray
