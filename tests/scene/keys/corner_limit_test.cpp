// needs: formats/toml shapes/ngon shapes/circle
#include <gtest/gtest.h>

#include "scene/load.h"

namespace flatray {
namespace {

std::string copied_entity(const std::string& keys, int copies = 10) {
  return "flatray = 1\n[[entity]]\nrepeat = { ring = { count = " + std::to_string(copies) +
         ", radius = 9 } }\n" + keys + "\n";
}
const std::string kDrawn = "shape = { ngon = { sides = 92, radius = { uniform = [1, 2] } } }";
const std::string kFixed = "shape = { ngon = { sides = 92, radius = 1 } }";
const std::string kDisc = "shape = { circle = { radius = 1 } }\n";

Result<LoadedScene> read(const std::string& text, std::uint64_t most = 999) {
  LoadLimits limits;
  limits.max_corners = most;
  return load_scene_text("t.toml", text, {}, limits);
}

TEST(CornerLimit, ShapesDrawnForEveryCopyAreRefusedWhereTheyStand) {
  const auto refused = read(copied_entity(kDrawn));
  ASSERT_FALSE(refused);
  EXPECT_EQ(format(refused.error()),
            R"(t.toml:4:9: error: the corners of the scene come to more than 999
    shape = { ngon = { sides = 92, radius = { uniform = [1, 2] } } }
            ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~  points, keys, stops, dashes, states and names count, with every copy: draw less of them at random, or say --max-corners N
)");
  EXPECT_TRUE(
      read(copied_entity(kDrawn), 1000));  // 10 copies of 92 corners and 8 for what holds them
}

TEST(CornerLimit, CopiesThatShareAShapeAreNotCounted) {
  EXPECT_TRUE(read(copied_entity(kFixed, 1000), 100));
}

TEST(CornerLimit, MirrorsCountForEveryCopyOfTheirWalls) {
  EXPECT_FALSE(read(copied_entity(kFixed + "\nmaterial = \"mirror\"")));
  EXPECT_TRUE(read(copied_entity(kFixed + "\nmaterial = \"mirror\""), 1100));
}

TEST(CornerLimit, CurvesGradientsDashesPathsStatesAndNamesCount) {
  const std::string drawn = kDisc + "velocity = [{ uniform = [0, 1] }, 0]\n";
  for (const char* keys :
       {"angle = { keys = [[0, 0], [1, { uniform = [0, 1] }]] }",
        R"(fill = { linear = { from = [0, 0], to = [1, 0], stops = ["#000000", "#ffffff"] } })",
        "stroke = { width = 1, dashes = [1, 2, 3, 4] }",
        "follow = { path = [[0, 0], [{ uniform = [1, 2] }, 0]], speed = 1 }",
        R"(name = "a name of more than sixteen letters")"}) {
    EXPECT_FALSE(read(copied_entity(drawn + keys, 1000), 1500)) << keys;
    EXPECT_TRUE(read(copied_entity(drawn + keys, 1000), 10000)) << keys;
  }
  const std::string states =
      copied_entity(drawn +
                        "markov = { chain = \"c\" }\nstates = { A = [{}, {}] }\n"
                        "[markov.c]\nA = { A = 1 }",
                    100);
  EXPECT_FALSE(read(states, 1500));
  EXPECT_TRUE(read(states, 2000));
}

TEST(CornerLimit, IsToldOnceAndMakesNoMoreCopies) {
  std::string text = copied_entity(kDrawn);
  for (int i = 0; i < 100; ++i) text += copied_entity(kDrawn, 1000).substr(12);
  const auto refused = read(text);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().size(), 1u);
}

}  // namespace
}  // namespace flatray
