#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string with_ray(const std::string& more) {
  return "flatray = 1\n[[ray]]\nname = \"r\"\nat = [1, 2]\ndirection = [2, 0]\nbounces = 3\n" +
         more;
}

TEST(Fans, AreRaysOneByOne) {
  const Scene scene = loaded(with_ray("fan = { count = 3, spread = 180 }")).scene;
  ASSERT_EQ(scene.rays.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const RayPath& ray = scene.rays[i];
    EXPECT_EQ(ray.at, Vec2(1, 2));
    EXPECT_EQ(ray.bounces, 3U);
    EXPECT_EQ(ray.fan->place, 0.5 * static_cast<double>(i) - 0.5);
    EXPECT_EQ(ray.written_name, "r");
  }
  EXPECT_EQ(scene.rays[2].name, "r 3");
}

TEST(Rays, ThatAreSeenInNoFrameAreWarnedOf) {
  const auto warning = [](const std::string& more) {
    const Diagnostics warnings = loaded(with_ray(more)).warnings;
    return warnings.empty() ? std::string() : warnings.front().message;
  };
  EXPECT_EQ(warning(""), "");
  EXPECT_EQ(warning("opacity = 0"), "the ray draws nothing: its opacity is 0");
  EXPECT_EQ(warning("opacity = { keys = [[0, 0], [1, 1]] }"), "");
  const std::string clear = "stroke = { colour = \"#00000000\" }\n";
  EXPECT_EQ(warning(clear), "the ray draws nothing: its stroke is clear");
  EXPECT_EQ(warning(clear + "numbers = \"#ff0000\""), "");
}

TEST(Fans, OfOneAreTheRay) {
  const Scene scene = loaded(with_ray("fan = { count = 1, spread = 90, width = 1 }")).scene;
  ASSERT_EQ(scene.rays.size(), 1U);
  EXPECT_EQ(scene.rays[0].at, Vec2(1, 2));
  EXPECT_EQ(scene.rays[0].direction.value, Vec2(2, 0));
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
      {with_ray("opacity = { keys = [[0, 0], [1, 2]] }"),
       "ray.opacity does not lie between 0 and 1"},
      {with_ray("end_colour = \"#000000\"\nstroke = { colour = { keys = [[0, \"#ff0000\"]] } }"),
       "the colour of the ray is a curve, and it has an end_colour"},
      {with_ray("fan = { spread = 3 }"), "ray.fan needs 'count'"}};
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

}  // namespace
}  // namespace flatray
