// needs: shapes/circle shapes/polygon shapes/convex shapes/segment
// Pairs of scenes that must give the same bytes (stiff case E11).
#include <gtest/gtest.h>

#include "support/pictures.h"

namespace flatray {
namespace {

// Coordinates are multiples of 1/16 and a pixel is 1/4: film coordinates are exact, and so is a
// mirror.
std::string scene(const std::string& world, const std::string& body) {
  return "flatray = 1\nfilm = { size = [128, 96], world = " + world + " }\n" + body;
}
const std::string kWorld = "[[-16, -12], [16, 12]]";

const std::string kStar = R"(
[[entity]]
shape = { polygon = { points = [[1.0625, 8.5], [-5, -7.3125], [9.75, 2.625], [-7.5, 2.5], [6.25, -6.9375]], fill_rule = "even-odd" } }
fill = "#c8553d"
)";
const std::string kStarMirrored = R"(
[[entity]]
shape = { polygon = { points = [[-1.0625, 8.5], [5, -7.3125], [-9.75, 2.625], [7.5, 2.5], [-6.25, -6.9375]], fill_rule = "even-odd" } }
fill = "#c8553d"
)";
const std::string kDisc = R"(
[[entity]]
shape = { circle = { centre = [-9.3125, -4.0625], radius = 3.4375 } }
fill = "#2f5fb380"
stroke = { width = 0.75, colour = "#143c1f" }
)";
const std::string kDiscMirrored = R"(
[[entity]]
shape = { circle = { centre = [9.3125, -4.0625], radius = 3.4375 } }
fill = "#2f5fb380"
stroke = { width = 0.75, colour = "#143c1f" }
)";

Image mirrored(const Image& image) {
  Image out(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(image.at(image.width - 1 - x, y), image.channels, out.at(x, y));
  return out;
}

Image shifted(const Image& image, int right, int down) {
  Image out(image.width, image.height, image.channels);
  std::copy(image.pixels.begin(), image.pixels.end(), out.pixels.begin());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int from_x = std::clamp(x - right, 0, image.width - 1);
      const int from_y = std::clamp(y - down, 0, image.height - 1);
      std::copy_n(image.at(from_x, from_y), image.channels, out.at(x, y));
    }
  return out;
}

TEST(StiffCases, E11MirroredSceneGivesTheMirroredPicture) {
  const Image image = picture(scene(kWorld, kStar + kDisc));
  EXPECT_TRUE(has_content(image));
  EXPECT_EQ(picture(scene(kWorld, kStarMirrored + kDiscMirrored)), mirrored(image));
}

TEST(StiffCases, E11ShiftByWholePixelsShiftsThePicture) {
  const Image image = picture(scene(kWorld, kStar + kDisc));
  const Image moved = picture(scene("[[-17.25, -11.25], [14.75, 12.75]]", kStar + kDisc));
  EXPECT_TRUE(has_content(image));
  EXPECT_EQ(moved, shifted(image, 5, 3));
}

TEST(StiffCases, E11FactorOfTwoOnSceneAndCameraChangesNothing) {
  const std::string shape = R"(
[[entity]]
shape = { polygon = { points = [[0.1, 0.2], [5.3, 1.1], [4.7, 7.9], [-3.3, 6.1]] } }
stroke = { width = 0.3, colour = "#123456" }
fill = "#c8553d"
)";
  const std::string doubled = R"(
[[entity]]
shape = { polygon = { points = [[0.2, 0.4], [10.6, 2.2], [9.4, 15.8], [-6.6, 12.2]] } }
stroke = { width = 0.6, colour = "#123456" }
fill = "#c8553d"
)";
  const Image image = picture(scene("[[-8, -6], [8, 6]]", shape));
  EXPECT_TRUE(has_content(image));
  EXPECT_EQ(picture(scene("[[-16, -12], [16, 12]]", doubled)), image);
}

TEST(StiffCases, E11OrderOfObjectsApartDoesNotMatter) {
  const std::string star = R"(
[[entity]]
shape = { polygon = { points = [[1.1, 8.5], [2.3, 1.1], [9.7, 2.6]] } }
fill = "#c8553d"
)";
  EXPECT_EQ(picture(scene(kWorld, star + kDisc)), picture(scene(kWorld, kDisc + star)));
}

TEST(StiffCases, E11WallCutInTwoAtADyadicMidpointIsTheSameWall) {
  const std::string whole = R"(
[[entity]]
shape = { polygon = { points = [[-9.5, -7.25], [8.5, -3.25], [2.75, 9.5]] } }
fill = "#2c7a3f"
)";
  const std::string cut = R"(
[[entity]]
shape = { polygon = { points = [[-9.5, -7.25], [-0.5, -5.25], [8.5, -3.25], [2.75, 9.5]] } }
fill = "#2c7a3f"
)";
  const Image image = picture(scene(kWorld, whole));
  EXPECT_TRUE(has_content(image));
  EXPECT_EQ(picture(scene(kWorld, cut)), image);
}

TEST(StiffCases, E11ObjectOutsideTheViewChangesNothing) {
  const std::string outside = R"(
[[entity]]
shape = { polygon = { points = [[100, 100], [1e6, 101], [105, 4e5]] } }
fill = "#000000"
stroke = { width = 1, colour = "#ffffff" }
)";
  EXPECT_EQ(picture(scene(kWorld, kStar + outside)), picture(scene(kWorld, kStar)));
}

TEST(StiffCases, E11AnyNumberOfThreadsAndAnyCropGivesTheSameBytes) {
  const std::string text =
      "flatray = 1\nfilm = { size = [700, 300], world = " + kWorld + " }\n" + kStar + kDisc;
  const Image image = picture(text);
  EXPECT_TRUE(has_content(image));
  for (const unsigned threads : {2U, 3U, 7U, 16U, 64U})
    EXPECT_EQ(picture(text, 1, {std::nullopt, threads}), image) << threads << " threads";
  const PixelBox box{211, 97, 173, 101};
  const Image part = picture(text, 1, {box, 2});
  ASSERT_EQ(part.width, box.width);
  ASSERT_EQ(part.height, box.height);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x)
      ASSERT_TRUE(std::equal(part.at(x, y), part.at(x, y) + 3, image.at(box.x + x, box.y + y)))
          << x << ", " << y;
}

TEST(StiffCases, E1EmptySceneIsBackgroundOnly) {
  const Image image = picture("flatray = 1\nfilm = { size = [9, 7], background = \"#102030\" }\n");
  ASSERT_EQ(image.pixels.size(), 9U * 7 * 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    EXPECT_EQ(image.pixels[i], 0x10);
    EXPECT_EQ(image.pixels[i + 1], 0x20);
    EXPECT_EQ(image.pixels[i + 2], 0x30);
  }
}

// Found by a hostile scene: film coordinates overflowed into the rationals.
TEST(Film, CoordinatesBeyondTheDoublesAreDrawnAsFarAsDoublesGo) {
  const Image image = picture(R"(flatray = 1
film = { size = [8, 8], world = [[0, 0], [1e-300, 1e-300]] }
[[entity]]
shape = { convex = { points = [[0, 0], [1e300, 0], [1e300, 1e300], [0, 1e300]] } }
fill = "#ff0000"
stroke = { width = 1e300, colour = "#00ff00" }
[[entity]]
shape = { circle = { radius = 1e308 } }
fill = "#0000ff"
velocity = [1e300, -1e300]
)");
  ASSERT_EQ(image.pixels.size(), 8U * 8 * 3);
  EXPECT_EQ(image.at(4, 4)[2], 0xff);  // the disc lies over the rest
}

TEST(EdgeRays, PiecesThatShareAnEdgeAreOneInside) {
  // An arrow of two convex pieces; the level ray passes through both.
  const std::string text = R"(flatray = 1
film = { size = [96, 64], world = [[0, 0], [24, 16]] }
[[entity]]
name = "arrow"
shape = { polygon = { points = [[4, 6], [12, 6], [12, 3], [20, 8], [12, 13], [12, 10], [4, 10]] } }
fill = "#ffffff"
[[entity]]
name = "ray"
shape = { segment = { from = [1, 8], to = [23, 8] } }
stroke = { width = 0.01, colour = "#ffffff" }
[[edge_rays]]
from = "ray"
against = "arrow"
stroke = { width = 0.25, colour = "#000000" }
inside = "#0000ff"
enter = "#00ff00"
exit = "#ff0000"
)";
  const Image image = picture(text);
  const auto count = [&](std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    int pixels = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3)
      pixels +=
          image.pixels[i] == r && image.pixels[i + 1] == g && image.pixels[i + 2] == b ? 1 : 0;
    return pixels;
  };
  EXPECT_GT(count(0, 0, 255), 0);
  // One disc of radius 4 * 0.5 px each: an entering and an exiting one, none where the pieces meet.
  EXPECT_GT(count(0, 255, 0), 0);
  EXPECT_LT(count(0, 255, 0), 13);
  EXPECT_EQ(count(0, 255, 0), count(255, 0, 0));
}

}  // namespace
}  // namespace flatray
