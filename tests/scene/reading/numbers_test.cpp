// needs: shapes/polygon shapes/segment
#include "scene/reading/numbers.h"

#include <gtest/gtest.h>

#include <locale>

#include "base/number_text.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

TEST(Numbers, DecimalsOfOneNumberAreEqualHoweverWritten) {
  const auto half = parse_decimal("0.5");
  for (const char* text : {"5e-1", "+0.50", "00.5", "0.005e2", "0.0_5E+1"})
    EXPECT_EQ(parse_decimal(text), half) << text;
  EXPECT_NE(parse_decimal("-0.5"), half);
  EXPECT_EQ(parse_decimal("-0.0"), parse_decimal("0"));
}

TEST(Numbers, DecimalsAreWhatTheySayExactly) {
  EXPECT_EQ(to_rational(*parse_decimal("0.1")) * Rational(10), Rational(1));
  EXPECT_EQ(to_rational(*parse_decimal("123456789012345678901234567890e-10")).text(),
            "12345678901234567890123456789/1000000000");
  EXPECT_EQ(to_rational(*parse_decimal("-25e2")), Rational(-2500));
  EXPECT_EQ(*parse_decimal("0x1_0"), *parse_decimal("1.6e1"));
}

TEST(Numbers, WhatIsNoDecimalIsRefused) {
  for (const char* text :
       {"", ".", "-", "e5", "1e", "1e+", "1e5.0", "0x", "0xg", "nan", "1 ", "1e999999"})
    EXPECT_FALSE(parse_decimal(text)) << text;
}

TEST(Numbers, DecimalTextIsTheDecimal) {
  for (const char* text : {"0.91", "0.09", "-0.5", "1", "0", "1.00000000000000000001", "120"})
    EXPECT_EQ(decimal_text(to_rational(*parse_decimal(text))), text);
  EXPECT_EQ(decimal_text(Rational(1) / Rational(3)), "0.3333333333333333");
}

TEST(Numbers, LiteralsRoundToTheNearestDouble) {
  EXPECT_EQ(parse_literal("0.1")->value, 0.1);
  EXPECT_EQ(parse_literal("9007199254740993")->value, 9007199254740992.0);
  EXPECT_EQ(parse_literal("9007199254740993.00001")->value, 9007199254740994.0);
  EXPECT_EQ(parse_literal("1_000.5e3")->value, 1000500.0);
  EXPECT_EQ(parse_literal("0x1F")->value, 31.0);
  EXPECT_EQ(parse_literal("5e-324")->value, 5e-324);
}

TEST(Numbers, LossesAreNoticed) {
  using Loss = Number::Loss;
  EXPECT_EQ(parse_literal("9007199254740993")->loss, Loss::integer);
  EXPECT_EQ(parse_literal("10000000000000001.0")->loss, Loss::integer);
  EXPECT_EQ(parse_literal("0x20000000000001")->loss, Loss::integer);
  EXPECT_EQ(parse_literal("9007199254740992")->loss, Loss::none);
  EXPECT_EQ(parse_literal("10000000000000000000000")->loss, Loss::none);  // 1e22 is a double
  EXPECT_EQ(parse_literal("1e23")->loss, Loss::none);                     // not written out
  EXPECT_EQ(parse_literal("1e-400")->loss, Loss::underflow);
  EXPECT_EQ(parse_literal("0.0e-400")->loss, Loss::none);
  EXPECT_EQ(parse_literal("0e200000")->loss, Loss::none);
  EXPECT_EQ(parse_literal("0.1")->loss, Loss::none);
}

// Found by a reviewer: those with an exponent or a fraction were rounded without a word.
TEST(Numbers, WholeOnesAreExactHoweverTheyAreWritten) {
  EXPECT_EQ(parse_integer("9007199254740993e0"), 9007199254740993);
  EXPECT_EQ(parse_integer("-90071992547409930e-1"), -9007199254740993);
  EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse_integer("0x7fff_ffff_ffff_ffff"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parse_integer("+5.0"), 5);
  EXPECT_EQ(parse_integer("1e18"), 1'000'000'000'000'000'000);
  EXPECT_EQ(parse_integer("0e5"), 0);
  for (const char* none : {"5.0000000000000000001", "9223372036854775808", "1e19", "0.5",
                           "0xffffffffffffffff", "nan", "1e-400", ""})
    EXPECT_FALSE(parse_integer(none)) << none;
}

struct E4 {
  const char *number, *expected;  // start of what the user reads
};

std::string fps_with(const std::string& number) { return "flatray = 1\nfps = " + number + "\n"; }

void expect_the_table() {
  const E4 cases[] = {
      {"nan", "t.toml:2:7: error: fps is not finite"},
      {"inf", "t.toml:2:7: error: fps is not finite"},
      {"-inf", "t.toml:2:7: error: fps is not finite"},
      {"1e400", "t.toml:2:7: error: 1e400 is beyond the doubles"},
      {"0x1p-1074", "t.toml:2:7: error: hexadecimal floating-point"},
      {"\"1,5\"", "t.toml:2:7: error: fps is a string, not a number"},
      {"\"+5\"", "t.toml:2:7: error: fps is a string, not a number"},
      {"1,5", "t.toml:2:7: error: key-value pair"},
      {".5", "t.toml:2:7: error: '.5' is not a number"},
      {"5.", "t.toml:2:7: error: '5.' is not a number"},
      {"1e", "t.toml:2:7: error: '1e' is not a number"},
      {"--5", "t.toml:2:7: error: '--5' is not a number"},
  };
  for (const auto& [number, expected] : cases) {
    const std::string shown = refusal(fps_with(number));
    EXPECT_EQ(shown.substr(0, std::string(expected).size()), expected);
  }
  for (const char* beyond : {"inf", "1e400"})
    EXPECT_NE(refusal(fps_with(beyond)).find("between -1e300 and 1e300"), std::string::npos);
  EXPECT_EQ(loaded(fps_with("+5")).scene.fps, 5.0);
  EXPECT_EQ(loaded(fps_with("1.5")).scene.fps, 1.5);
}

TEST(StiffCases, E4NumbersAreFiniteOrLocatedErrors) { expect_the_table(); }

TEST(StiffCases, E4AMillionDigitsAreALocatedError) {
  for (const char* start : {"1", "0."}) {
    const std::string shown = refusal(fps_with(start + std::string(1000000, '1')));
    EXPECT_EQ(shown.substr(0, 18), "t.toml:2:7: error:") << shown.substr(0, 200);
    EXPECT_LT(shown.size(), 500u);
  }
}

TEST(StiffCases, E4UnderflowReadsAsZeroWithAWarning) {
  const LoadedScene got = loaded("flatray = 1\ncamera = { at = [1e-400, 2] }\n");
  EXPECT_EQ(got.scene.camera.at->value, Vec2(0, 2));
  EXPECT_EQ(format(got.warnings, "warning").substr(0, 43),
            "t.toml:2:18: warning: 1e-400 reads as 0\n   ");
}

// A decimal comma wherever a stream or locale function would ask.
struct CommaPoint : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(StiffCases, E4TheLocaleChangesNothing) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
  const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");
  expect_the_table();
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  RecordProperty("de_DE", german != nullptr ? "set" : "not installed, facet only");
}

}  // namespace
}  // namespace flatray
