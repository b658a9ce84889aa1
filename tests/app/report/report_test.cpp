#include "app/report/report.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace flatray {
namespace {

Arguments asked(std::string option) {
  return {{{std::move(option), {"--it", {}}}}, {"scene.toml"}};
}

std::string written(const std::string& option, VerbOutput output) {
  return written("test", asked(option), output);
}

JsonValue json_written(VerbOutput output) {
  const auto json = parse_json(written("json", std::move(output)));
  return json ? *json : JsonValue("no JSON");
}

Table two_rows() { return Table({"name", "t"}, {{"a", 0.5}, {"b", JsonValue()}}); }

TEST(Report, ATableAloneIsTheAnswerInEveryForm) {
  EXPECT_EQ(written("quiet", {.table = two_rows()}), "name    t\na     0.5\nb\n");
  EXPECT_EQ(written("csv", {.table = two_rows()}), "name,t\na,0.5\nb,\n");
  const JsonValue json = json_written({.table = two_rows()});
  EXPECT_EQ(json_text(*json.find("results")), R"([{"name":"a","t":0.5},{"name":"b","t":null}])");
}

TEST(Report, TextIsOfPartsAndResultsAreTheirOwn) {
  const VerbOutput output{.text = {"before\n", two_rows(), "after\n"},
                          .results = Fields{{"rows", two_rows()}},
                          .of_all = {{"more", 1}}};
  EXPECT_EQ(written("quiet", output), "before\nname    t\na     0.5\nb\nafter\n");
  const JsonValue json = json_written(output);
  EXPECT_EQ(json_text(*json.find("results")),
            R"({"rows":[{"name":"a","t":0.5},{"name":"b","t":null}]})");
  EXPECT_EQ(json.text_of("schema"), "flatray.test/1");
  EXPECT_EQ(json_text(*json.find("args")),
            R"({"operands":["scene.toml"],"options":{"json":true}})");
  EXPECT_EQ(json.whole_of("more"), 1U);
}

TEST(Report, ResultsAddedOneByOneAreAListWithTheirTextsInOrder) {
  VerbOutput output{.table = two_rows()};
  output.add(Fields{{"n", 1}}, "one\n");
  output.add(2, "two\n");
  EXPECT_EQ(written("quiet", output), "one\ntwo\n");
  EXPECT_EQ(written("csv", output), "name,t\na,0.5\nb,\n");
  EXPECT_EQ(json_text(*json_written(output).find("results")), R"([{"n":1},2])");
}

TEST(Report, WithoutResultsThereIsNoJson) { EXPECT_EQ(written("json", {.exit_code = 130}), ""); }

// A copy of the arguments is what the verb warns with.
TEST(Report, WarningsAreInTheObjectEvenWhereTheyAreNotPrinted) {
  const Arguments given({{"json", {"--json", {}}}, {"quiet", {"-q", {}}}}, {"scene.toml"});
  const Arguments of_verb = given;
  report_warnings({{named_place("scene.toml"), "two lie in each other", "move one"}}, of_verb);
  VerbOutput output{.results = Values{}};
  const auto json = parse_json(flatray::written("test", given, output));
  ASSERT_TRUE(json);
  EXPECT_EQ(json_text(*json->find("warnings")),
            R"([{"file":"scene.toml","message":"two lie in each other","hint":"move one"}])");
  EXPECT_EQ(json_text(*json_written({.results = Values{}}).find("warnings")), "[]");
}

// Rows that are made when they are written take their time, too.
TEST(Report, SecondsAreThoseUntilItIsWritten) {
  Table slow({"n"});
  slow.made = [](const Table::EachRow& each) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    each({1});
  };
  const JsonValue json = json_written({.table = std::move(slow)});
  EXPECT_GE(json.find("timing")->number_of("seconds").value_or(0), 0.03);
}

TEST(Report, WhatIsWrongIsToldAsErrors) {
  const Diagnostics problems{{named_place("scene.toml"), "is odd", "mend it"}};
  const JsonValue ended = json_written({.table = two_rows(), .problems = problems});
  const std::string errors = R"([{"file":"scene.toml","message":"is odd","hint":"mend it"}])";
  EXPECT_EQ(json_text(*ended.find("errors")), errors);
  const JsonValue failed = json_written({.results = failed_results(problems)});
  EXPECT_EQ(json_text(*failed.find("results")->find("errors")), errors);
  EXPECT_EQ(written("csv", {.results = failed_results(problems)}), "");
}

}  // namespace
}  // namespace flatray
