#include "study/plots/state_graph.h"

#include <gtest/gtest.h>

#include "study/drawn_marks.h"
#include "study/texts.h"

namespace flatray {
namespace {

using namespace flatray::testing;

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++found;
  return found;
}

TEST(StateGraph, HasACircleForEachStateAndAnArrowForEachTransition) {
  const StateGraph graph = {"chain", {"A", "B", "C"}, {{0, 1, "0.5"}, {1, 0, "1/3"}, {2, 2, "1"}}};
  const std::string picture = svg(drawing_of(graph));
  EXPECT_TRUE(is_well_formed(picture));
  EXPECT_EQ(times(picture, "<circle"), 3U);
  EXPECT_EQ(times(picture, "Z\" class=\"f-axis\""), 3U) << "a tip for each arrow";
  for (const char* shown : {">A<", ">B<", ">C<", ">0.5<", ">1/3<", ">1<", ">chain<"})
    EXPECT_EQ(times(picture, shown), std::string(shown) == ">chain<" ? 2U : 1U) << shown;
}

// Of a triangle of states, which stand round no middle of what is drawn.
TEST(StateGraph, HasNoEmptyRoomAroundIt) {
  const Drawing drawing = drawing_of(StateGraph{"t", {"A", "B", "C"}, {{0, 1, "1"}, {1, 2, "1"}}});
  double left = 1e9, right = 0, low = 0;
  for (const auto& disc : marks_of<Drawing::Disc>(drawing)) {
    left = std::min(left, disc.centre.x() - disc.radius);
    right = std::max(right, disc.centre.x() + disc.radius);
    low = std::max(low, disc.centre.y() + disc.radius);
  }
  EXPECT_GT(left, 0);
  EXPECT_LT(left, 20);
  EXPECT_GT(drawing.size.x() - right, 0);
  EXPECT_LT(drawing.size.x() - right, 40) << "beside it stands a label";
  EXPECT_GT(drawing.size.y() - low, 0);
  EXPECT_LT(drawing.size.y() - low, 40);
}

TEST(StateGraph, TextFromAScenesAuthorCannotBreakOutOfIt) {
  const std::string evil = "</text><script>&\"'\x1b\n";
  const std::string picture = svg(drawing_of(StateGraph{evil, {evil}, {{0, 0, evil}}}));
  EXPECT_TRUE(is_well_formed(picture));
  EXPECT_FALSE(has(picture, "<script"));
  EXPECT_FALSE(has(picture, "\x1b"));
}

TEST(StateGraph, EmptyAndLargeGraphsAreDrawn) {
  EXPECT_TRUE(is_well_formed(svg(drawing_of(StateGraph{"", {}, {}}))));
  StateGraph large{"large", {}, {}};
  for (std::size_t i = 0; i < 64; ++i) {
    large.states.push_back("S" + std::to_string(i));
    large.arrows.push_back({i, (i * 7 + 1) % 64, "1"});
  }
  const std::string picture = svg(drawing_of(large));
  EXPECT_TRUE(is_well_formed(picture));
  for (const char* bad : {"\"nan", " nan", "\"inf", " inf", "-0.00"})
    EXPECT_FALSE(has(picture, bad)) << bad;
}

}  // namespace
}  // namespace flatray
