// Where pictures of numbers have their marks: by their own axes, read back from the text.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>

#include "geom/vec.h"
#include "study/plots/svg_graph.h"
#include "study/plots/svg_heat.h"
#include "study/plots/svg_plot.h"

namespace flatray {
namespace {

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

TEST(SvgPlot, PointsLieAtTheirNumbersOnTheAxes) {
  Plot plot{"t", "x", "y", {{"s", {{0, -3}, {1, 0}, {2, 3}, {4, 7, 2}}, true}}};
  const std::string text = svg(plot);
  const auto points = places(text, "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"2.5\"");
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(points[2].x() - points[1].x(), points[1].x() - points[0].x(), 0.02);
  EXPECT_NEAR(points[3].x() - points[2].x(), 2 * (points[2].x() - points[1].x()), 0.02);
  EXPECT_NEAR(points[1].y() - points[2].y(), points[0].y() - points[1].y(), 0.02);
  EXPECT_GT(points[0].y(), points[1].y());  // y goes up
  EXPECT_GT(points[1].x(), points[0].x());
  for (const auto& [words, x] : std::map<std::string, double>{{"1", 1}, {"3", 3}})
    EXPECT_NEAR(label(text, words).x(), points[0].x() + x * (points[1].x() - points[0].x()), 0.02);
  for (const auto& [words, y] : std::map<std::string, double>{{"5", 5}})
    EXPECT_NEAR(label(text, words).y(), points[1].y() + y * (points[2].y() - points[1].y()) / 3,
                0.02);
  // The interval of the last, of 2 to either side.
  const auto bar = places(
      text,
      "<line x1=\"[0-9.]+\" y1=\"([0-9.]+)\" x2=\"[0-9.]+\" y2=\"([0-9.]+)\" stroke=\"#1f77b4\"");
  ASSERT_EQ(bar.size(), 1U);
  EXPECT_NEAR(std::fabs(bar[0].x() - bar[0].y()), 4 * (points[1].y() - points[2].y()) / 3, 0.03);
  EXPECT_NEAR(0.5 * (bar[0].x() + bar[0].y()), points[3].y(), 0.02);
  for (const Vec2& point : points) {  // in the frame
    EXPECT_GT(point.x(), 80);
    EXPECT_LT(point.x(), 620);
    EXPECT_GT(point.y(), 40);
    EXPECT_LT(point.y(), 364);
  }
}

TEST(SvgPlot, LogarithmsAreEvenlySpacedAndTheirTicksArePowersOfTen) {
  Plot plot{"t",  "x", "y", {{"s", {{1e-4, 1}, {1e-2, 100}, {1, 1e4}, {-1, 5}, {5, 0}}, true}},
            true, true};
  plot.notes.push_back({1e-2, 100, "here"});
  const std::string text = svg(plot);
  const auto points = places(text, "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"2.5\"");
  ASSERT_EQ(points.size(), 3U) << "what is not above 0 is left out";
  EXPECT_LT((points[2] - points[1] - (points[1] - points[0])).norm(), 0.03);
  const auto ring = places(text, "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"6\"");
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_LT((ring[0] - points[1]).norm(), 0.02);
  EXPECT_NEAR(label(text, "here").y(), ring[0].y(), 0.02);
  for (const auto& [words, share] :
       std::map<std::string, double>{{"1e-4", 0}, {"1e-3", 0.5}, {"1e-1", 1.5}})
    EXPECT_NEAR(label(text, words).x(), points[0].x() + share * (points[1].x() - points[0].x()),
                0.02)
        << words;
  for (const auto& [words, share] : std::map<std::string, double>{{"1e1", 0.5}, {"1e3", 1.5}})
    EXPECT_NEAR(label(text, words).y(), points[0].y() + share * (points[1].y() - points[0].y()),
                0.02)
        << words;
}

// The legend stands on the side where fewer points are.
TEST(SvgPlot, TheLegendGoesOutOfTheWay) {
  std::vector<Plot::Point> falls, rises;
  for (int i = 0; i <= 10; ++i)
    falls.push_back({1.0 * i, -1.0 * i}), rises.push_back({1.0 * i, 1.0 * i});
  const std::string down = svg(Plot{"t", "x", "y", {{"name", falls}}});
  const std::string up = svg(Plot{"t", "x", "y", {{"name", rises}}});
  EXPECT_GT(label(down, "name").x(), 350);
  EXPECT_LT(label(up, "name").x(), 350);
}

TEST(SvgHeat, CellsLieByTheirNumbers) {
  const HeatMap map{"title", "along", "up", {1, 2, 3, 4}, {10, 20}, {0, 0.5, 0, 0, 0, 0, 0, 1}};
  const std::string text = svg(map);
  const auto cells = places(text, "<rect x=\"([0-9.]+)\" y=\"([0-9.]+)\" width=\"105.00\"");
  ASSERT_EQ(cells.size(), 2U);
  for (const Vec2& corner : cells) EXPECT_EQ(std::fmod(corner.x() - 80, 105), 0);
  for (const auto& [words, cell] : {std::pair("2", 0U), std::pair("4", 1U)})
    EXPECT_NEAR(labels(text, words).front().x(), cells[cell].x() + 52.5, 0.02);
  for (const auto& [words, cell] : {std::pair("10", 0U), std::pair("20", 1U)})
    EXPECT_NEAR(labels(text, words).front().y(), cells[cell].y() + 105, 0.02);
  EXPECT_LT(cells[1].y(), cells[0].y());
  for (const char* words : {"100 %", "50 %", "10 %", "1 %", "0 %", "title", "along"})
    label(text, words);
  // As dark as the legend says.
  const auto colours = [&](const std::string& size) {
    std::vector<std::string> found;
    const std::regex expression("width=\"" + size + "\"[^>]*fill=\"(#[0-9a-f]+)\"");
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
      found.push_back((*at)[1]);
    return found;
  };
  const auto shown = colours("105.00"), legend = colours("16");
  ASSERT_EQ(legend.size(), 5U);
  EXPECT_EQ(shown, (std::vector<std::string>{legend[1], legend[0]}));
  EXPECT_EQ(legend[4], "#fff");
}

// Arrows go from rim to rim, those there and back on two sides; a loop stays outside of the ring.
TEST(SvgGraph, ArrowsGoFromRimToRim) {
  const StateGraph graph{
      "t", {"A", "B", "C"}, {{0, 1, "ab"}, {1, 0, "ba"}, {2, 2, "cc"}, {1, 2, "bc"}}};
  const std::string text = svg(graph), number = "([0-9.-]+)", other = "[0-9.-]+";
  const auto states = places(text, "<circle cx=\"" + number + "\" cy=\"" + number + "\"");
  ASSERT_EQ(states.size(), 3U);
  const double radius = std::stod(text.substr(text.find(" r=\"") + 4));
  const Vec2 centre = (states[0] + states[1] + states[2]) / 3;
  for (const Vec2& state : states)
    EXPECT_NEAR((state - centre).norm(), (states[0] - centre).norm(), 0.03);
  EXPECT_LT(states[0].y(), states[1].y()) << "the first is on top";
  const std::string way = "<path d=\"M" + number + " " + number;
  auto starts = places(text, way);
  starts.erase(starts.begin());  // the tip of every arrow
  const auto ends = places(text, "Q" + other + " " + other + " " + number + " " + number),
             bends = places(text, "Q" + number + " " + number);
  ASSERT_EQ(starts.size(), 4U);  // the loop is the third
  ASSERT_EQ(ends.size(), 3U);
  const std::size_t from[] = {0, 1, 1}, to[] = {1, 0, 2}, start[] = {0, 1, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = states[from[i]], b = states[to[i]];
    EXPECT_NEAR((starts[start[i]] - a).norm(), radius, 0.02);
    EXPECT_NEAR((ends[i] - b).norm(), radius, 0.02);
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
