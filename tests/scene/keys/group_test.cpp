// needs: shapes/circle
#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string group(const std::string& name, const std::string& keys = "") {
  return "[[group]]\nname = \"" + name + "\"\n" + keys + "\n";
}
std::string disc(const std::string& name, const std::string& keys = "") {
  return "[[entity]]\nname = \"" + name + "\"\nshape = { circle = { radius = 1 } }\n" + keys + "\n";
}
const std::string kHead = "flatray = 1\n";
std::string ring(int count) {
  return "repeat = { ring = { count = " + std::to_string(count) + ", radius = 1 } }\n";
}

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> all;
  for (const Entity& one : scene.entities) all.push_back(one.name);
  return all;
}

TEST(Groups, MayStandAnywhereInTheFile) {
  const Scene scene = loaded(kHead + disc("e", "group = \"inner\"") +
                             group("inner", "group = \"outer\"\nlayer = 3") +
                             group("outer", "at = [1, 2]\nlayer = -5"))
                          .scene;
  ASSERT_EQ(scene.groups.size(), 2u);
  EXPECT_EQ(scene.groups[0].name, "outer");
  EXPECT_EQ(scene.groups[1].group, 0u);
  EXPECT_EQ(scene.entities[0].group, 1u);
  EXPECT_EQ(scene.entities[0].layer, -2);
}

// Not all of them for each wrong word, as there may be thousands of both.
TEST(Groups, OfThousandsTheFirstAreComparedWithAWrongName) {
  std::string text = kHead;
  for (int i = 1000; i < 2000; ++i) text += group("g" + std::to_string(i));
  expect_problem(text + group("zebra") + disc("e", "group = \"g100O\""), "did you mean 'g1000'?");
  expect_problem(text + group("zebra") + disc("e", "group = \"zebrb\""), "known: g1000, ");
}

TEST(Groups, HaveAScaleAboveZero) {
  const Scene scene = loaded(kHead + group("a", "scale = 2.5") + group("b")).scene;
  EXPECT_EQ(scene.groups[0].scale.value, 2.5);
  EXPECT_EQ(scene.groups[1].scale.value, 1);
  for (const char* wrong : {"0", "-1", "1e301"})
    EXPECT_FALSE(load(kHead + group("a", std::string("scale = ") + wrong))) << wrong;
}

TEST(Groups, KeepTheProductOfTheirScalesWithin1e300) {
  for (const char* scale : {"1e300", "1e-300"}) {
    const std::string grown = std::string("scale = ") + scale;
    const auto scene = load(kHead + group("outer", grown) +
                            group("inner", "group = \"outer\"\n" + grown + "\n" + ring(3)) +
                            group("within", "group = \"inner\"") + disc("e", "group = \"within\""));
    ASSERT_FALSE(scene);
    ASSERT_EQ(scene.error().size(), 1u) << format(scene.error());
    EXPECT_NE(scene.error()[0].message.find("times those of the groups"), std::string::npos);
  }
}

TEST(Groups, CopiesHoldAllTheirThings) {
  const Scene scene = loaded(kHead + group("arm", ring(2)) + disc("hand", "group = \"arm\"") +
                             disc("leaf", "group = \"arm\"\n" + ring(3)))
                          .scene;
  EXPECT_EQ(names(scene),
            (std::vector<std::string>{"hand.0", "hand.1", "leaf.0.0", "leaf.0.1", "leaf.0.2",
                                      "leaf.1.0", "leaf.1.1", "leaf.1.2"}));
  EXPECT_EQ(scene.entities[4].group, 0u);
  EXPECT_EQ(scene.entities[5].group, 1u);
  EXPECT_EQ(scene.groups[1].name, "arm.1");
}

TEST(Groups, CopiesOfGroupsInGroupsAreNamedOutermostFirst) {
  const Scene scene = loaded(kHead + group("a", ring(2)) + group("b", "group = \"a\"\n" + ring(3)) +
                             disc("e", "group = \"b\"\n" + ring(2)))
                          .scene;
  ASSERT_EQ(scene.entities.size(), 12u);
  EXPECT_EQ(scene.entities[11].name, "e.1.2.1");
  EXPECT_EQ(scene.groups[*scene.entities[11].group].name, "b.1.2");
}

TEST(Groups, ThingsDrawnInThemDifferFromCopyToCopy) {
  const Scene scene = loaded(kHead + group("a", "angle = { uniform = [0, 90] }\n" + ring(2)) +
                             disc("e", "group = \"a\"\nlayer = 1\nangle = { uniform = [0, 90] }"))
                          .scene;
  EXPECT_NE(scene.groups[0].angle, scene.groups[1].angle);
  EXPECT_NE(scene.entities[0].angle, scene.entities[1].angle);
  EXPECT_NE(scene.groups[0].angle, scene.entities[0].angle);
}

TEST(Groups, RefusalsSayWhatToWrite) {
  const Refused cases[] = {
      {kHead + disc("e", "group = \"wheal\"") + group("wheel"),
       "unknown group 'wheal' (did you mean 'wheel'?)"},
      {kHead + group("a", "group = \"b\""), "unknown group 'b'"},
      {kHead + group("a") + group("a"), "two groups are named 'a'"},
      {kHead + "[[group]]\nat = [0, 0]", "group needs 'name'"},
      {kHead + "group = 3", "group is a number, not an array of tables"},
      {kHead + "group = [3]", "group is a number, not a table"},
      {kHead + disc("e", "group = 3"), "entity.group is a number, not a string"},
      {kHead + group("a", "group = 7"), "group.group is a number, not a string"},
      {kHead + group("a", "group = \"a\""), "group 'a' stands in itself: 'a' in 'a'\n"},
      {kHead + group("a", "group = \"b\"") + group("b", "group = \"c\"") +
           group("c", "group = \"a\""),
       "group 'c' stands in itself: 'c' in 'a' in 'b' in 'c'\n"},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

TEST(Groups, ACircleIsToldOnceAlsoOfWhatLeadsIntoIt) {
  const std::string shown = refusal(kHead + group("tail", "group = \"a\"") +
                                    group("a", "group = \"b\"") + group("b", "group = \"a\""));
  EXPECT_NE(shown.find("stands in itself"), std::string::npos);
  EXPECT_EQ(shown.find("stands in itself"), shown.rfind("stands in itself"));
  EXPECT_EQ(shown.find("unknown group"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("more than"), std::string::npos);
}

// g0 holds g1 holds ... each twice.
std::string doubling(int groups) {
  std::string text = kHead;
  for (int i = 0; i < groups; ++i)
    text += group("g" + std::to_string(i),
                  ring(2) + (i > 0 ? "group = \"g" + std::to_string(i - 1) + "\"" : ""));
  return text + disc("leaf", "group = \"g" + std::to_string(groups - 1) + "\"");
}

TEST(StiffCases, E6NestingThatDoublesThirtyTimesIsRefusedBeforeItIsMade) {
  const std::string shown = refusal(doubling(30));
  // 2 + 4 + ... + 2^18 groups fit, the next 2^19 do not.
  EXPECT_NE(shown.find("error: group stands for 524288, after 524286 before it\n"),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find("the limit is 1000000; --max-entities raises it"), std::string::npos);
  EXPECT_LT(shown.size(), 20000u);
}

TEST(StiffCases, E6DeepNestingIsRefused) {
  std::string text = kHead + group("g0");
  for (int i = 1; i < 1000; ++i)
    text += group("g" + std::to_string(i), "group = \"g" + std::to_string(i - 1) + "\"");
  const std::string shown = refusal(text);
  EXPECT_NE(shown.find("group 'g65' stands in more than 64 groups\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find("the limit is 64; --max-depth raises it"), std::string::npos);
  LoadLimits limits;
  limits.max_depth = 999;
  EXPECT_TRUE(load_scene_text("t.toml", text, {}, limits));
}

}  // namespace
}  // namespace flatray
