// needs: formats/toml shapes/box
// A ray that comes round to the same lines is drawn as often as it takes to draw each of them.
#include "support/pictures.h"

namespace flatray {
namespace {

// README's closed diamond.
std::string diamond(int bounces, const std::string& look) {
  return "flatray = 1\nfilm = { size = [50, 50], world = [[-1, -1], [21, 21]] }\n"
         "[[chamber]]\nshape = { box = { min = [0, 0], max = [20, 20] } }\nstroke = \"none\"\n"
         "[[ray]]\nat = [15, 5]\ndirection = [1, 1]\nbounces = " +
         std::to_string(bounces) + "\n" + look;
}

std::size_t edges_of(const DrawList& list) {
  std::size_t edges = 0;
  for (const DrawItem& item : list.items)
    if (const auto* path = std::get_if<FillPath>(&item.region)) edges += path->edges.size();
  return edges;
}

std::size_t edges_drawn(int bounces, const std::string& look) {
  const Scene scene = scene_of(diamond(bounces, look));
  return edges_of(*draw_list(make_plan(scene, false), Timeline(scene, 0, 1), 1));
}

TEST(OrbitRounds, ThousandsAreDrawnAsTwo) {
  for (const char* look : {"stroke = { width_px = 3, colour = \"#336699\" }",
                           "stroke = { width_px = 3, colour = \"#336699\" }\nopacity = 0.5",
                           "stroke = { width_px = 9, joins = \"bevel\", caps = \"butt\" }"})
    EXPECT_EQ(edges_drawn(9, look), edges_drawn(10'001, look)) << look;
  const char* shaded = "stroke = { width_px = 3, colour = \"#336699\" }\nend_colour = \"#ff0000\"";
  EXPECT_LT(edges_drawn(40'000, shaded), 2 * edges_drawn(1000, shaded));
  // Dashes lie elsewhere each time.
  const char* dashed = "stroke = { width_px = 3, colour = \"#336699\", dashes = [7, 3] }";
  EXPECT_GT(edges_drawn(200, dashed), 10 * edges_drawn(9, dashed));
}

// What a line covers does not depend on how often it is drawn: the same bytes as of one dash, of which
// no round is left out.
TEST(OrbitRounds, AreThePictureOfAllLines) {
  for (const std::string look :
       {"width_px = 3, colour = \"#336699\" }\nopacity = 0.5",
        "width_px = 7, colour = \"#336699aa\", joins = \"miter\", caps = \"square\" }",
        "width_px = 2.5, joins = \"bevel\", caps = \"butt\" }"})
    for (const int bounces : {40, 41, 42, 43}) {
      const Image once = picture(diamond(bounces, "stroke = { " + look));
      const Image all = picture(diamond(bounces, "stroke = { dashes = [1e6, 1], " + look));
      EXPECT_TRUE(has_content(once));
      EXPECT_EQ(once.pixels, all.pixels) << look << ' ' << bounces;
    }
}

}  // namespace
}  // namespace flatray
