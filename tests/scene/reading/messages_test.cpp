// needs: shapes/arc shapes/bezier shapes/capsule shapes/circle shapes/convex shapes/ellipse shapes/sector shapes/import shapes/lens shapes/mushroom shapes/ngon shapes/parabola shapes/penrose shapes/polygon shapes/polyline shapes/segment shapes/star shapes/text shapes/tokarsky
#include <gtest/gtest.h>

#include "base/file.h"
#include "scene/reading/vocabulary.h"
#include "scene/scene_text.h"
#include "scene/table_texts.h"
#include "support/paths.h"

namespace flatray {
namespace {

// The scene of the style guide's tenth example, its lines where the example has them.
constexpr const char* kRunner = R"(flatray = 1
film    = { size = [200, 200], world = [[-1, -1], [21, 21]] }


[[chamber]]
name  = "hall"
shape = { box = { min = [0, 0], max = [20, 20] } }

[[ray]]
name      = "probe"
at        = [15, 5]
direction = [1, 1]

[[entity]]
name     = "runner"
shape    = { box = { min = [0, 0], max = [1, 2] } }
at       = [4, 1]
velocty  = [12, 0]
markov   = { start = "STANDING", chain = "runner" }

[markov.runner]
STANDING = { STANDING = 0.10, RUNNING = 0.85, DIE = 0.05 }
RUNNING  = { RUNNING = 0.60, JUMP = 0.30, DIE = 0.01 }
JUMP     = { JUMP = 0.25, DIE = 0.75 }
DIE      = { DIE = 1 }
)";

TEST(Messages, LookAsTheStyleGuideShowsThem) {
  const Result<LoadedScene> result = load_scene_text("my/runner.toml", kRunner);
  ASSERT_FALSE(result);
  EXPECT_EQ(
      format(result.error()),
      R"(my/runner.toml:18:1: error: unknown key 'velocty' of entity (did you mean 'velocity'?)
    velocty  = [12, 0]
    ^~~~~~~
my/runner.toml:23:1: error: transitions out of RUNNING sum to 0.91
    RUNNING  = { RUNNING = 0.60, JUMP = 0.30, DIE = 0.01 }
    ^~~~~~~  they must sum to 1: add 0.09, or say repair = "to-start", "to-self" or "scaled"
)");
}

TEST(Messages, EveryTableSuggestsTheKeyThatWasMeant) {
  const std::vector<TableInfo> all = vocabulary();
  EXPECT_EQ(all.size(), std::size(kTables));
  for (const TableText& table : kTables) {
    const std::string name = documented_name(table.name);
    const auto info = std::find_if(all.begin(), all.end(),
                                   [&](const TableInfo& one) { return one.table == name; });
    ASSERT_NE(info, all.end()) << table.name;
    if (info->keys.empty()) continue;
    const std::string key = info->keys.front().name, slip = key + "x";
    const std::string shown = refusal(with_key(table, slip));
    EXPECT_NE(shown.find("error: unknown key '" + slip + "' of " + table.name + " (did you mean '" +
                         key + "'?)\n"),
              std::string::npos)
        << shown;
  }
}

TEST(Messages, EveryTableListsItsKeysWhereNoneIsNear) {
  for (const TableText& table : kTables) {
    const std::string shown = refusal(with_key(table, "zqzqzqzqzq"));
    EXPECT_NE(shown.find(std::string("error: unknown key 'zqzqzqzqzq' of ") + table.name + "\n"),
              std::string::npos)
        << shown;
    const bool lists = shown.find("known: ") != std::string::npos;
    EXPECT_TRUE(lists || shown.find("it has no keys") != std::string::npos) << shown;
  }
}

TEST(Messages, WordsOfOtherProgramsLeadToTheKey) {
  EXPECT_NE(refusal(with_shape("circle = { radius = 1 }") + "color = \"#ff0000\"\n")
                .find("unknown key 'color' of entity (did you mean 'fill'?)"),
            std::string::npos);
  EXPECT_NE(refusal(with_shape("circle = { radius = 1 }") + "stroke = { color = \"#ff0000\" }\n")
                .find("unknown key 'color' of stroke (did you mean 'colour'?)"),
            std::string::npos);
  EXPECT_NE(refusal("flatray = 1\nspeed = 2\n").find("unknown key 'speed' of scene"),
            std::string::npos);
}

TEST(Messages, AColourWithoutQuotesIsToldToWantThem) {
  const std::string shown = refusal("flatray = 1\nfilm = { background = #cfe3f2 }\n");
  EXPECT_NE(shown.find("t.toml:2:23: error: a value is missing: # begins a comment\n"),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find("colours are written in quotes"), std::string::npos) << shown;
}

// What is no TOML, the place, and the end of the hint.
TEST(Messages, EverySyntaxErrorSaysWhatToWriteInstead) {
  const struct {
    const char *text, *place, *hint;
  } kCases[] = {
      {"x = \"abc", "2:9", "close the text with the quotes that open it"},
      {"x = \"a\x1b\"", "2:7", "write a control character by its number, as \\u001b"},
      {"x = 'abc", "2:9", "close the text with the quotes that open it"},
      {"x = \"\"\"abc", "2:11", "close the text with the quotes that open it"},
      {"x = \"a\\q\"", "2:8", "or the text in single quotes: 'a\\b'"},
      {"fps 3", "2:5", "write key = value; a table is [table]"},
      {"x =", "2:4", "write a value after =, such as 12, true, \"word\" or [1, 2]"},
      {"x = [1, 2", "2:9", "close the array with ]: [1, 2]"},
      {"x = [1 2]", "2:8", "part values by commas, and close the array with ]: [1, 2]"},
      {"x = { a = 1 ", "2:13", "stands in one line: { a = 1, b = 2 }"},
      {"x = { a = 1, }", "2:14", "leave out the comma before }"},
      {"[film", "2:6", "[table], or [[entry]] of several"},
      {"[[entity]", "2:10", "[table], or [[entry]] of several"},
      {"flatray = 2", "2:11", "a key or table stands once: leave one of them out"},
      {"x = abc", "2:5", "words are written in quotes: \"word\""},
      {"x = True", "2:5", "write true or false; words are written in quotes: \"word\""},
      {"x = 1 y = 2", "2:7", "write one key = value a line, and decimals with a point"},
      {"x = 1;", "2:5", "nothing but a comment follows a value in its line"},
      {"x = 05", "2:5", "leave out the zeros it begins with"},
      {"x = 0x", "2:5", "numbers are written like 12, -0.5 or 1e-3"},
      {"// text", "2:1", "a line is key = value, [table], [[entry]] or # a comment"},
  };
  for (const auto& [text, place, hint] : kCases) {
    const std::string shown = refusal(std::string("flatray = 1\n") + text + "\n");
    EXPECT_TRUE(shown.starts_with(std::string("t.toml:") + place + ": error: ")) << shown;
    EXPECT_TRUE(shown.ends_with(hint + std::string("\n"))) << shown;
  }
}

TEST(Messages, AllMistakesComeTogetherInTheOrderOfTheSource) {
  const std::string shown = refusal(R"(flatray = 1
[camera]
follow = "nobody"
[[entity]]
name = "someone"
shape = { box = { min = [0, 0], max = [0, 0] } }
[film]
coverage = "areaa"
[[ray]]
at = [1]
[markov.c]
A = { B = 1 }
)");
  std::vector<std::string> starts = {
      "t.toml:3:10: error: unknown entity 'nobody'",
      "t.toml:6:17: error: box has no area",
      "t.toml:8:12: error: unknown film.coverage 'areaa' (did you mean 'area'?)",
      "t.toml:9:1: error: ray needs 'direction'",
      "t.toml:10:6: error: ray.at has 1 number, not two",
      "t.toml:12:7: error: state 'B' has no row"};
  std::size_t at = 0;
  for (const std::string& start : starts) {
    const std::size_t found = shown.find(start, at);
    ASSERT_NE(found, std::string::npos) << start << "\nin\n" << shown;
    at = found;
  }
}

TEST(Messages, ColumnsCountBytesAlsoAfterOtherScripts) {
  const std::string shown = refusal("flatray = 1\nfilm = { background = \"\", x\u00e9 = 1 }\n");
  EXPECT_EQ(shown.substr(0, 12), "t.toml:2:28:") << shown;
  const std::string value =
      refusal("flatray = 1\n\"\u00e9\u00e9\" = 1\nfilm = { \"\u00e9\" = 1, size = 2 }");
  EXPECT_NE(value.find("t.toml:3:27: error: film.size is a number, not two whole numbers"),
            std::string::npos)
      << value;
}

TEST(Messages, AByteOrderMarkAndCrlfChangeNoPlace) {
  const std::string shown = refusal(
      "\xef\xbb\xbf"
      "flatray = 1\r\nframes = 0\r\n");
  EXPECT_EQ(shown.substr(0, 36), "t.toml:2:10: error: frames is 0\n    ");
}

TEST(Messages, TheVersionIsRequiredAndKnown) {
  EXPECT_NE(refusal("fps = 1\n").find("t.toml:1:1: error: scene needs 'flatray'"),
            std::string::npos);
  EXPECT_NE(refusal("").find("t.toml: error: scene needs 'flatray'"), std::string::npos);
  EXPECT_NE(refusal("flatray = 2\n").find("1:11: error: scene version 2 is newer"),
            std::string::npos);
}

struct E3 {
  const char *size, *expected;
};

TEST(StiffCases, E3RefusedSizesNameTheFieldBeforeAnyAllocation) {
  const E3 cases[] = {
      {"[0, 5]", "t.toml:2:17: error: film.size[0] is 0\n"},
      {"[5, -1]", "t.toml:2:20: error: film.size[1] is -1\n"},
      {"[2147483648, 5]", "t.toml:2:17: error: film.size[0] is 2147483648\n"},
      {"[4294967297, 5]", "t.toml:2:17: error: film.size[0] is 4294967297\n"},
      {"[1.5, 5]", "t.toml:2:17: error: film.size[0] is 1.5\n"},
      {"[65536, 65536]", "t.toml:2:16: error: film.size 65536 x 65536 is 4294967296 pixels\n"},
      {"[1e9, 1e9]",
       "t.toml:2:16: error: film.size 1000000000 x 1000000000 is 1000000000000000000 pixels\n"},
  };
  for (const auto& [size, expected] : cases) {
    const Result<LoadedScene> result =
        load(std::string("flatray = 1\nfilm = {size = ") + size + "}\n");
    ASSERT_FALSE(result) << size;
    ASSERT_EQ(result.error().size(), 1u);
    EXPECT_EQ(result.error()[0].trouble, Trouble::invalid);
    EXPECT_EQ(format(result.error()).substr(0, std::string(expected).size()), expected);
  }
  EXPECT_EQ(loaded("flatray = 1\nfilm = { size = [16384, 16384] }").scene.film.width, 16384);
}

TEST(StiffCases, E3TheLimitIsTheCallers) {
  LoadLimits limits;
  limits.max_pixels = 100;
  const std::string text = "flatray = 1\nfilm = { size = [10, 11] }";
  EXPECT_FALSE(load_scene_text("t.toml", text, {}, limits));
  limits.max_pixels = 110;
  EXPECT_TRUE(load_scene_text("t.toml", text, {}, limits));
}

TEST(StiffCases, E5BracketsAndDottedKeysDoNotExhaustTheStack) {
  EXPECT_NE(refusal("a = " + std::string(100000, '[')).find("depth"), std::string::npos);
  std::string key = "a";
  for (int i = 0; i < 100000; ++i) key += ".a";
  EXPECT_NE(refusal(key + " = 1").find("a key of more than 64 parts"), std::string::npos);
  EXPECT_NE(refusal("[" + key + "]").find("a key of more than 64 parts"), std::string::npos);
  const std::string dots(1000, '.');
  EXPECT_EQ(loaded("flatray = 1 # " + dots + "\n[[ray]]\nname = \"\"\"" + dots +
                   "\"\"\"\nat = [0, 0]\ndirection = [1, 0]")
                .scene.rays[0]
                .name,
            dots);
}

TEST(Messages, HostileBytesAreRefusedWithAPlace) {
  EXPECT_NE(refusal(std::string("flatray = 1\n\0", 13)).find("t.toml:2:1: error:"),
            std::string::npos);
  EXPECT_NE(refusal("flatray = 1\nseed = \"\xff\"").find("2:9: error: this byte is not UTF-8"),
            std::string::npos);
}

// Every unknown name comes with a hint: what it holds must not be all that a scene names.
TEST(Messages, AHintListsFewOfManyNames) {
  std::vector<std::string> known;
  for (int i = 0; i < 1000; ++i) known.push_back(std::to_string(i) + std::string(4000, 'x'));
  const Diagnostic unknown = unknown_word({}, "entity", "y", known);
  EXPECT_EQ(unknown.hint.rfind("known: 0xxx", 0), 0U);
  EXPECT_TRUE(unknown.hint.ends_with("x, ..."));
  EXPECT_LT(unknown.hint.size(), 3000U);
}

// Each of n unknown names was compared with all of n groups: 8000 of both took 20 s.
TEST(Messages, AnUnknownGroupIsComparedWithAThousandNames) {
  for (const int count : {1000, 1001}) {
    std::string text = "flatray = 1\n";
    for (int i = 1; i < count; ++i) text += fmt::format("[[group]]\nname = \"{:04}\"\n", i);
    text += "[[group]]\nname = \"meant\"\n";
    const std::string told =
        refusal(text + "[[entity]]\nshape = { circle = { radius = 1 } }\ngroup = \"maent\"");
    EXPECT_EQ(told.find("did you mean 'meant'?") != std::string::npos, count == 1000) << told;
    EXPECT_NE(told.find("unknown group 'maent'"), std::string::npos) << told;
  }
}

TEST(Messages, SeedsAreExactBeyondTheDoubles) {
  EXPECT_EQ(loaded("flatray = 1\nseed = 9007199254740993").scene.seed, 9007199254740993u);
  EXPECT_EQ(loaded("flatray = 1\nseed = 0x7fffffffffffffff").scene.seed, 0x7fffffffffffffffu);
}

TEST(Messages, AnUnknownExtensionNamesTheKnownOnes) {
  const Result<LoadedScene> result = load_scene_text("a.svg", "");
  ASSERT_FALSE(result);
  EXPECT_NE(format(result.error()).find(".toml"), std::string::npos);
  const Result<LoadedScene> missing = load_scene("no/such/scene.toml");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error()[0].trouble, Trouble::missing);
}

// The part of the document under a heading, up to the next.
std::string section(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("\n### " + name + "\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find("\n#", begin + 1) - begin);
}

TEST(Documents, TheSceneFormatNamesEveryKeyOfEveryTable) {
  const Result<std::string> text = read_file(source_path("/docs/SCENE_FORMAT.md"));
  ASSERT_TRUE(text);
  for (const TableInfo& table : vocabulary())
    for (const KeyInfo& key : table.keys) {
      const std::string row = std::string("| `") + key.name + "` | ";
      const bool of_language = section(*text, table.table).find("\n" + row) != std::string::npos;
      const bool of_kind =
          text->find("\n| `" + KindInfo::name(table) + "` " + row) != std::string::npos;
      EXPECT_TRUE(of_language || of_kind) << table.table << "." << key.name;
    }
}

}  // namespace
}  // namespace flatray
