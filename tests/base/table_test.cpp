#include "base/table.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace flatray {
namespace {

Table sample() {
  Table table({"name", "count", "measure"});
  table.add({"plain", std::uint64_t{18446744073709551615U}, 0.1});
  table.add({"a,b \"c\"\n", std::uint64_t{7}, -1.0 / 3});
  return table;
}

TEST(Table, CsvQuotesAndKeepsEveryDigit) {
  EXPECT_EQ(csv_text(sample()),
            "name,count,measure\n"
            "plain,18446744073709551615,0.1\n"
            "\"a,b \"\"c\"\"\\n\",7,-0.3333333333333333\n");
  EXPECT_EQ(csv_text(Table({"a", "b"}, {{"x,y", 1.5}, {"say \"hi\"", JsonValue()}})),
            "a,b\n\"x,y\",1.5\n\"say \"\"hi\"\"\",\n");
}

TEST(Table, JsonKeepsOrderAndValues) {
  const std::string text = json_text(Fields{{"seed", std::uint64_t{3}}, {"rows", sample()}});
  EXPECT_LT(text.find("seed"), text.find("rows"));
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["rows"][0]["count"], 18446744073709551615U);
  EXPECT_EQ(json["rows"][1]["name"], "a,b \"c\"\n");
  EXPECT_EQ(json["rows"][1]["measure"], -1.0 / 3);
}

TEST(Table, JsonHasNullForInfinityAndSurvivesInvalidText) {
  Table table({"name", "measure"});
  table.add({"\xff", std::numeric_limits<double>::infinity()});
  const auto json = nlohmann::json::parse(json_text(table, {.null_for_infinity = true}));
  EXPECT_TRUE(json[0]["measure"].is_null());
}

TEST(Table, ColumnsLineUpAndNumbersStandRight) {
  EXPECT_EQ(aligned_text(Table({"name", "time"}, {{"a", 10}, {"long name", 5}}), {"  "}),
            "  name       time\n"
            "  a            10\n"
            "  long name     5\n");
}

TEST(Table, TextStandsLeftWhateverItsName) {
  EXPECT_EQ(aligned_text(Table({"a long name", "n"}, {{"x", "text"}, {"yy", "t"}})),
            "a long name  n\nx            text\nyy           t\n");
  EXPECT_EQ(aligned_text(Table({"number", "w"}, {{1.5, "t"}, {20, "u"}})),
            "number  w\n   1.5  t\n    20  u\n");
}

TEST(Table, BriefTextHasSixDigitsAndNoEmptyColumns) {
  Table table({"state", "remark", "steps"});
  table.add({"STANDING", "", 5.6084656084656084});
  table.add({"é", "", 12.0});
  EXPECT_EQ(aligned_text(table, {.brief = true}),
            "state       steps\n"
            "STANDING  5.60847\n"
            "é              12\n");
  EXPECT_EQ(aligned_text(Table({"a", "b"}), {.brief = true}), "a  b\n");
}

TEST(Table, WithoutNamesOrRowsItIsStillOne) {
  EXPECT_EQ(aligned_text(Table({}, {{"a", "b"}, {"long", ""}})), "a     b\nlong\n");
  EXPECT_EQ(aligned_text(Table({"a", "b"})), "a  b\n");
  EXPECT_EQ(aligned_text(Table()), "");
}

TEST(Table, RowsMadeWhenWrittenAreAsThoseKept) {
  Table made({"n", "square"}), kept = made;
  made.made = [](const Table::EachRow& each) {
    for (int i = 0; i < 12; ++i) each({i, i * i});
  };
  for (int i = 0; i < 12; ++i) kept.add({i, i * i});
  EXPECT_EQ(csv_text(made), csv_text(kept));
  EXPECT_EQ(aligned_text(made), aligned_text(kept));
  EXPECT_EQ(json_text(made), json_text(kept));
}

}  // namespace
}  // namespace flatray
