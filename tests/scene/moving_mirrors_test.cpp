// needs: shapes/box shapes/circle shapes/ellipse
#include "scene/moving_mirrors.h"

#include <gtest/gtest.h>

#include "scene_text.h"

namespace flatray {
namespace {

std::string with_mirror(const std::string& more, const std::string& speed = "speed = 2\n") {
  return "flatray = 1\n[[entity]]\nname = \"door\"\nmaterial = \"mirror\"\n" + more +
         "\n[[ray]]\nat = [0, 0]\ndirection = [1, 0]\n" + speed;
}
const std::string kBox = "shape = { box = { min = [0, 0], max = [1, 1] } }\n";

TEST(MovingMirrors, InStraightMotionAreMet) {
  const Scene scene =
      loaded(with_mirror(kBox + "velocity = [1, 0]\nat = { keys = [[0, [0, 0]], [1, [2, 0]]] }"))
          .scene;
  EXPECT_EQ(scene.rays[0].speed, 2);
  EXPECT_TRUE(refused_mirrors(scene).empty());
}

TEST(MovingMirrors, OthersAreRefusedOnlyWhereARayHasASpeed) {
  const std::string smooth = "at = { keys = [[0, [0, 0]], [1, [2, 0]]], ease = \"smooth\" }";
  const std::string ellipse = "shape = { ellipse = { radii = [1, 2] } }\n";
  const std::vector<Refused> cases = {
      {with_mirror(kBox + "angular_velocity = 3"), "mirror 'door' turns: no ray of finite speed"},
      {with_mirror(kBox + smooth), "mirror 'door' follows a smooth curve"},
      {with_mirror(kBox + "at = { keys = [[0, [0, 0]], [1, [2, 0]]], ease = \"step\" }"),
       "mirror 'door' jumps from key to key"},
      {with_mirror(kBox + "group = \"g\"\n[[group]]\nname = \"g\"\n"
                          "at = [{ keys = [[0, 0], [1, 2]], ease = \"step\" }, 0]"),
       "mirror 'door' is in a group that jumps from key to key"},
      {with_mirror(ellipse), "mirror 'door' has curves other than circles"},
      {with_mirror("shape = { circle = { radius = { keys = [[0, 1], [1, 2]] } } }"),
       "mirror 'door' changes its size"},
      {with_mirror(kBox + "group = \"g\"\n[[group]]\nname = \"g\"\nangular_velocity = 1"),
       "mirror 'door' is in a group that turns"},
      {with_mirror(kBox) + "[[chamber]]\nname = \"c\"\nmaterial = \"periodic\"\n" + kBox,
       "chamber 'c' has periodic walls"},
      {with_mirror(kBox) + "[[chamber]]\nname = \"c\"\n" + ellipse,
       "chamber 'c' has curves other than circles"}};
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
  EXPECT_NE(refusal(with_mirror(kBox + "angular_velocity = 3")).find("t.toml:2:1"),
            std::string::npos);
  EXPECT_EQ(refusal(with_mirror(kBox + "angular_velocity = 3", "")), "");
  EXPECT_EQ(refusal(with_mirror(ellipse, "")), "");
}

TEST(MovingMirrors, ABallGoesAtTheSpeedOfItsRay) {
  EXPECT_EQ(refusal(with_mirror(kBox, "speed = 2\nball = { radius = 1 }")), "");
  const std::vector<Refused> cases = {
      {with_mirror(kBox, "speed = 2\nball = { radius = 1, speed = 2 }"),
       "the ray has a speed of its own"},
      {with_mirror(kBox, "speed = 0"), "must be above 0"},
      {with_mirror(kBox, "speed = 1e300"), "must be above 0 and below 1e+300"}};
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

}  // namespace
}  // namespace flatray
