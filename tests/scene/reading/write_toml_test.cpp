// needs: formats/list formats/obj formats/toml shapes/import
#include "scene/reading/write_toml.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "scene/reading/format.h"
#include "scene/reading/numbers.h"
#include "scene/scene_text.h"
#include "support/paths.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

Result<SceneDesc> read(const std::string& name, const std::string& text) {
  return format_for_name(name)->read(std::make_shared<const SourceText>(name, text), {});
}

// A description in one form for all ways to write it: decimals as digits and exponent.
std::string content(const Value& value) {
  std::string all;
  switch (value.kind) {
    case Value::Kind::number: {
      const auto decimal = parse_decimal(source_text(value));
      if (!decimal) return fmt::format("{}", *parse_integer(source_text(value)));
      return fmt::format("{}{}e{}", source_text(value).starts_with('-') ? "-" : "", decimal->digits,
                         decimal->exponent);
    }
    case Value::Kind::array:
      for (const Value& item : value.items) all += content(item) + ",";
      return "[" + all + "]";
    case Value::Kind::table:
      for (const Member& member : value.members)
        all += fmt::format("\"{}\"=", member.key) + content(member.value) + ",";
      return "{" + all + "}";
    default:
      return fmt::format("<{}>", value.text);
  }
}

// Of the scene's own keys the single values come first.
std::string scene_content(const SceneDesc& desc) {
  std::vector<std::string> keys;
  for (const Member& member : desc.root.members)
    keys.push_back(member.key + "=" + content(member.value));
  std::sort(keys.begin(), keys.end());
  std::string all;
  for (const std::string& key : keys) all += key + "\n";
  return all;
}

void expect_the_same_again(const std::string& name, const std::string& text) {
  const Result<SceneDesc> first = read(name, text);
  ASSERT_TRUE(first) << name << "\n" << format(first.error());
  const std::string written = write_toml(*first);
  const Result<SceneDesc> second = read("w.toml", written);
  ASSERT_TRUE(second) << name << "\n" << format(second.error()) << written;
  EXPECT_EQ(scene_content(*second), scene_content(*first)) << written;
  EXPECT_EQ(write_toml(*second), written) << name;
}

TEST(WriteToml, EverySceneOfTheProjectReadsBackTheSame) {
  std::size_t scenes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(source_path("/scenes"))) {
    if (format_for_name(entry.path().string()) == nullptr) continue;
    const Result<std::string> text = read_file(entry.path());
    ASSERT_TRUE(text);
    expect_the_same_again(entry.path().string(), *text);
    ++scenes;
  }
  EXPECT_GT(scenes, 15u);
  expect_the_same_again("objects.list", "{ A, 1, 2.5 }\nB, \"x\", -3, 1e-9\n");
}

TEST(WriteToml, KeysAndStringsOfAnyBytesReadBackTheSame) {
  expect_the_same_again(
      "t.toml",
      "\"\" = 1\n\"a b\" = \"q\\\" \\\\ \\u0000 \\t \\u007f \u00e9\"\n'\"' = '''\nx\n'''\n"
      "[x.\"y.z\".\"\u00e9\"]\nk = [[], {}, [[{}]], { a = [ ] }]\n[[l]]\n[[l.m]]\n");
}

// A list in another encoding: what it is converted to is UTF-8.
TEST(WriteToml, BytesThatAreNoUtf8BecomeLatin1) {
  const Result<SceneDesc> list = read("l.list", "caf\xe9, 1, 2\n\xc3\xa9, 3, 4\n");
  ASSERT_TRUE(list);
  const Result<SceneDesc> again = read("w.toml", write_toml(*list));
  ASSERT_TRUE(again) << format(again.error());
  const Value& entities = again->root.find("entity")->value;
  EXPECT_EQ(entities.items[0].find("name")->value.text, "caf\xc3\xa9");
  EXPECT_EQ(entities.items[1].find("name")->value.text, "\xc3\xa9");
}

TEST(WriteToml, NumbersAreTheShortestOfTheirDecimal) {
  const std::pair<const char*, const char*> cases[] = {
      {"1_000.50", "1000.5"},
      {"0xff", "255"},
      {"0b101", "5"},
      {"+7", "7"},
      {"5.0", "5"},
      {"-0.0", "-0.0"},
      {"-0", "-0.0"},
      {"0.000", "0"},
      {"1e3", "1e3"},
      {"100", "100"},
      {"1000", "1e3"},
      {"0.10", "0.1"},
      {"0.00012", "1.2e-4"},
      {"1.7e308", "1.7e308"},
      {"123456.789e-3", "123.456789"},
      {"0.1000000000000000055511151231257827", "0.1000000000000000055511151231257827"},
      {"9223372036854775807", "9223372036854775807"},
      {"12345678901234567891.0", "12345678901234567891.0"},
  };
  for (const auto& [from, to] : cases) EXPECT_EQ(shortest_number(from), to);
}

// toml++ reads 128 characters of a number, a sign aside.
TEST(WriteToml, NumbersTooLongForTomlBecomeTheirDouble) {
  const std::string ones(126, '1'), more(300, '1'), zeros(140, '0');
  const std::pair<std::string, std::string> cases[] = {
      {"-0." + ones, "-0." + ones},
      {"-0.1" + ones, "-0.1111111111111111"},
      {"1." + more, "1.1111111111111112"},
      {"1" + more, "1.1111111111111112e300"},
      {"1.5" + zeros, "1.5"},
      {"0." + zeros + "25", "2.5e-141"},
      {"123456789012345678901." + more, "123456789012345683968.0"},
      {"-1.e-200000", "-0.0"},
  };
  for (const auto& [from, to] : cases) EXPECT_EQ(shortest_number(from), to) << from;
}

TEST(WriteToml, MembersOfATableKeepTheirOrder) {
  const std::string text = fmt::format(
      "[[entity]]\nshape = {{ a = 1 }}\nb = [1]\nlast = {{ c = \"{}\" }}\n[[entity.parts]]\nd = "
      "1\n",
      std::string(200, 'x'));
  const Result<SceneDesc> desc = read("t.toml", text);
  ASSERT_TRUE(desc);
  const std::string written = write_toml(*desc);
  EXPECT_NE(written.find("\n[entity.last]\nc = "), std::string::npos) << written;
  EXPECT_NE(written.find("\n[[entity.parts]]\nd = 1\n"), std::string::npos) << written;
  expect_the_same_again("t.toml", text);
}

TEST(WriteToml, LongListsFillTheirLines) {
  std::string points;
  for (int i = 0; i < 100; ++i) points += fmt::format("[{}, 0.25],", i);
  const Result<SceneDesc> desc =
      read("t.toml", "[[entity]]\nshape = { polygon = { points = [" + points + "] } }");
  ASSERT_TRUE(desc);
  const std::string written = write_toml(*desc);
  std::size_t longest = 0, begin = 0, lines = 0;
  for (std::size_t end = 0; (end = written.find('\n', begin)) != std::string::npos;
       begin = end + 1, ++lines)
    longest = std::max(longest, end - begin);
  EXPECT_LE(longest, 100u);
  EXPECT_LE(lines, 20u);
}

}  // namespace
}  // namespace flatray
