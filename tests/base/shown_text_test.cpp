#include "base/shown_text.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

TEST(ShownText, WhatSteersATerminalIsEscaped) {
  EXPECT_EQ(shown_text("plain \xc3\xbcml\xc3\xa4ut \xe2\x82\xac \xf0\x9f\x99\x82"),
            "plain \xc3\xbcml\xc3\xa4ut \xe2\x82\xac \xf0\x9f\x99\x82");
  EXPECT_EQ(shown_text(std::string_view("\x1b[2J\0\a\x7f", 7)), R"(\u001b[2J\u0000\u0007\u007f)");
  EXPECT_EQ(shown_text("a\r\nb\tc"), R"(a\r\nb\tc)");
  EXPECT_EQ(shown_text("\xc2\x85\xe2\x80\xa8\xe2\x80\xae\xe2\x81\xa6"),
            R"(\u0085\u2028\u202e\u2066)");
  EXPECT_EQ(shown_text("\xe9t\xe9"), R"(\xe9t\xe9)");
}

TEST(ShownText, OfManyLinesOnlyTheEndsStay) {
  EXPECT_EQ(shown_lines("one\ntwo\r\n\x1b\n"), "one\ntwo\\r\n\\u001b\n");
}

TEST(ShownText, StrayBytesAreShownAndNothingElse) {
  EXPECT_EQ(with_stray_bytes_shown("\n\xc3\xbc\xff\\\xc3"), "\n\xc3\xbc\\xff\\\\xc3");
  EXPECT_EQ(with_stray_bytes_shown(""), "");
}

TEST(ShownText, OfALongMessageTheBeginningIsKept) {
  const std::string most(4000, 'a');
  EXPECT_EQ(shortened(most), most);
  EXPECT_EQ(shortened(most + "b"), most + "...");
  for (std::size_t ahead = 0; ahead <= 4; ++ahead) {  // no character is cut
    std::string text(4000 - ahead, 'a');
    const std::string kept = text;
    text += "\xf0\x9f\x99\x82";
    EXPECT_EQ(shortened(text + "b"), (ahead == 4 ? text : kept) + "...");
  }
}

TEST(ShellWord, QuotesStandWhereAShellWouldReadMore) {
  for (const char* plain : {"scenes/demo.toml", "-f", "a,b:c+d@e%f", "\xc3\xbcml.toml"})
    EXPECT_EQ(shell_word(plain), plain);
  EXPECT_EQ(shell_word("a b;rm $(x) `y`"), "'a b;rm $(x) `y`'");
  EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
  for (const char* odd : {"", "~", "#", "a*", "a?", "[a]", "{a}", "a=b", "a\\b", "a\"b", "!a", "a&",
                          "<a>", "(a)", "a|b", "^a"})
    EXPECT_EQ(shell_word(odd), std::string("'") + odd + "'");
  // What a message would not show as it is.
  EXPECT_EQ(shell_word("a\nb"), "$'a\\012b'");
  EXPECT_EQ(shell_word("it's \\\x1b\xff"), "$'it\\'s \\\\\\033\\377'");
  EXPECT_EQ(shell_word("\xe2\x80\xae"), "$'\\342\\200\\256'");
}

TEST(ShownText, WidthCountsCharacters) { EXPECT_EQ(shown_width("n\xc3\xa9\xe2\x82\xac"), 3U); }

TEST(CsvField, QuotesWhatSeparates) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"a\""), "\"say \"\"a\"\"\"");
  EXPECT_EQ(csv_field("a\nb"), R"(a\nb)");  // a row stays a line
}

TEST(CsvField, NoNameIsAFormula) {
  EXPECT_EQ(csv_field("=cmd|' /C calc'!A0"), "'=cmd|' /C calc'!A0");
  EXPECT_EQ(csv_field("=1"), "'=1");
  EXPECT_EQ(csv_field("@SUM(1,2)"), "\"'@SUM(1,2)\"");
  EXPECT_EQ(csv_field("-1+cmd"), "'-1+cmd");
  EXPECT_EQ(csv_field("+A1"), "'+A1");
  EXPECT_EQ(csv_field("\t=1"), R"(\t=1)");
}

TEST(CsvField, NumbersAndFractionsStay) {
  for (const char* number : {"-57", "-57/216", "+0.5", "-1e-300", "-inf", "inf", "-", ""})
    EXPECT_EQ(csv_field(number), number);
}

}  // namespace
}  // namespace flatray
