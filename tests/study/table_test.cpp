#include "study/table.h"

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
  EXPECT_EQ(sample().csv(),
            "name,count,measure\n"
            "plain,18446744073709551615,0.1\n"
            "\"a,b \"\"c\"\"\\n\",7,-0.3333333333333333\n");
}

TEST(Table, JsonKeepsOrderAndValues) {
  const Table table = sample();
  const std::string text = json_document({{"seed", std::uint64_t{3}}}, {{"rows", &table}});
  EXPECT_LT(text.find("seed"), text.find("rows"));
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["rows"][0]["count"], 18446744073709551615U);
  EXPECT_EQ(json["rows"][1]["name"], "a,b \"c\"\n");
  EXPECT_EQ(json["rows"][1]["measure"], -1.0 / 3);
}

TEST(Table, JsonHasNullForInfinityAndSurvivesInvalidText) {
  Table table({"name", "measure"});
  table.add({"\xff", std::numeric_limits<double>::infinity()});
  const auto json = nlohmann::json::parse(json_document({}, {{"rows", &table}}));
  EXPECT_TRUE(json["rows"][0]["measure"].is_null());
}

TEST(Table, TextAlignsNumbersToTheRight) {
  Table table({"state", "steps"});
  table.add({"STANDING", 5.6084656084656084});
  table.add({"é", 12.0});
  EXPECT_EQ(table.text(),
            "state       steps\n"
            "STANDING  5.60847\n"
            "é              12\n");
}

}  // namespace
}  // namespace flatray
