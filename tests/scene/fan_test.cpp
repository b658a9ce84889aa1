#include <gtest/gtest.h>

#include "scene_text.h"

namespace flatray {
namespace {

std::string with_ray(const std::string& more) {
  return "flatray = 1\n[[ray]]\nname = \"r\"\nat = [1, 2]\ndirection = [2, 0]\nbounces = 3\n" +
         more;
}

TEST(Fans, AreRaysOneByOne) {
  const Scene scene = loaded(with_ray("fan = { count = 3, spread = 180 }")).scene;
  ASSERT_EQ(scene.rays.size(), 3U);
  EXPECT_EQ(scene.rays[0].direction, Vec2(0, -2));
  EXPECT_EQ(scene.rays[1].direction, Vec2(2, 0));
  EXPECT_EQ(scene.rays[2].direction, Vec2(0, 2));
  for (const RayPath& ray : scene.rays) {
    EXPECT_EQ(ray.at, Vec2(1, 2));
    EXPECT_EQ(ray.bounces, 3U);
    EXPECT_FALSE(ray.fan);
  }
  EXPECT_EQ(scene.rays[2].name, "r 3");
}

TEST(Fans, OfAWidthStandSideBySide) {
  const Scene scene = loaded(with_ray("fan = { count = 2, width = 1 }")).scene;
  ASSERT_EQ(scene.rays.size(), 2U);
  EXPECT_EQ(scene.rays[0].at, Vec2(1, 1.5));
  EXPECT_EQ(scene.rays[1].at, Vec2(1, 2.5));
  EXPECT_EQ(scene.rays[0].direction, scene.rays[1].direction);
}

TEST(Fans, OfOneAreTheRay) {
  const Scene scene = loaded(with_ray("fan = { count = 1, spread = 90, width = 1 }")).scene;
  ASSERT_EQ(scene.rays.size(), 1U);
  EXPECT_EQ(scene.rays[0].at, Vec2(1, 2));
  EXPECT_EQ(scene.rays[0].direction, Vec2(2, 0));
  EXPECT_EQ(scene.rays[0].name, "r");
}

TEST(Balls, MoveAndHaveTheLinesColour) {
  const Scene scene = loaded(with_ray("stroke = { width = 1, colour = \"#010203\" }\n"
                                      "ball = { speed = 2, radius = 0.5 }"))
                          .scene;
  ASSERT_TRUE(scene.rays[0].ball);
  EXPECT_EQ(scene.rays[0].ball->colour, (Colour{1, 2, 3, 255}));
  const std::vector<Refused> cases = {
      {with_ray("ball = { speed = 0, radius = 1 }"), "must be above 0"},
      {with_ray("ball = { radius = 1 }"), "ray.ball needs 'speed'"},
      {with_ray("fan = { count = 0 }"), "ray.fan.count"},
      {with_ray("fan = { spread = 3 }"), "ray.fan needs 'count'"}};
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

}  // namespace
}  // namespace flatray
