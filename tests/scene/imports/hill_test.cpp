// needs: formats/hill shapes/convex
#include <gtest/gtest.h>

#include "scene/load.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

constexpr const char* kRoom = "2\n4 1 0 0.5\n0 0\n8 0\n8 6\n0 6\n\n3 0 1 0\n1 1 2 1 1 2\n";

Result<LoadedScene> room(std::string text) {
  return load_scene_text("room.chamber", std::move(text));
}

TEST(HillFormat, TheFirstPillarIsTheChamber) {
  const auto loaded = room(kRoom);
  ASSERT_TRUE(loaded) << format(loaded.error());
  const Scene& scene = loaded->scene;
  ASSERT_EQ(scene.chambers.size(), 1U);
  const Chamber& chamber = scene.chambers[0];
  EXPECT_EQ(scene.shapes[chamber.shape].vertices.size(), 4U);
  EXPECT_EQ(chamber.stroke->colour, (Colour{255, 0, 128, 255}));
  ASSERT_EQ(chamber.pillars.size(), 1U);
  EXPECT_EQ(chamber.pillars[0].name, "pillar 1");
  EXPECT_EQ(*chamber.pillars[0].fill, (Colour{0, 255, 0, 255}));
  EXPECT_EQ(scene.shapes[chamber.pillars[0].shape].vertices[1], Vec2(2, 1));
  ASSERT_EQ(scene.rays.size(), 1U);
  EXPECT_EQ(scene.rays[0].at, Vec2(4, 3));  // the mean of the chamber's corners
}

TEST(HillFormat, MistakesAreToldWhereTheyStand) {
  const auto refusal_of = [](std::string text) {
    const auto loaded = room(std::move(text));
    return loaded ? std::string() : format(loaded.error());
  };
  EXPECT_NE(refusal_of("1\n2 0 0 0\n").find("room.chamber:2:1: error: sides must be"),
            std::string::npos);
  EXPECT_NE(refusal_of("1\n3 0 2 0\n0 0 1 0 0 1").find("green must be from 0 to 1"),
            std::string::npos);
  EXPECT_NE(refusal_of("1\n3 0 0 0\n0 0 1 zero 0 1").find("'zero' is not a finite number"),
            std::string::npos);
  EXPECT_NE(refusal_of("1\n3 0 0 0\n0 0 1 0 0").find("the file ends where y should stand"),
            std::string::npos);
  EXPECT_NE(refusal_of("1\n3 0 0 0\n0 0 1 0 0 1\n7").find("more than the pillars announced"),
            std::string::npos);
  EXPECT_NE(refusal_of("1\n4 0 0 0\n0 0 2 0 1 1 1 2").find("convex"), std::string::npos);
}

TEST(HillFormat, LimitsNameTheirOptions) {
  LoadLimits limits;
  limits.max_entities = 1;
  const auto pillars = load_scene_text("room.chamber", kRoom, {}, limits);
  ASSERT_FALSE(pillars);
  EXPECT_NE(format(pillars.error()).find("--max-entities raises the limit"), std::string::npos);
  limits = {};
  limits.max_corners = 3;
  const auto sides = load_scene_text("room.chamber", kRoom, {}, limits);
  ASSERT_FALSE(sides);
  EXPECT_NE(format(sides.error()).find("sides: more than 3"), std::string::npos);
  EXPECT_NE(format(sides.error()).find("--max-corners raises the limit"), std::string::npos);
}

TEST(HillFormat, AnyStartOfAFileIsReadOrRefused) {
  const std::string text = kRoom;
  for (std::size_t size = 0; size < text.size(); ++size) (void)room(text.substr(0, size));
}

}  // namespace
}  // namespace flatray
