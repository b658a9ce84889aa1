#include "scene/reading/takes.h"

#include <gtest/gtest.h>

#include "scene/reading/vocabulary.h"

namespace flatray {
namespace {

using Kind = Takes::Kind;

Takes only(const char* text) {
  const auto takes = parse_takes(text);
  if (!takes || takes->size() != 1) {
    ADD_FAILURE() << text;
    return {};
  }
  return takes->front();
}

// What fails here is a key whose `takes` has no type: write it in the grammar of scene/reading/takes.h, or
// give the grammar its unit.
TEST(TakesGrammar, EveryKeyOfTheLanguageFollowsIt) {
  for (const TableInfo& table : vocabulary())
    for (const KeyInfo& key : table.keys)
      EXPECT_TRUE(parse_takes(key.takes)) << table.table << "." << key.name << ": " << key.takes;
}

TEST(TakesGrammar, AlternativesStandBetweenCommasAndOr) {
  const auto takes = parse_takes(R"("to-start", "to-self" or "scaled")");
  ASSERT_TRUE(takes);
  ASSERT_EQ(takes->size(), 3u);
  EXPECT_EQ((*takes)[1].text, "to-self");
  EXPECT_EQ((*takes)[2].kind, Kind::word);
}

TEST(TakesGrammar, QuotesHoldWordsColoursAndTexts) {
  EXPECT_EQ(only("\"area\"").kind, Kind::word);
  EXPECT_EQ(only("\"ENTITY\"").kind, Kind::text);
  EXPECT_EQ(only("\"outline.obj\"").kind, Kind::text);
  EXPECT_EQ(only("\"#rrggbb\"").kind, Kind::colour);
}

TEST(TakesGrammar, BareWordsAreUnitsOutsideOfListsAndNumbersInside) {
  EXPECT_EQ(only("degrees a second").kind, Kind::number);
  EXPECT_EQ(only("frames").kind, Kind::whole);
  EXPECT_EQ(only("true or false").kind, Kind::truth);
  EXPECT_EQ(only("1").kind, Kind::literal);
  EXPECT_FALSE(parse_takes("parsecs"));
  EXPECT_EQ(only("[x, y]").items[1][0].kind, Kind::number);
}

TEST(TakesGrammar, ListsSayTheirLength) {
  const Takes window = only("[[x0, y0], [x1, y1]]");
  EXPECT_EQ(window.items.size(), 2u);
  EXPECT_FALSE(window.more);
  const Takes points = only("[[x, y], ...]");
  EXPECT_EQ(points.items.size(), 1u);
  EXPECT_TRUE(points.more);
  EXPECT_EQ(points.items[0][0].items.size(), 2u);
}

TEST(TakesGrammar, ListsOfListsMayHoldAlternatives) {
  const Takes points = only("[[x, y] or a curve, ...]");
  ASSERT_EQ(points.items.size(), 1u);
  EXPECT_EQ(points.items[0].size(), 2u);
  EXPECT_EQ(points.items[0][1].text, "curve");
  const Takes keys = only(R"([[t, v or [x, y] or "#rrggbb"], ...])");
  EXPECT_EQ(keys.items[0][0].items[1].size(), 3u);
}

TEST(TakesGrammar, DoubleBracketsNameATableOrHoldLists) {
  EXPECT_EQ(only("[[edge_rays]]").kind, Kind::tables);
  EXPECT_EQ(only("[[edge_rays]]").text, "edge_rays");
  EXPECT_EQ(only("[markov.NAME]").kind, Kind::named);
}

TEST(TakesGrammar, BracesShowKeys) {
  const Takes look = only("{ STATE = { ... } or [{ ... }, ...] }");
  ASSERT_EQ(look.keys.size(), 1u);
  EXPECT_EQ(look.keys[0].first, "STATE");
  ASSERT_EQ(look.keys[0].second.size(), 2u);
  EXPECT_EQ(look.keys[0].second[1].kind, Kind::list);
  EXPECT_EQ(only(R"({ width = w, colour = "#rrggbb" })").keys.size(), 2u);
  EXPECT_TRUE(only("{ ... }").keys.empty());
}

TEST(TakesGrammar, WhatDoesNotCloseIsRefused) {
  for (const char* text : {"", "[x, y", "{ a = ", "\"area", "[...]", "number or", "[[x, y], ...",
                           "{ width = w, colour }", "number number"})
    EXPECT_FALSE(parse_takes(text)) << text;
}

}  // namespace
}  // namespace flatray
