#include "base/source_text.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

void expect_position(const SourceText& source, std::size_t offset, int line, int column) {
  const SourceText::Position at = source.position(offset);
  EXPECT_EQ(at.line, line) << "offset " << offset;
  EXPECT_EQ(at.column, column) << "offset " << offset;
}

TEST(SourceText, LinesAndColumnsCountFromOne) {
  const SourceText source("a.toml", "ab\n\ncde");
  expect_position(source, 0, 1, 1);
  expect_position(source, 1, 1, 2);
  expect_position(source, 2, 1, 3);  // the line end belongs to its line
  expect_position(source, 3, 2, 1);
  expect_position(source, 4, 3, 1);
  expect_position(source, 6, 3, 3);
}

TEST(SourceText, AnOffsetPastTheEndIsTheEnd) {
  expect_position(SourceText("a", "ab\nc"), 400, 2, 2);
  expect_position(SourceText("a", "ab\n"), 400, 2, 1);
  expect_position(SourceText("a", ""), 7, 1, 1);
}

TEST(SourceText, LinesComeWithoutTheirLineEnds) {
  const SourceText source("a", "one\r\ntwo\n\r\nfour\r");
  EXPECT_EQ(source.line(1), "one");
  EXPECT_EQ(source.line(2), "two");
  EXPECT_EQ(source.line(3), "");
  EXPECT_EQ(source.line(4), "four");
}

TEST(SourceText, LinesThatAreNotThereAreEmpty) {
  const SourceText source("a", "one\n");
  EXPECT_EQ(source.line(2), "");
  EXPECT_EQ(source.line(3), "");
  EXPECT_EQ(source.line(0), "");
  EXPECT_EQ(source.line(-5), "");
}

TEST(SourceText, OffsetUndoesPosition) {
  const SourceText source("a", "ab\n\ncde\nf");
  for (std::size_t i = 0; i <= source.text().size(); ++i) {
    const SourceText::Position at = source.position(i);
    EXPECT_EQ(source.offset(at.line, at.column), i);
  }
}

TEST(SourceText, OffsetStaysInItsLine) {
  const SourceText source("a", "ab\r\ncde");
  EXPECT_EQ(source.offset(1, 99), 2U);  // before the CRLF
  EXPECT_EQ(source.offset(2, 99), 7U);
  EXPECT_EQ(source.offset(9, 2), 5U);
  EXPECT_EQ(source.offset(-1, -1), 0U);
}

TEST(Place, ANamedPlaceHasNoText) {
  const Place place = named_place("--size");
  EXPECT_TRUE(place);
  EXPECT_EQ(place.source->name(), "--size");
  EXPECT_TRUE(place.source->text().empty());
  EXPECT_FALSE(Place{});
}

}  // namespace
}  // namespace flatray
