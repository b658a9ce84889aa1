// needs: shapes/circle formats/list
#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace flatray {
namespace {

const std::string kScene =
    with_shape("circle = { radius = 1 }") +
    "at = [1, 2]\n[[entity]]\nname = \"other one\"\nshape = { circle = { radius = 2 } }\n"
    "[markov.run]\nA = { A = 1 }\n";

Scene overridden(const std::string& key, const std::string& value) {
  return loaded(kScene, {{key, value}}).scene;
}

TEST(Overrides, ReplaceOrAddAKey) {
  EXPECT_EQ(overridden("frames", "7").frames, 7u);
  EXPECT_EQ(overridden("film.size", "[3, 4]").film.height, 4);
  EXPECT_EQ(overridden("film", "{ size = [5, 6] }").film.height, 6);
  EXPECT_EQ(overridden("markov.run.hold", "2").chains[0].hold, 2u);
  EXPECT_EQ(overridden("markov.run.A.A", "1.0").chains[0].hold, 1u);
}

TEST(Overrides, ChooseEntriesByNumberFromZeroOrByName) {
  EXPECT_EQ(overridden("entity.0.at", "[3, 4]").entities[0].at, Vec2(3, 4));
  EXPECT_EQ(overridden("entity.1.at", "[3, 4]").entities[1].at, Vec2(3, 4));
  EXPECT_EQ(overridden("entity.e.velocity", "[5, 6]").entities[0].velocity, Vec2(5, 6));
  EXPECT_EQ(overridden("entity.\"other one\".angle", "180").entities[1].angle,
            overridden("entity.1.angle", "180").entities[1].angle);
  EXPECT_EQ(overridden("entity.0.at.1", "9").entities[0].at, Vec2(1, 9));
}

TEST(Overrides, MayLeaveOutTheQuotesOfWordsAndColours) {
  EXPECT_EQ(overridden("light.tone", "filmic").light.tone, ToneCurve::filmic);
  EXPECT_EQ(overridden("film.background", "#010203").film.background.b, 3);
  EXPECT_EQ(overridden("entity.0.name", "a-b.c").entities[0].name, "a-b.c");
}

TEST(Overrides, TheLastOneCounts) {
  EXPECT_EQ(loaded(kScene, {{"frames", "2"}, {"frames", "3"}}).scene.frames, 3u);
}

TEST(Overrides, WorkOnEveryFormat) {
  const auto list = load_scene_text("a.list", "A, 1, 2\n", {{"entity.A.layer", "3"}, {"fps", "5"}});
  ASSERT_TRUE(list) << format(list.error());
  EXPECT_EQ(list->scene.entities[0].layer, 3);
  EXPECT_EQ(list->scene.fps, 5);
}

struct RefusedKey {
  const char *key, *value, *message;
};

TEST(Overrides, MistakesAreUsageErrorsThatNameTheKey) {
  const RefusedKey cases[] = {
      {"film.sise", "[1, 2]",
       "-D film.sise:1:6: error: unknown key 'sise' of film (did you mean 'size'?)"},
      {"film.size", "[1, 0]", "-D film.size:1:17: error: film.size[1] is 0"},
      {"film.size", "[1,", "-D film.size:1:"},
      {"film.size", "[1, 2]\nframes = 3", "error: this is not one key and one value"},
      {"", "3", "-D :1:2: error:"},
      {"frames.x", "3", "frames is a table, not a whole number"},
      {"flatray.x", "3", "error: 'x' stands in a number"},
      {"entity.2.at", "[1, 2]", "-D entity.2.at:1:8: error: there is no entry 2"},
      {"entity.eh.at", "[1, 2]", "error: unknown name 'eh' (did you mean 'e'?)"},
      {"entity.0.att", "[1, 2]", "unknown key 'att' of entity (did you mean 'at'?)"},
      {"markov.rum.hold", "2", "chain 'rum' has no states"},
  };
  for (const auto& [key, value, message] : cases) {
    const auto got = load(kScene, {{key, value}});
    ASSERT_FALSE(got) << key;
    EXPECT_EQ(got.error()[0].trouble, Trouble::usage) << key;
    EXPECT_NE(format(got.error()).find(message), std::string::npos) << format(got.error());
  }
}

// A line of flatray.toml, a variable and a sweep, as messages name them.
TEST(Overrides, MistakesAreToldWhereTheyAreSaid) {
  const auto file = std::make_shared<const SourceText>("flatray.toml", "define = ['fps=0']\n");
  const Place in_file{file, 10, 7};
  EXPECT_EQ(refusal(kScene, {{"fps", "0", in_file}}),
            "flatray.toml:1:11: error: fps is not above 0\n    define = ['fps=0']\n"
            "              ^~~~~~~  write frames a second\n");
  EXPECT_TRUE(refusal(kScene, {{"fps", "[", in_file}}).starts_with("flatray.toml:1:11: error:"));
  EXPECT_TRUE(refusal(kScene, {{"fps", "0", named_place("FLATRAY_DEFINE")}})
                  .starts_with("FLATRAY_DEFINE fps:1:7: error: fps is not above 0\n"));
}

TEST(StiffCases, E3SizesFromTheCommandLineAreUsageErrors) {
  for (const char* size : {"[0, 1]", "[-1, 1]", "[2147483648, 1]", "[4294967297, 1]",
                           "[65536, 65536]", "[1e9, 1e9]"}) {
    const auto got = load("flatray = 1", {{"film.size", size}});
    ASSERT_FALSE(got) << size;
    ASSERT_EQ(got.error().size(), 1u);
    EXPECT_EQ(got.error()[0].trouble, Trouble::usage);
    EXPECT_EQ(got.error()[0].where.source->name(), "-D film.size");
    EXPECT_EQ(got.error()[0].message.substr(0, 9), "film.size");
  }
}

TEST(Overrides, LimitsTheyPassAreToldWhereTheyStand) {
  const auto got = load(
      "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\n"
      "repeat = { grid = { count = [2, 2], step = [1, 1] } }\n",
      {{"entity.0.repeat.grid.count", "[4000, 4000]"}});
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error()[0].where.source->name(), "-D entity.0.repeat.grid.count");
  EXPECT_EQ(got.error()[0].trouble, Trouble::usage);
}

}  // namespace
}  // namespace flatray
