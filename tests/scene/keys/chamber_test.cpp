// needs: shapes/box shapes/circle shapes/mushroom
#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string chamber(const std::string& shape) {
  return "flatray = 1\n[[chamber]]\nmaterial = \"periodic\"\nshape = { " + shape + " }\n";
}

TEST(PeriodicChambers, AreUprightBoxes) {
  EXPECT_EQ(loaded(chamber("box = { min = [0, 0], max = [2, 1] }")).scene.chambers.front().material,
            Material::periodic);
  EXPECT_NE(refusal(chamber("circle = { radius = 1 }"))
                .find("t.toml:4:9: error: walls that are not an upright box cannot be periodic"),
            std::string::npos);
}

TEST(Mushrooms, HaveAStemNarrowerThanTheirCap) {
  EXPECT_NE(refusal(with_shape("mushroom = { radius = 1, width = 2, height = 1 }"))
                .find("the stem is as wide as the cap"),
            std::string::npos);
}

}  // namespace
}  // namespace flatray
