// needs: shapes/text
#include <gtest/gtest.h>

#include "scene/outlines/outline.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

Bounds bounds_of(const Shape& shape) {
  Bounds bounds;
  for (const Vec2& vertex : shape.vertices) bounds.add(vertex);
  return bounds;
}

TEST(Text, ACapitalStandsOnItsBaselineAndIsAsHighAsTheSize) {
  const Bounds bounds = bounds_of(shape_of("text = { string = \"HE\", size = 14 }"));
  EXPECT_EQ(bounds.low, Vec2(0, 0));
  EXPECT_EQ(bounds.high.y(), 14);
  EXPECT_LT(bounds_of(shape_of("text = { string = \"g\", size = 14 }")).low.y(), 0);
}

TEST(Text, TheOutlineOfALetterHasNoLineInside) {
  const std::vector<OutlineEdge> edges = outline(shape_of("text = { string = \"I\", size = 7 }"));
  const Shape shape = shape_of("text = { string = \"-\", size = 7 }");  // a bar of n squares
  EXPECT_EQ(outline(shape).size(), 2 * shape.piece_count() + 2);
  EXPECT_FALSE(edges.empty());
}

TEST(Text, LinesAreAlignedAtTheOrigin) {
  const std::string two = "text = { string = \"H\\nHH\", size = 7, align = ";
  const Bounds left = bounds_of(shape_of(two + "\"left\" }"));
  const Bounds right = bounds_of(shape_of(two + "\"right\" }"));
  EXPECT_EQ(left.low.x(), 0);
  EXPECT_EQ(left.low.y(), -12);
  const Bounds centre = bounds_of(shape_of(two + "\"centre\" }"));
  EXPECT_EQ(right.high.x(), 0);
  EXPECT_EQ(centre.low.x(), -centre.high.x());
  EXPECT_EQ(left.size(), right.size());
}

TEST(Text, WhatTheFontLacksIsWarnedOfWithItsPlace) {
  const LoadedScene got = loaded(with_shape("text = { string = \"\u00e9t\u00e9\", size = 1 }"));
  ASSERT_EQ(got.warnings.size(), 1U);
  EXPECT_EQ(got.warnings[0].message, "the font lacks 2 characters");
}

TEST(Text, WhatShowsNothingIsRefused) {
  const Refused cases[] = {
      {"text = { string = \"\", size = 1 }", "the text shows nothing"},
      {"text = { string = \"  \", size = 1 }", "the text shows nothing"},
      {"text = { string = \"a\", size = 0 }", "text.size is 0"},
      {"text = { string = \"a\", size = 5e-324 }", "letters of this size are lost in rounding"},
      {"text = { string = \"a\" }", "text needs 'size'"},
  };
  expect_refused(cases, [](const std::string& shape) { return refusal(with_shape(shape)); });
}

}  // namespace
}  // namespace flatray
