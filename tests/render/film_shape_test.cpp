// needs: formats/toml shapes/sector shapes/segment
#include "support/pictures.h"

namespace flatray {
namespace {

// The middle of the ring lies 30 px right of the centre, where a seam at 0 degrees would be.
TEST(FilmShape, AWholeSectorHasNoSeam) {
  for (const char* inner : {"20", "0"}) {
    const Image image =
        picture(std::string("flatray = 1\n"
                            "film = { size = [101, 101], world = [[-50.5, -50.5], [50.5, 50.5]] }\n"
                            "[[entity]]\nfill = \"#336699\"\n"
                            "stroke = { width = 4, colour = \"#ff0000\" }\n"
                            "shape = { sector = { radius = 40, from = 0, to = 360, inner = ") +
                inner + " } }\n");
    const std::size_t pixel = (50 * 101 + 80) * 3;
    EXPECT_EQ(image.pixels[pixel], 0x33) << inner;
    EXPECT_EQ(image.pixels[pixel + 3 * 10], 0xff) << inner;
  }
}

// What a level line of 16 pixels by 2 is on the film, drawn with dashes and gaps of these lengths.
double dashed_area(double length) {
  const std::string text = std::to_string(length);
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [20, 20], world = [[0, 0], [20, 20]] }\n[[entity]]\n"
      "shape = { segment = { from = [2, 10], to = [18, 10] } }\n"
      "stroke = { width = 2, caps = 'butt', dashes = [" +
      text + ", " + text + "] }\n");
  const DrawList list = *draw_list(make_plan(scene, false), Timeline(scene, 0, 1), 1);
  double twice = 0;
  for (const DrawItem& item : list.items)
    if (const auto* path = std::get_if<FillPath>(&item.region))
      for (const Segment& edge : path->edges) twice += cross(edge.a, edge.b);
  return std::abs(0.5 * twice);
}

TEST(FilmShape, DashesAreDrawnUnlessTheyRepeatWithinAQuarterOfAPixel) {
  for (const double length : {2.0, 0.5, 0.125}) EXPECT_NEAR(dashed_area(length), 16, 1e-9);
  EXPECT_NEAR(dashed_area(0.0625), 32, 1e-9);
}

TEST(FilmShape, AHoleThatIsAPointHasNoLine) {
  const Image image = picture(
      "flatray = 1\nfilm = { size = [40, 40], world = [[-10, -10], [10, 10]] }\n[[entity]]\n"
      "shape = { sector = { radius = 8, from = 0, to = 360, inner = 0 } }\n"
      "stroke = { width = 2 }\nfill = 'none'\n");
  EXPECT_EQ(image.at(20, 20)[0], 0xff);
  EXPECT_LT(image.at(36, 20)[0], 0xff);
}

// An ellipse of two equal radii is the same curve.
TEST(FilmShape, DashesOfACircleTurnWithIt) {
  const auto turned = [](const std::string& shape, int angle) {
    return picture(
        "flatray = 1\nfilm = { size = [20, 20], world = [[-10, -10], [10, 10]] }\n[[entity]]\n"
        "shape = { " +
        shape + " }\nangle = " + std::to_string(angle) +
        "\nstroke = { width = 1, caps = 'butt', dashes = [5, 4] }\n");
  };
  const std::string circle = "circle = { radius = 7 }", ellipse = "ellipse = { radii = [7, 7] }";
  for (const int angle : {0, 90, 180, 270})
    EXPECT_EQ(turned(circle, angle), turned(ellipse, angle)) << angle;
  EXPECT_NE(turned(circle, 0), turned(circle, 90));
}

}  // namespace
}  // namespace flatray
