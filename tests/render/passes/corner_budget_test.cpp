// needs: formats/toml shapes/ngon shapes/segment shapes/circle shapes/arc
#include "support/pictures.h"

namespace flatray {
namespace {

const std::string kHead = "flatray = 1\nfilm = { size = [100, 50], world = [[0, 0], [100, 50]] }\n";
std::string entity(const std::string& keys) { return "[[entity]]\n" + keys + "\n"; }

Result<DrawList> list_of(const std::string& text, std::uint64_t most = std::uint64_t{1} << 25) {
  Scene scene = scene_of(kHead + text);
  scene.max_corners = most;
  return draw_list(make_plan(scene, false), Timeline(scene, 0, 1), 1);
}

TEST(CornerBudget, DashesWithoutNumberAreRefusedByTheirEntity) {
  const std::string dashed = entity(R"(name = "fine"
shape = { segment = { from = [0, 5], to = [100, 5] } }
stroke = { width_px = 1, dashes = [0.2, 0.2] }
repeat = { grid = { count = [1, 10000], step = [0, 0.0001] } })");
  const auto refused = list_of(dashed, 100'000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(format(refused.error()),
            R"(test.toml:3:1: error: with this a frame draws more than 100000 corners
    [[entity]]
    ^~~~~~~~~~  those of lines and dashes count: make dashes longer and wide lines thinner, draw less, or say --max-corners N
)");
}

TEST(CornerBudget, RoundJoinsOfAWideLineAreCountedWhileTheyAreMade) {
  const std::string wide = entity(
      "shape = { ngon = { sides = 10000, radius = 10, centre = [50, 25] } }\n"
      "stroke = { width_px = 100000, joins = \"round\" }");
  EXPECT_FALSE(list_of(wide, 10'000));
}

TEST(CornerBudget, AFrameWithinItIsDrawn) {
  const std::string disc = entity("shape = { circle = { radius = 1 } }\nat = [5, 5]");
  EXPECT_TRUE(list_of(disc, 8));
  EXPECT_FALSE(list_of(disc + disc, 8));
}

TEST(BesideFilm, ShapesBesideTheFilmAreNotOutlined) {
  for (const char* at : {"[-3, 25]", "[103, 25]", "[50, -3]", "[50, 53]", "[1e300, 25]"})
    for (const char* shape : {"{ ngon = { sides = 5, radius = 2 } }", "{ circle = { radius = 2 } }",
                              "{ segment = { from = [-1, -1], to = [1, 1] } }",
                              "{ arc = { radius = 1, from = 0, to = 90 } }"}) {
      const std::string keys = "shape = " + std::string(shape) + "\nat = " + at;
      EXPECT_TRUE(list_of(entity(keys))->items.empty()) << keys;
      EXPECT_FALSE(list_of(entity(keys + "\nstroke = { width_px = 9 }"))->items.empty() &&
                   std::string(at) != "[1e300, 25]")
          << keys;
    }
}

// A thing whose box touches the film is drawn, and so is the miter of a line far beside it.
TEST(BesideFilm, WhatReachesTheFilmIsDrawn) {
  EXPECT_EQ(list_of(entity("shape = { circle = { radius = 2 } }\nat = [-2, 25]"))->items.size(),
            1u);
  const std::string spike = entity(
      "fill = \"none\"\nstroke = { width = 2, joins = \"miter\", miter_limit = 100 }\n"
      "shape = { polyline = { points = [[-20, 25.5], [-10, 25], [-20, 24.5]] } }");
  EXPECT_TRUE(has_content(picture(kHead + spike)));
}

// Whether part of a faded picture lies beside the film changes no level of the rest.
TEST(BesideFilm, FadedPicturesAreFadedAlike) {
  const auto chamber = [](const char* at) {
    return kHead + R"([[chamber]]
shape = { box = { min = [10, 10], max = [90, 40] } }
fill = "#336699"
opacity = 0.3
pillars = [{ shape = { circle = { radius = 2 } }, at = )" +
           at + " }]\n";
  };
  const Image away = picture(chamber("[1000, 0]")), near = picture(chamber("[101.5, 25]"));
  std::size_t differ = 0;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 95; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>((y * 100 + x) * 3 + c);
        differ += away.pixels[i] != near.pixels[i];
      }
  EXPECT_EQ(differ, 0u);
}

TEST(CornerBudget, ARayIsRefusedByItsPlace) {
  const auto refused = list_of(R"([[entity]]
shape = { segment = { from = [0, 5], to = [100, 5] } }
[[ray]]
at = [0, 20]
direction = [1, 0]
stroke = { width_px = 1, colour = "#ff0000", dashes = [0.5, 0.5] }
)",
                               100);
  ASSERT_FALSE(refused);
  EXPECT_EQ(format(refused.error()).substr(0, 20), "test.toml:5:1: error")
      << format(refused.error());
}

}  // namespace
}  // namespace flatray
