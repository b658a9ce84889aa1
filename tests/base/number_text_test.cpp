#include "base/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <limits>
#include <locale>

#include "base/philox.h"

namespace flatray {
namespace {

constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
constexpr double kLargest = std::numeric_limits<double>::max();

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(100), "100");
  EXPECT_EQ(number_text(kSmallest), "5e-324");
}

TEST(NumberText, EveryDoubleComesBack) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random_bits(1, Stream::test, 0, i));
    if (!std::isfinite(value)) continue;
    const std::optional<double> back = parse_number(number_text(value));
    ASSERT_TRUE(back.has_value()) << value;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(ParseNumber, ReadsWhatTomlAndObjWrite) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("+0.1"), 0.1);
  EXPECT_EQ(parse_number("-12e3"), -12000.0);
  EXPECT_EQ(parse_number("1E+2"), 100.0);
  EXPECT_TRUE(std::signbit(*parse_number("-0")));
}

// The decimals halfway between two doubles, and their neighbours.
TEST(ParseNumber, RoundsCorrectly) {
  EXPECT_EQ(parse_number("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(parse_number("9007199254740993.0000000000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(parse_number("9007199254740995"), 9007199254740996.0);
  EXPECT_EQ(parse_number("1.7976931348623157e308"), kLargest);
  EXPECT_EQ(parse_number("1.7976931348623158e308"), kLargest);
  EXPECT_EQ(parse_number("2.2250738585072011e-308"), 0x0.fffffffffffffp-1022);
}

TEST(StiffCases, E4NumbersAreFiniteOrRefused) {
  for (const char* refused : {"nan",       "NaN",   "inf",
                              "-inf",      "+inf",  "infinity",
                              "nan(1)",    "1e400", "-1e400",
                              "0x1p-1074", "0x10",  "1,5",
                              "1e",        "1e+",   "--5",
                              "+-5",       "++5",   "-+5",
                              "+",         "-",     ".",
                              "",          " 5",    "5 ",
                              "1_000",     "5f",    "1.7976931348623159e308"})
    EXPECT_EQ(parse_number(refused), std::nullopt) << "'" << refused << "'";
  EXPECT_EQ(parse_number(std::string_view("5\0", 2)), std::nullopt);
  EXPECT_EQ(parse_number("+5"), 5.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
}

TEST(StiffCases, E4UnderflowIsTheNearestDouble) {
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(*parse_number("-1e-400")));
  EXPECT_EQ(parse_number("1e-99999999999999999999"), 0.0);
  EXPECT_EQ(parse_number("2e-324"), 0.0);
  EXPECT_EQ(parse_number("3e-324"), kSmallest);
}

// Mantissa and exponent may each be out of range alone.
TEST(StiffCases, E4RangeIsJudgedByTheWholeNumber) {
  const std::string zeros(800, '0');
  EXPECT_EQ(parse_number("1" + zeros + "e-400"), std::nullopt);  // 1e400
  EXPECT_EQ(parse_number("0." + zeros + "1e+400"), 0.0);         // 1e-401
  EXPECT_EQ(parse_number("0." + zeros + "1e+801"), 1.0);
  EXPECT_EQ(parse_number("1" + zeros + "e-800"), 1.0);
  EXPECT_EQ(parse_number("0." + zeros + "1e+1200"), std::nullopt);  // 1e399
  EXPECT_EQ(parse_number("0." + zeros), 0.0);
  EXPECT_EQ(parse_number("1e99999999999999999999"), std::nullopt);
  EXPECT_EQ(parse_number("0e99999999999999999999"), 0.0);
}

TEST(StiffCases, E4AMillionDigitsAreReadCorrectly) {
  const std::string digits(1'000'000, '1');
  EXPECT_EQ(parse_number("0." + digits), 1.0 / 9.0);
  EXPECT_EQ(parse_number(digits), std::nullopt);
  // Halfway but for the last digit.
  std::string above = "9007199254740993." + std::string(1'000'000, '0');
  EXPECT_EQ(parse_number(above), 9007199254740992.0);
  above.back() = '1';
  EXPECT_EQ(parse_number(above), 9007199254740994.0);
}

void expect_points_as_decimal_separator() {
  EXPECT_EQ(number_text(1234567.5), "1234567.5");
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("1,5"), std::nullopt);
}

struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(StiffCases, E4NumbersDoNotDependOnTheLocaleOfTheProgram) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaNumbers));
  expect_points_as_decimal_separator();
  std::locale::global(before);
}

TEST(StiffCases, E4NumbersDoNotDependOnTheLocaleOfTheSystem) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed";
  expect_points_as_decimal_separator();
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace flatray
