#include "app/options/arguments.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

const Option kOptions[] = {
    {"output", 'o', "PATTERN", ""}, {"jobs", 'j', "N", ""},
    {"max-pixels", '\0', "N", ""},  {"define", 'D', "KEY=VALUE", "", OptionKind::list},
    {"ray", '\0', "x,y,dx,dy", ""}, {"quiet", 'q', "", "", OptionKind::flag}};

const char* nothing(const char*) { return nullptr; }

const char* everything(const char* name) {
  const std::string_view variable = name;
  if (variable == "FLATRAY_JOBS") return "7";
  if (variable == "FLATRAY_MAX_PIXELS") return "100";
  if (variable == "FLATRAY_QUIET") return "yes";
  if (variable == "FLATRAY_OUTPUT") return "";
  return nullptr;
}

Arguments parse(std::vector<std::string> words, Environment environment = &nothing) {
  return parse_arguments(kOptions, words, environment);
}

std::string problem(std::vector<std::string> words) {
  const Arguments parsed = parse(std::move(words));
  for (const Diagnostic& one : parsed.problems)
    if (one.trouble != Trouble::usage) return "wrong trouble";
  return parsed.problems.empty() ? "accepted" : format(parsed.problems);
}

TEST(Arguments, OptionsAndOperandsStandInAnyOrder) {
  const std::vector<std::vector<std::string>> orders = {
      {"a.toml", "b.toml", "-o", "x.png", "-q"},
      {"-q", "-o", "x.png", "a.toml", "b.toml"},
      {"a.toml", "-q", "b.toml", "-ox.png"},
      {"--output=x.png", "a.toml", "--quiet", "b.toml"}};
  for (const auto& words : orders) {
    const Arguments arguments = parse(words);
    ASSERT_TRUE(arguments.problems.empty()) << words[0];
    EXPECT_EQ(arguments.operands(), (std::vector<std::string>{"a.toml", "b.toml"}));
    EXPECT_EQ(arguments.text("output"), "x.png");
    EXPECT_TRUE(arguments.has("quiet"));
    EXPECT_FALSE(arguments.has("jobs"));
  }
}

TEST(Arguments, ValuesMayBeginWithAMinusAndDashDashEndsOptions) {
  const Arguments arguments = parse({"--ray", "-1,2,3,4", "-o", "-", "--", "-q"});
  ASSERT_TRUE(arguments.problems.empty());
  EXPECT_EQ(arguments.text("ray"), "-1,2,3,4");
  EXPECT_EQ(arguments.text("output"), "-");
  EXPECT_EQ(arguments.operands(), std::vector<std::string>{"-q"});
  EXPECT_FALSE(arguments.has("quiet"));
}

TEST(Arguments, ALoneMinusIsAnOperand) {
  const Arguments arguments = parse({"-", "-q"});
  ASSERT_TRUE(arguments.problems.empty());
  EXPECT_EQ(arguments.operands(), std::vector<std::string>{"-"});
}

TEST(Arguments, AListOptionTakesOneValueEachTime) {
  const Arguments arguments = parse({"-D", "a=1", "scene.toml", "-D", "b=2", "-Dc=3"});
  ASSERT_TRUE(arguments.problems.empty());
  EXPECT_EQ(arguments.list("define"), (std::vector<std::string>{"a=1", "b=2", "c=3"}));
  EXPECT_EQ(arguments.operands(), std::vector<std::string>{"scene.toml"});
}

// A key has the value said nearest: on the command line, in the environment, in a file.
TEST(Arguments, KeysOfAllPlacesGoTogether) {
  Arguments arguments = parse({"-D", "a=1"}, [](const char* name) {
    return std::string_view(name) == "FLATRAY_DEFINE" ? "b=2" : nullptr;
  });
  arguments.add_farther("define", {"flatray.toml", {"a=9", "b=9", "c=3", "aa=4"}});
  arguments.add_nearer("define", {"--profile", {"c=7"}});
  EXPECT_EQ(arguments.list("define"), (std::vector<std::string>{"aa=4", "b=2", "a=1", "c=7"}));
  const Arguments::Given& given = *arguments.find("define");
  const char* const places[] = {"flatray.toml", "FLATRAY_DEFINE", "--define", "--profile"};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(given.where(i).source->name(), places[i]);
}

// So that a file does not set what the environment says no to.
TEST(Arguments, AFlagThatTheEnvironmentDeniesIsKnown) {
  const Environment zero = [](const char* name) {
    return std::string_view(name) == "FLATRAY_QUIET" ? "0" : nullptr;
  };
  const Environment no = [](const char* name) {
    return std::string_view(name) == "FLATRAY_QUIET" ? "no" : nullptr;
  };
  for (const Environment denies : {zero, no}) {
    const Arguments arguments = parse({"a"}, denies);
    EXPECT_TRUE(arguments.problems.empty());
    EXPECT_FALSE(arguments.has("quiet"));
    EXPECT_TRUE(arguments.denied.contains("quiet"));
  }
  EXPECT_TRUE(parse({"a"}).denied.empty());
}

TEST(Arguments, LettersOfFlagsStandTogetherBeforeAValue) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"-qo", "x.png"}, {"-qox.png"}}) {
    const Arguments arguments = parse(words);
    EXPECT_TRUE(arguments.problems.empty());
    EXPECT_TRUE(arguments.has("quiet"));
    EXPECT_EQ(arguments.text("output"), "x.png");
  }
  EXPECT_NE(problem({"-qz"}).find("-qz: error: unknown option"), std::string::npos);
}

TEST(Arguments, FlagsWinOverTheEnvironment) {
  const Arguments arguments = parse({"-j", "2"}, &everything);
  EXPECT_EQ(arguments.text("jobs"), "2");
  EXPECT_EQ(arguments.text("max-pixels"), "100");
  EXPECT_TRUE(arguments.has("quiet"));
  EXPECT_FALSE(arguments.has("output")) << "an empty variable counts as unset";
}

TEST(Arguments, OfWaysToPrintTheOneSaidNearerCounts) {
  using Given = Arguments::Given;
  const Given here{"--csv", {}}, there{"FLATRAY_JSON", {}};
  Arguments near({{"csv", here}, {"json", there}}, {});
  near.keep_one_format();
  EXPECT_TRUE(near.problems.empty());
  EXPECT_TRUE(near.has("csv"));
  EXPECT_FALSE(near.has("json"));
  Arguments alike({{"csv", here}, {"json", {"--json", {}}}}, {});
  alike.keep_one_format();
  EXPECT_EQ(format(alike.problems),
            "--csv: error: does not go with --json\n    each is all that is printed: leave one of "
            "them out\n");
}

TEST(Arguments, AnUnknownOptionNamesTheNearest) {
  EXPECT_NE(
      problem({"--outptu", "x"}).find("--outptu: error: unknown option (did you mean --output?)"),
      std::string::npos);
  EXPECT_NE(problem({"--max-pixel=5"}).find("did you mean --max-pixels?"), std::string::npos);
  EXPECT_NE(problem({"--zzzzzzzzz"}).find("unknown option\n"), std::string::npos);
}

TEST(Arguments, AllMistakesAreReportedTogether) {
  const std::string all = problem({"--outptu", "--quit", "-j", "1", "-j", "2"});
  EXPECT_NE(all.find("--outptu"), std::string::npos);
  EXPECT_NE(all.find("--quit"), std::string::npos);
  EXPECT_NE(all.find("given 2 times: '1' and '2'"), std::string::npos);
}

TEST(Arguments, AMissingValueIsAUsageError) {
  EXPECT_NE(problem({"-o"}), "accepted");
  EXPECT_NE(problem({"-o", "--quiet"}).find("needs a value PATTERN, not the option --quiet"),
            std::string::npos);
  EXPECT_NE(problem({"--quiet=perhaps"}), "accepted");
}

TEST(Arguments, ValuesThatAreMissingAreToldWithAllElse) {
  const std::string all = problem({"--quiet=3", "--zzzz", "-o"});
  EXPECT_NE(all.find("--quiet: error: takes no value"), std::string::npos) << all;
  EXPECT_NE(all.find("--zzzz: error: unknown option"), std::string::npos) << all;
  EXPECT_NE(all.find("--output: error: needs a value PATTERN\n    say --output PATTERN"),
            std::string::npos)
      << all;
}

}  // namespace
}  // namespace flatray
