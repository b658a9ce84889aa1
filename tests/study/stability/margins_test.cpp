// needs: shapes/box shapes/circle shapes/ellipse
#include "study/stability/margins.h"

#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace flatray {
namespace {

std::vector<Margin> of(const std::string& ray) {
  const LoadedScene scene = loaded(
      "flatray = 1\nfilm = { size = [24, 16], world = [[0, 0], [24, 16]] }\n"
      "[[entity]]\nname = \"wall\"\nmaterial = \"mirror\"\n"
      "shape = { box = { min = [10, 2], max = [12, 8] } }\n"
      "[[entity]]\nname = \"disc\"\nmaterial = \"mirror\"\n"
      "shape = { circle = { centre = [5, 12], radius = 2 } }\n" +
      ray);
  return margins(scene.scene, 1, 100);
}

std::string ray(double y, double dy) {
  return "[[ray]]\nname = \"r\"\nat = [0, " + std::to_string(y) + "]\ndirection = [1, " +
         std::to_string(dy) + "]\nbounces = 1\n";
}

TEST(Margins, AreDistancesFromTheNearestEndOfAWall) {
  const auto all = of(ray(7.75, 0));
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].distance, 0.25);
  EXPECT_EQ(all[0].at, Vec2(10, 8));
  EXPECT_EQ(all[0].ulps, 0.25 / (14 * 0x1p-52));
  EXPECT_EQ(all[0].wall.substr(0, 4), "wall");
}

TEST(Margins, OfATangentAreWhatItMissesTheCircleBy) {
  for (const double y : {9.875, 10.125}) {  // past it, and into it
    const auto all = of(ray(y, 0));
    ASSERT_FALSE(all.empty());
    EXPECT_NEAR(all[0].distance, 0.125, 1e-14);
    EXPECT_EQ(all[0].wall, "disc");
  }
}

TEST(Margins, AreNothingWhereAnEndIsMetExactly) {
  EXPECT_EQ(of(ray(8, 0))[0].distance, 0);
  EXPECT_EQ(of(ray(-2, 1))[0].distance, 0);  // (10, 8) too
}

// A flat way into the upper side, whose corner lies past the foot on the way.
TEST(Margins, SeeAnEndBeyondWhereTheWallIsMet) {
  for (const std::string material : {"mirror", "absorb"}) {
    const LoadedScene scene = loaded(
        "flatray = 1\nfilm = { size = [100, 100], world = [[0, 0], [100, 100]] }\n"
        "[[entity]]\nname = \"plate\"\nmaterial = \"" +
        material +
        "\"\nshape = { box = { min = [20, 20], max = [50, 80] } }\n"
        "[[ray]]\nname = \"r\"\nat = [40, 90]\ndirection = [9.999999999, -10]\nbounces = 0\n");
    const auto all = margins(scene.scene, 1, 100);
    ASSERT_EQ(all.size(), 1U) << material;
    EXPECT_EQ(all[0].at, Vec2(50, 80));
    EXPECT_NEAR(all[0].distance, 7.07e-10, 1e-12);
  }
}

TEST(Margins, OfATangentOfAnEllipseAreWhatItMissesTheEllipseBy) {
  for (const double y : {9.875, 10.125}) {
    const LoadedScene scene = loaded(
        "flatray = 1\nfilm = { size = [24, 16], world = [[0, 0], [24, 16]] }\n"
        "[[entity]]\nname = \"disc\"\nmaterial = \"mirror\"\n"
        "shape = { ellipse = { centre = [9, 12], radii = [4, 2] } }\n" +
        ray(y, 0));
    const auto all = margins(scene.scene, 1, 100);
    ASSERT_FALSE(all.empty());
    EXPECT_NEAR(all[0].distance, 0.125, 1e-14);
    EXPECT_EQ(all[0].at, Vec2(9, 12));
  }
}

TEST(Margins, OfASceneWithoutRaysAreOfRandomOnes) {
  const auto all = of("");
  EXPECT_GT(all.size(), 10U);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1].distance, all[i].distance);
}

}  // namespace
}  // namespace flatray
