#include "app/options/option_table.h"

#include <gtest/gtest.h>

#include "app/verb.h"

namespace flatray {
namespace {

enum class Corner { stop, back };
constexpr Word<Corner> kCorners[] = {{"stop", Corner::stop}, {"back", Corner::back}};

Result<double> half(const std::string& text, const Place& where) {
  if (text == "1/2") return 0.5;
  return usage_error(where, "is not a half");
}

struct Options : Arguments {
  unsigned jobs = 3;
  std::optional<std::uint64_t> bounces;
  Corner corner = Corner::stop;
  double part = 0.25;
  std::vector<double> parts;
  std::string name;
  bool quiet = false;

  void rows(OptionTable& row) {
    row("-j, --jobs N", "threads", jobs, 1, 99);
    row("--bounces N", "most bounces", bounces, 0, std::uint64_t{1} << 40);
    row("--corner", "in a corner", corner, kCorners);
    row("--part P", "of all", part, &half);
    row.each("--parts P", "of each", parts, &half);
    row("--name NAME", "of it", name);
    row("-q, --quiet", "no summary", quiet);
    row.excludes("name", {"bounces"});
    if (quiet && corner == Corner::back) row.problem("corner", "is told, not quiet", "say so");
  }
};

using Given = std::map<std::string, std::string>;

// What is read of options given; problems as text.
std::pair<Options, std::string> read(const Given& given) {
  Arguments arguments;
  for (const auto& [name, value] : given) arguments.add_nearer(name, {"--" + name, {value}});
  Diagnostics problems;
  const auto options = read_options<Options>(arguments, problems);
  for (const Diagnostic& one : problems) EXPECT_EQ(one.trouble, Trouble::usage);
  return {*options, format(problems)};
}

TEST(OptionTable, AMemberBeforeItIsReadIsTheDefault) {
  const auto [options, problems] = read({});
  EXPECT_EQ(problems, "");
  EXPECT_EQ(options.jobs, 3U);
  EXPECT_FALSE(options.bounces);
  EXPECT_EQ(options.corner, Corner::stop);
  EXPECT_EQ(options.part, 0.25);
  EXPECT_FALSE(options.quiet);
}

TEST(OptionTable, EachRowReadsItsMember) {
  const auto [options, problems] = read(
      {{"jobs", "99"}, {"bounces", "0"}, {"corner", "back"}, {"part", "1/2"}, {"parts", "1/2"}});
  EXPECT_EQ(problems, "");
  EXPECT_EQ(options.jobs, 99U);
  EXPECT_EQ(options.bounces, 0U);
  EXPECT_EQ(options.corner, Corner::back);
  EXPECT_EQ(options.part, 0.5);
  EXPECT_EQ(options.parts, std::vector{0.5});
}

TEST(OptionTable, NumbersAreDigitsInRange) {
  for (const char* bad : {"", "0", "-1", "1.5", "1e3", "99999999999999999999", " 1", "100"})
    EXPECT_NE(read({{"jobs", bad}}).second.find("say a number from 1 to 99"), std::string::npos)
        << bad;
  EXPECT_EQ(read({{"jobs", "100"}}).second,
            "--jobs: error: 100 is out of range\n    say a number from 1 to 99\n");
  EXPECT_EQ(read({{"jobs", "x"}}).second,
            "--jobs: error: 'x' is not a whole number\n    say a number from 1 to 99\n");
}

TEST(OptionTable, AMistakeInTheEnvironmentNamesTheVariable) {
  Arguments arguments;
  arguments.add_nearer("jobs", {"FLATRAY_JOBS", {"0"}});
  Diagnostics problems;
  read_options<Options>(arguments, problems);
  EXPECT_EQ(format(problems),
            "FLATRAY_JOBS: error: 0 is out of range\n    say a number from 1 to 99\n");
}

TEST(OptionTable, AllMistakesAreReportedTogether) {
  const std::string all = read({{"jobs", "0"},
                                {"corner", "bak"},
                                {"part", "1/3"},
                                {"parts", "1/4"},
                                {"name", "x"},
                                {"bounces", "-1"}})
                              .second;
  for (const char* one :
       {"--jobs: error: 0 is out of range", "--bounces: error: '-1' is not a whole number",
        "--corner: error: unknown value 'bak' (did you mean 'back'?)\n    say stop, back",
        "--part: error: is not a half", "--parts: error: is not a half",
        "--bounces: error: does not go with --name\n    leave one of them out"})
    EXPECT_NE(all.find(one), std::string::npos) << one << " is not in\n" << all;
}

TEST(OptionTable, WhatSeveralOptionsSayTogetherIsJudgedOnceTheyAreRead) {
  EXPECT_EQ(read({{"corner", "back"}, {"quiet", ""}}).second,
            "--corner: error: is told, not quiet\n    say so\n");
}

TEST(OptionTable, RowsTellSpellingRangeWordsAndDefault) {
  OptionTable table;
  Options().rows(table);
  const std::vector<Option>& rows = table.options();
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[0].name, "jobs");
  EXPECT_EQ(rows[0].letter, 'j');
  EXPECT_EQ(rows[0].metavar, "N");
  EXPECT_EQ(rows[0].help, "threads (1 to 99, default 3)");
  EXPECT_EQ(rows[1].letter, '\0');
  EXPECT_EQ(rows[1].help, "most bounces (0 to 2^40)");
  EXPECT_EQ(rows[2].metavar, "stop|back");
  EXPECT_EQ(rows[2].help, "in a corner (default stop)");
  EXPECT_EQ(rows[3].help, "of all (default 0.25)");
  EXPECT_EQ(rows[4].kind, OptionKind::list);
  EXPECT_EQ(rows[5].help, "of it");
  EXPECT_EQ(rows[6].kind, OptionKind::flag);
}

TEST(OptionTable, LargeNumbersAreShownAsPowersOfTwo) {
  const std::uint64_t all = ~std::uint64_t{0};
  EXPECT_EQ(range_text(0, all, "1"), " (default 1)");
  EXPECT_EQ(range_text(0, all >> 1, ""), " (0 to 2^63-1)");
  EXPECT_EQ(range_text(128, 1U << 24, "65536"), " (128 to 2^24, default 65536)");
  EXPECT_EQ(range_text(1, 1024, ""), " (1 to 1024)");
}

TEST(OptionTable, TheUsageLineOfAVerbSaysHowManyOperandsItTakes) {
  const auto takes = [](const char* operands, std::size_t hidden = 0) {
    Verb verb{};
    verb.operands = operands, verb.hidden_operands = hidden;
    return std::pair(verb.least_operands(), verb.most_operands());
  };
  EXPECT_EQ(takes(""), std::pair(0UL, 0UL));
  EXPECT_EQ(takes("SCENE"), std::pair(1UL, 1UL));
  EXPECT_EQ(takes("[FILE|-]"), std::pair(0UL, 1UL));
  EXPECT_EQ(takes("NAME SCENE"), std::pair(2UL, 2UL));
  EXPECT_EQ(takes("FOLDER..."), std::pair(1UL, 10'000UL));
  EXPECT_EQ(takes("check|update [SCENE...]"), std::pair(1UL, 10'000UL));
  EXPECT_EQ(takes("SHELL", 7), std::pair(1UL, 8UL));
}

// Help, completion and the environment are made of the rows, so two of one name would hide one another.
TEST(OptionTable, NoVerbHasTwoOptionsOfOneNameOrLetter) {
  for (const Verb* verb : all_verbs()) {
    std::vector<std::string> seen;
    for (const Option& option : options_of(*verb)) {
      seen.push_back(option.name);
      if (option.letter != '\0') seen.emplace_back(1, option.letter);
      EXPECT_FALSE(option.help.empty()) << verb->name << " --" << option.name;
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end()) << verb->name;
  }
}

}  // namespace
}  // namespace flatray
