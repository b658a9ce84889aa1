#include "app/report/value.h"

#include <gtest/gtest.h>

#include <limits>

namespace flatray {
namespace {

TEST(JsonValue, NumbersAreShortestAndReadBack) {
  const JsonValue value =
      Values{0.1, 1e300, 19.0 / 72.0, -3, std::uint64_t{18446744073709551615U}, true, JsonValue()};
  EXPECT_EQ(json_text(value), "[0.1,1e+300,0.2638888888888889,-3,18446744073709551615,true,null]");
  const auto back = parse_json(json_text(value));
  ASSERT_TRUE(back);
  EXPECT_EQ(json_text(*back), json_text(value));
}

TEST(JsonValue, JsonNeverHoldsABareInfinity) {
  EXPECT_EQ(json_text(JsonValue(std::numeric_limits<double>::infinity())), "\"inf\"");
}

TEST(JsonValue, TextIsEscapedAndNeverInvalidUtf8) {
  EXPECT_EQ(json_text(JsonValue("a\"b\\\n\x01")), R"("a\"b\\\n\u0001")");
  EXPECT_EQ(json_text(JsonValue("\xff")), "\"\xEF\xBF\xBD\"");
}

TEST(JsonValue, CsvQuotesWhatNeedsIt) {
  EXPECT_EQ(csv_text({{"a", "b"}, {{"x,y", 1.5}, {"say \"hi\"", JsonValue()}}}),
            "a,b\n\"x,y\",1.5\n\"say \"\"hi\"\"\",\n");
}

TEST(JsonValue, ColumnsLineUpAndNumbersStandRight) {
  EXPECT_EQ(aligned_text({{"name", "time"}, {{"a", 10}, {"long name", 5}}}, "  "),
            "  name       time\n"
            "  a            10\n"
            "  long name     5\n");
}

TEST(JsonValue, ATableWithoutNamesOrRowsIsStillOne) {
  EXPECT_EQ(aligned_text({{}, {{"a", "b"}, {"long", ""}}}), "a     b\nlong\n");
  EXPECT_EQ(aligned_text({{"a", "b"}, {}}), "a  b\n");
  EXPECT_EQ(aligned_text({}), "");
}

}  // namespace
}  // namespace flatray
