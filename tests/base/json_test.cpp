#include "base/json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "base/table.h"

namespace flatray {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(JsonValue, NumbersAreShortestAndReadBack) {
  const JsonValue value =
      Values{0.1, 1e300, 19.0 / 72.0, -3, std::uint64_t{18446744073709551615U}, true, JsonValue()};
  EXPECT_EQ(json_text(value), "[0.1,1e+300,0.2638888888888889,-3,18446744073709551615,true,null]");
  const auto back = parse_json(json_text(value));
  ASSERT_TRUE(back);
  EXPECT_EQ(json_text(*back), json_text(value));
}

TEST(JsonValue, MinusZeroIsReadBack) {
  const auto back = parse_json(json_text(JsonValue(-0.0)));
  ASSERT_TRUE(back && back->as_number());
  EXPECT_TRUE(std::signbit(*back->as_number()));
  EXPECT_EQ(back->as_whole(), 0U);
}

TEST(JsonValue, JsonNeverHoldsABareInfinity) {
  EXPECT_EQ(json_text(Values{kInf, -kInf, std::nan("")}), R"(["inf","-inf","nan"])");
  EXPECT_EQ(json_text(Values{kInf, 1.0}, {.null_for_infinity = true}), "[null,1]");
}

TEST(JsonValue, TextIsEscapedAndNeverInvalidUtf8) {
  EXPECT_EQ(json_text(JsonValue("a\"b\\\n\x01")), R"("a\"b\\\n\u0001")");
  EXPECT_EQ(json_text(JsonValue("\xff")), R"("\\xff")");
}

TEST(JsonValue, NothingIsNullAndFieldsAreFoundByTheirKind) {
  const JsonValue value = Fields{{"none", std::optional<double>()},
                                 {"some", std::optional<double>(0.5)},
                                 {"text", "word"},
                                 {"whole", 7}};
  EXPECT_EQ(json_text(value), R"({"none":null,"some":0.5,"text":"word","whole":7})");
  const auto read = parse_json(json_text(value));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->number_of("some"), 0.5);
  EXPECT_EQ(read->number_of("text"), std::nullopt);
  EXPECT_EQ(read->whole_of("whole"), 7U);
  EXPECT_EQ(read->whole_of("some"), std::nullopt);
  EXPECT_EQ(read->text_of("text"), "word");
  EXPECT_EQ(read->text_of("whole"), "");
}

TEST(Json, AWholeNumberIsOneHoweverItIsWritten) {
  EXPECT_EQ(parse_json("1e6")->as_whole(), 1'000'000U);
  EXPECT_EQ(parse_json("7.0")->as_whole(), 7U);
  EXPECT_EQ(parse_json("9007199254740992.0")->as_whole(), std::uint64_t{1} << 53);
  for (const char* none : {"-1e6", "1e-6", "1e16", "1e300", "\"1e6\""})
    EXPECT_EQ(parse_json(none)->as_whole(), std::nullopt) << none;
}

// Brackets in texts and those that are closed do not count.
TEST(Json, TheFirstBracketThatIsNestedTooDeepIsNamed) {
  const std::string before = R"({"[[\"[": [[], {"a": "}]"}], "b": )";
  const std::string deepest = before + std::string(63, '[');
  EXPECT_EQ(read_json(deepest + std::string(7, '[')).error().byte, deepest.size() + 1);
  EXPECT_TRUE(read_json(deepest + std::string(63, ']') + "}"));
}

// As the library that reads it writes it, too.
TEST(JsonValue, ManyLinesAreIndentedByLevel) {
  Table table({"name", "t"});
  table.add({"a", 0.5});
  table.add({"b", JsonValue()});
  const JsonValue value = Fields{
      {"empty", Values()}, {"none", Fields()}, {"list", Values{1, Values{2}}}, {"rows", table}};
  for (const int indent : {1, 2})
    EXPECT_EQ(json_text(value, {.indent = indent}),
              nlohmann::ordered_json::parse(json_text(value)).dump(indent));
}

}  // namespace
}  // namespace flatray
