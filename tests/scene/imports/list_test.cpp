// needs: shapes/import formats/list formats/obj
#include <gtest/gtest.h>

#include "scene/reading/format.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

Result<LoadedScene> load_list(const std::string& text) {
  return load_scene_text("objects.txt", text);
}

TEST(List, ReadsThePapersObjects) {
  const auto got =
      load_list("# the paper's\n{ SPIDER MAN, 200,200}\n\nBAT, MAN, -1.5, 2e2  # comma\r\n{A,0,0}");
  ASSERT_TRUE(got) << format(got.error());
  const Scene& scene = got->scene;
  EXPECT_EQ(scene.fps, 1);
  ASSERT_EQ(scene.entities.size(), 3u);
  EXPECT_EQ(scene.entities[0].name, "SPIDER MAN");
  EXPECT_EQ(scene.entities[0].at, Vec2(200, 200));
  EXPECT_EQ(scene.entities[1].name, "BAT, MAN");
  EXPECT_EQ(scene.entities[1].at, Vec2(-1.5, 200));
  const Shape& block = scene.shapes[scene.entities[0].shape];
  EXPECT_EQ(block.vertices, (std::vector<Vec2>{{0, 0}, {64, 0}, {64, 128}, {0, 128}}));
  EXPECT_EQ(scene.entities[0].where.source->position(scene.entities[0].where.offset).line, 2);
}

TEST(List, MistakesHaveALineAndAColumn) {
  const Refused cases[] = {
      {"A, 1, 2\n{ B, 1, 2", "objects.txt:2:1: error: the closing brace is missing"},
      {"B, 1, 2 }", "1:1: error: the opening brace is missing"},
      {"B, 1", "1:1: error: a name and two numbers are wanted"},
      {", 1", "1:1: error: a name and two numbers are wanted"},
      {"1", "1:1: error: a name and two numbers are wanted"},
      {", 1, 2", "1:1: error: the name is missing"},
      {"B, x, 2", "1:4: error: 'x' is not a finite number"},
      {"B, 1, nan", "1:7: error: 'nan' is not a finite number"},
      {"B, 1,", "1:1: error: '' is not a finite number"},
      {"{", "1:1: error: the closing brace is missing"},
  };
  expect_refused(cases, [](const std::string& text) {
    const auto got = load_list(text);
    return got ? "" : format(got.error());
  });
}

TEST(List, MoreObjectsThanTheLimitNameTheOption) {
  LoadLimits limits;
  limits.max_entities = 2;
  const auto refused = load_scene_text("objects.txt", "A, 1, 2\nB, 1, 2\nC, 1, 2", {}, limits);
  ASSERT_FALSE(refused);
  const std::string shown = format(refused.error());
  EXPECT_NE(shown.find("objects.txt:3:1: error: the list has more than 2 objects"),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find("--max-entities raises the limit"), std::string::npos) << shown;
  limits.max_entities = 3;
  EXPECT_TRUE(load_scene_text("objects.txt", "A, 1, 2\nB, 1, 2\nC, 1, 2", {}, limits));
}

TEST(List, NumbersThatLoseSomethingAreWarnedOf) {
  const auto got = load_list("A, 9007199254740993, 1e-400");
  ASSERT_TRUE(got);
  EXPECT_EQ(got->warnings.size(), 2u);
}

TEST(Formats, AreChosenByExtensionOrContent) {
  EXPECT_STREQ(format_for_name("a/b.TOML")->name, "toml");
  EXPECT_STREQ(format_for_name("b.obj2d")->name, "obj");
  EXPECT_STREQ(format_for_name("b.list")->name, "list");
  EXPECT_EQ(format_for_name("b"), nullptr);
  EXPECT_STREQ(format_for_text("# x\n\nv 1 2 3\n")->name, "obj");
  EXPECT_STREQ(format_for_text("{ A, 1, 2 }")->name, "list");
  EXPECT_STREQ(format_for_text("A, 1, 2")->name, "list");
  EXPECT_STREQ(format_for_text("flatray = 1")->name, "toml");
  EXPECT_STREQ(format_for_text("[film]\nsize = [1, 2]")->name, "toml");
  EXPECT_STREQ(format_for_text("")->name, "toml");
}

TEST(Formats, StandardInputIsReadByItsContent) {
  const auto obj = load_scene_text("-", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  ASSERT_TRUE(obj) << format(obj.error());
  EXPECT_EQ(obj->scene.shapes[0].piece_count(), 1u);
  EXPECT_TRUE(load_scene_text("-", "flatray = 1\n"));
}

TEST(Formats, AreListed) {
  std::vector<std::string> names;
  for (const Format* format : formats()) names.emplace_back(format->name);
  EXPECT_EQ(names, (std::vector<std::string>{"hill", "hqz", "list", "obj", "toml"}));
}

}  // namespace
}  // namespace flatray
