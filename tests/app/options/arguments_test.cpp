#include "app/options/arguments.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

constexpr Option kOptions[] = {
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

Result<Arguments> parse(std::vector<std::string> words, Environment environment = &nothing) {
  return parse_arguments(kOptions, std::move(words), environment);
}

std::string problem(std::vector<std::string> words) {
  const auto parsed = parse(std::move(words));
  if (parsed) return "accepted";
  for (const Diagnostic& one : parsed.error())
    if (one.trouble != Trouble::usage) return "wrong trouble";
  return format(parsed.error());
}

TEST(Arguments, OptionsAndOperandsStandInAnyOrder) {
  const std::vector<std::vector<std::string>> orders = {
      {"a.toml", "b.toml", "-o", "x.png", "-q"},
      {"-q", "-o", "x.png", "a.toml", "b.toml"},
      {"a.toml", "-q", "b.toml", "-ox.png"},
      {"--output=x.png", "a.toml", "--quiet", "b.toml"}};
  for (const auto& words : orders) {
    const auto arguments = parse(words);
    ASSERT_TRUE(arguments) << words[0];
    EXPECT_EQ(arguments->operands(), (std::vector<std::string>{"a.toml", "b.toml"}));
    EXPECT_EQ(arguments->text("output"), "x.png");
    EXPECT_TRUE(arguments->has("quiet"));
    EXPECT_FALSE(arguments->has("jobs"));
  }
}

TEST(Arguments, ValuesMayBeginWithAMinusAndDashDashEndsOptions) {
  const auto arguments = parse({"--ray", "-1,2,3,4", "-o", "-", "--", "-q"});
  ASSERT_TRUE(arguments);
  EXPECT_EQ(arguments->text("ray"), "-1,2,3,4");
  EXPECT_EQ(arguments->text("output"), "-");
  EXPECT_EQ(arguments->operands(), std::vector<std::string>{"-q"});
  EXPECT_FALSE(arguments->has("quiet"));
}

TEST(Arguments, ALoneMinusIsAnOperand) {
  const auto arguments = parse({"-", "-q"});
  ASSERT_TRUE(arguments);
  EXPECT_EQ(arguments->operands(), std::vector<std::string>{"-"});
}

TEST(Arguments, AListOptionTakesOneValueEachTime) {
  const auto arguments = parse({"-D", "a=1", "scene.toml", "-D", "b=2", "-Dc=3"});
  ASSERT_TRUE(arguments);
  EXPECT_EQ(arguments->list("define"), (std::vector<std::string>{"a=1", "b=2", "c=3"}));
  EXPECT_EQ(arguments->operands(), std::vector<std::string>{"scene.toml"});
}

TEST(Arguments, FlagsWinOverTheEnvironment) {
  const auto arguments = parse({"-j", "2"}, &everything);
  ASSERT_TRUE(arguments);
  EXPECT_EQ(*arguments->whole("jobs", 1, 1, 99), 2U);
  EXPECT_EQ(*arguments->whole("max-pixels", 5, 1, 999), 100U);
  EXPECT_TRUE(arguments->has("quiet"));
  EXPECT_FALSE(arguments->has("output")) << "an empty variable counts as unset";
}

TEST(Arguments, TheBuiltInValueComesLast) {
  EXPECT_EQ(*parse({}, &everything)->whole("jobs", 1, 1, 99), 7U);
  EXPECT_EQ(*parse({})->whole("jobs", 1, 1, 99), 1U);
}

TEST(Arguments, AMistakeInTheEnvironmentNamesTheVariable) {
  const auto arguments = parse({}, &everything);
  const auto refused = arguments->whole("max-pixels", 5, 1, 99);
  ASSERT_FALSE(refused);
  EXPECT_EQ(format(refused.error()),
            "FLATRAY_MAX_PIXELS: error: 100 is out of range\n    say a number from 1 to 99\n");
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

TEST(Arguments, NumbersAreDigitsInRange) {
  for (const char* bad : {"", "0", "-1", "1.5", "1e3", "99999999999999999999", " 1", "100"})
    EXPECT_FALSE(parse({std::string("--jobs=") + bad}).and_then([](const Arguments& given) {
      return given.whole("jobs", 1, 1, 99);
    })) << bad;
}

}  // namespace
}  // namespace flatray
