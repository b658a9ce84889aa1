// needs: shapes/box shapes/circle shapes/mushroom
#include <gtest/gtest.h>

#include <numbers>

#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string chamber(const std::string& shape) {
  return "flatray = 1\n[[chamber]]\nmaterial = \"periodic\"\nshape = { " + shape + " }\n";
}

TEST(PeriodicChambers, AreCellsThatFillThePlane) {
  for (const char* cell :
       {"box = { min = [0, 0], max = [2, 1] }", "cell = { a = [1.1, 0.2], b = [0.3, 0.7] }",
        "cell = { a = [2.1, 0], b = [1.05, 1.818653347947321], sides = 6 }",
        "cell = { a = [1e-300, 0], b = [0.5e-300, 0.8e-300], sides = 6 }",
        "cell = { a = [1e200, 0], b = [0.5e200, 0.8e200], sides = 6 }",
        "polygon = { points = [[0, 0], [2, 0], [3, 1], [1, 1]] }"})
    EXPECT_EQ(loaded(chamber(cell)).scene.chambers.front().material, Material::periodic) << cell;
  EXPECT_NE(refusal(chamber("circle = { radius = 1 }"))
                .find("t.toml:4:9: error: walls that are not a polygon of four or six corners "
                      "cannot be periodic"),
            std::string::npos);
  EXPECT_NE(refusal(chamber("polygon = { points = [[0, 0], [2, 0], [3, 1], [1, 1.25]] }"))
                .find("the corner (1, 1.25) is (0, 0.25) off"),
            std::string::npos);
}

// By one ulp: 0.1 + 0.2 is not 0.3.
TEST(PeriodicChambers, HaveOppositeSidesThatAreTheSameExactly) {
  EXPECT_NE(refusal(chamber("polygon = { points = [[0, 0], [0.1, 0], [0.3, 1], [0.2, 1]] }"))
                .find("the corner (0.2, 1) is (2.7755575615628914e-17, 0) off"),
            std::string::npos);
}

TEST(Cells, OfSixSidesNeedAnAcuteTriangle) {
  EXPECT_NE(
      refusal(with_shape("cell = { a = [1, 0], b = [0, 1], sides = 6 }")).find("acute triangle"),
      std::string::npos);
  EXPECT_NE(refusal(with_shape("cell = { a = [1, 0], b = [1, 0] }")).find("no area"),
            std::string::npos);
}

// A disc in the corner of four cells is there four times, one across a side twice.
TEST(PeriodicChambers, HaveCopiesOfDiscsAcrossTheirWalls) {
  const auto pillars = [](const std::string& disc, const std::string& more = "") {
    return loaded(chamber("box = { min = [0, 0], max = [1, 1] }") + "pillars = [{ " + more +
                  "shape = { circle = { " + disc + " } } }]\n")
        .scene.chambers.front()
        .pillars;
  };
  EXPECT_EQ(pillars("centre = [0.5, 0.5], radius = 0.25").size(), 1U);
  EXPECT_EQ(pillars("centre = [0.25, 0.5], radius = 0.25").size(), 1U);  // touches
  const auto side = pillars("centre = [0, 0.5], radius = 0.25"), corner = pillars("radius = 0.25");
  ASSERT_EQ(side.size(), 2U);
  EXPECT_EQ(side[1].copy_of, 0U);
  ASSERT_EQ(corner.size(), 4U);
  EXPECT_FALSE(corner[0].copy_of);
  for (const Chamber::Pillar& copy : pillars("radius = 0.25", "angle = 30, "))
    EXPECT_EQ(copy.angle, copy.copy_of ? 0 : 30 / 180.0 * std::numbers::pi);
}

TEST(Holes, HaveNamesOfTheirOwn) {
  const auto two = [](const std::string& second) {
    return "flatray = 1\n[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
           "holes = [{ name = \"door\", edge = 0, from = 0.1, to = 0.2 },\n"
           "         { name = \"" +
           second + "\", edge = 1, from = 0.1, to = 0.2 }]\n";
  };
  EXPECT_NE(refusal(two("door")).find("t.toml:5:10: error: two holes are named 'door'"),
            std::string::npos)
      << refusal(two("door"));
  EXPECT_EQ(loaded(two("window")).scene.chambers.front().holes.size(), 2U);
  const auto numbered = loaded(
      "flatray = 1\n[[chamber]]\nshape = { circle = { radius = 1 } }\n"
      "holes = [{ name = \"hole 2\", from = 0.1, to = 0.2 }, { from = 0.3, to = 0.4 }]\n");
  EXPECT_EQ(numbered.scene.chambers.front().holes[1].name, "hole 3");
}

TEST(Mushrooms, HaveAStemNarrowerThanTheirCap) {
  EXPECT_NE(refusal(with_shape("mushroom = { radius = 1, width = 2, height = 1 }"))
                .find("the stem is as wide as the cap"),
            std::string::npos);
}

}  // namespace
}  // namespace flatray
