#include "base/diagnostic.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace flatray {
namespace {

// The value `marked` of a one-line source.
Place place_of(const std::string& text, const std::string& marked) {
  const auto source = std::make_shared<const SourceText>("my/runner.toml", text);
  return {source, text.find(marked), marked.size()};
}

TEST(Diagnostic, ShowsPlaceLineMarkerAndHint) {
  const std::string lines(22, '\n');
  const std::string text = lines + "RUNNING  = { RUNNING = 0.60, JUMP = 0.30, DIE = 0.01 }\nnext";
  const Diagnostic sum{place_of(text, "RUNNING"), "transitions out of RUNNING sum to 0.91",
                       "they must sum to 1: add 0.09"};
  EXPECT_EQ(format(sum),
            "my/runner.toml:23:1: error: transitions out of RUNNING sum to 0.91\n"
            "    RUNNING  = { RUNNING = 0.60, JUMP = 0.30, DIE = 0.01 }\n"
            "    ^~~~~~~  they must sum to 1: add 0.09\n");
}

TEST(Diagnostic, WithoutAHintTheMarkerStandsAlone) {
  const Diagnostic typo{place_of("  velocty  = [12, 0]", "velocty"), "unknown key 'velocty'", ""};
  EXPECT_EQ(format(typo, "warning"),
            "my/runner.toml:1:3: warning: unknown key 'velocty'\n"
            "      velocty  = [12, 0]\n"
            "      ^~~~~~~\n");
}

TEST(Diagnostic, APlaceWithoutTextGivesItsName) {
  EXPECT_EQ(format(Diagnostic{named_place("--size"), "is negative", "say 640x360"}),
            "--size: error: is negative\n    say 640x360\n");
  EXPECT_EQ(format(Diagnostic{{}, "nowhere", ""}), "error: nowhere\n");
}

TEST(Diagnostic, SeveralFollowOneAnother) {
  const Diagnostics two = {{{}, "one", ""}, {{}, "two", ""}};
  EXPECT_EQ(format(two), "error: one\nerror: two\n");
}

TEST(Diagnostic, ControlCharactersNeverReachTheTerminal) {
  const std::string evil = "\x1b[31m\x07\xc2\x9b\x7f";
  const Diagnostic diagnostic{place_of("key\t= " + evil, "="), "unknown key '" + evil + "'",
                              "hint " + evil};
  const std::string shown = format(diagnostic);
  for (const char c : shown) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c != 0x7f)) << int{c};
  const std::string escaped = R"(\u001b[31m\u0007\u009b\u007f)";
  EXPECT_NE(shown.find("    key = " + escaped), std::string::npos) << shown;
  const std::string named = format(Diagnostic{named_place(evil), evil, evil});
  EXPECT_EQ(named, escaped + ": error: " + escaped + "\n    " + escaped + "\n");
}

TEST(Diagnostic, WhatIsNoUtf8NeverReachesTheTerminal) {
  for (const std::string bad :
       {"\xff", "\xc0\x80", "\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xc3"}) {
    std::string escaped;
    for (const char c : bad) escaped += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    EXPECT_EQ(format(Diagnostic{place_of("a = " + bad + "; VALUE", "VALUE"), "'" + bad + "'", bad}),
              "my/runner.toml:1:" + std::to_string(7 + bad.size()) + ": error: '" + escaped +
                  "'\n    a = " + escaped + "; VALUE\n" + std::string(10 + escaped.size(), ' ') +
                  "^~~~~  " + escaped + "\n");
  }
  EXPECT_EQ(format(Diagnostic{{}, "left\xe2\x80\xaeright\xe2\x81\xa9", ""}),
            "error: left\\u202eright\\u2069\n");
}

TEST(Diagnostic, ALineOfStrayBytesIsCutLikeAnyOther) {
  std::string text(5000, '\x80');
  text.append("VALUE").append(5000, '\x80');
  const std::string shown = format(Diagnostic{place_of(text, "VALUE"), "wrong", ""});
  EXPECT_LT(shown.size(), 700U);
  EXPECT_NE(shown.find("\\x80VALUE\\x80"), std::string::npos);
}

TEST(Diagnostic, TheMarkerStandsUnderItsValueInUtf8Too) {
  const Diagnostic diagnostic{place_of("né = 'über'", "'über'"), "wrong", ""};
  EXPECT_EQ(format(diagnostic),
            "my/runner.toml:1:7: error: wrong\n"  // columns count bytes
            "    né = 'über'\n"
            "         ^~~~~~\n");
}

TEST(Diagnostic, OfALongLineOnlyTheNeighbourhoodIsShown) {
  std::string text(5000, 'a');
  text.append("VALUE").append(5000, 'b');
  const std::string shown = format(Diagnostic{place_of(text, "VALUE"), "wrong", ""});
  EXPECT_LT(shown.size(), 300U);
  const std::size_t line = shown.find("\n    ") + 1, marker = shown.rfind("    ");
  EXPECT_EQ(shown.find("VALUE") - line, shown.find("^~~~~\n") - shown.rfind('\n', marker) - 1);
}

TEST(Diagnostic, ALongLineIsNeverCutInsideACharacter) {
  for (int lead = 0; lead < 4; ++lead) {
    std::string text(static_cast<std::size_t>(lead), ' ');
    for (int i = 0; i < 200; ++i) text += "é";
    const std::size_t value = text.size();
    for (int i = 0; i < 200; ++i) text += "é";
    const auto source = std::make_shared<const SourceText>("a", text);
    const std::string shown = format(Diagnostic{{source, value, 2}, "wrong", ""});
    const std::size_t begin = shown.find("    ") + 4, end = shown.find('\n', begin);
    EXPECT_EQ(shown.compare(begin, 2, "é"), 0);
    EXPECT_EQ((end - begin) % 2, 0U);
  }
}

TEST(Diagnostic, AValueThatGoesOnInTheNextLineIsMarkedToItsLineEnd) {
  const Diagnostic diagnostic{place_of("a = [1,\n2]", "[1,\n2]"), "wrong", ""};
  EXPECT_EQ(format(diagnostic), "my/runner.toml:1:5: error: wrong\n    a = [1,\n        ^~~\n");
}

TEST(Called, WhatHasNoNameIsKnownByItsLine) {
  const Place second = place_of("a = 1\nb = 2", "b");
  EXPECT_EQ(called("lamp", "left", second), "lamp 'left'");
  EXPECT_EQ(called("lamp", "", second), "lamp of line 2");
  EXPECT_EQ(called("entity", "", {}), "an unnamed entity");
}

TEST(NearestWord, FindsTypingMistakesAndNothingElse) {
  const std::vector<std::string> keys = {"velocity", "angle", "at", "name"};
  EXPECT_EQ(nearest_word("velocty", keys), "velocity");
  EXPECT_EQ(nearest_word("alnge", {"angel"}), "");  // two changes in five letters: not near
  EXPECT_EQ(nearest_word("anlge", keys), "angle");
  EXPECT_EQ(nearest_word("flim", {"rays", "film"}), "film");
  EXPECT_EQ(nearest_word("pwoer", {"power"}), "power");
  EXPECT_EQ(nearest_word("shpae", {"shape"}), "shape");
  EXPECT_EQ(nearest_word("D", {"A"}), "");
  EXPECT_EQ(nearest_word("nme", keys), "name");
  EXPECT_EQ(nearest_word("colour", keys), "");
  EXPECT_EQ(nearest_word("velocity", {}), "");
}

TEST(NearestWord, AHugeWordIsNotCompared) {
  EXPECT_EQ(nearest_word(std::string(1'000'000, 'a'), {"a"}), "");
}

}  // namespace
}  // namespace flatray
