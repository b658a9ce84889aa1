// needs: shapes/box shapes/circle shapes/segment lamps/point lamps/beam passes/orbits passes/light passes/entities formats/toml
// Rays that move, turn, follow and are copied; and what of rays and lamps is not seen.
#include "anim/motion.h"
#include "anim/rays.h"
#include "render/coverage/unseen.h"
#include "support/pictures.h"

namespace flatray {
namespace {

Scene with_ray(const std::string& keys, const std::string& rest = "") {
  return scene_of(
      "flatray = 1\nfps = 1\nframes = 9\nfilm = { size = [40, 40], world = [[0, 0], [10, 10]] }\n" +
      rest + "[[ray]]\nname = \"r\"\n" + keys);
}

void expect_ray(const RayState& ray, const Vec2& from, const Vec2& direction) {
  EXPECT_EQ(ray.start.origin, from);
  EXPECT_EQ(ray.start.direction, direction);
}

TEST(MovingRays, TurnByTheirAngleAndAsTimeGoesBy) {
  const Scene scene =
      with_ray("at = [1, 2]\ndirection = [2, 0]\nangle = 90\nangular_velocity = 90\n");
  const Vec2 expected[] = {{0, 2}, {-2, 0}, {0, -2}, {2, 0}};
  for (int second = 0; second < 4; ++second)
    expect_ray(ray_states(scene, second).at(0), {1, 2}, expected[second]);
  EXPECT_EQ(reason_to_move(scene), "ray 'r' moves");
}

TEST(MovingRays, FollowCurvesOfPlaceDirectionWidthAndOpacity) {
  const Scene scene = with_ray(
      "at = { keys = [[0, [0, 0]], [2, [4, 8]]] }\n"
      "direction = [{ keys = [[0, 1], [2, 0], [4, -1]] }, { keys = [[0, 0], [2, 0], [4, 3]] }]\n"
      "velocity = [0, 1]\nopacity = { keys = [[0, 1], [2, 0]] }\n"
      "stroke = { width = { keys = [[0, 2], [2, 4]] } }\n");
  const RayState ray = ray_states(scene, 1).at(0);
  expect_ray(ray, {2, 5}, {0.5, 0});
  EXPECT_EQ(ray.opacity, 0.5);
  EXPECT_EQ(ray.stroke.width, 3);
  EXPECT_TRUE(ray_states(scene, 2).empty());  // it has no direction then
  expect_ray(ray_states(scene, 3).at(0), {4, 11}, {-0.5, 1.5});
}

TEST(MovingRays, StandInGroupsAndFollowPaths) {
  const Scene scene =
      with_ray("group = 'g'\nat = [1, 0]\ndirection = [1, 1]\n",
               "[[group]]\nname = 'g'\nat = [5, 5]\nangle = 90\nscale = 2\nvelocity = [1, 0]\n");
  const RayState ray = ray_states(scene, 1).at(0);
  expect_ray(ray, {6, 7}, {-1, 1});
  EXPECT_EQ(ray.stroke.scale, 2);
  EXPECT_EQ(reason_to_move(scene), "group 'g' moves");
  const Scene walks = with_ray(
      "at = [1, 1]\ndirection = [1, 0]\nfollow = { path = [[0, 0], [4, 0], [4, 4]], speed = 2, "
      "turn "
      "= true }\n");
  expect_ray(ray_states(walks, 1).at(0), {3, 1}, {1, 0});
  expect_ray(ray_states(walks, 3).at(0), {5, 3}, {0, 1});
}

TEST(MovingRays, OfAFanAreTurnedAndPutSideBySide) {
  const std::string ray = "at = [1, 2]\ndirection = [2, 0]\n";
  const auto turned = ray_states(with_ray(ray + "fan = { count = 3, spread = 180 }"), 0);
  ASSERT_EQ(turned.size(), 3U);
  expect_ray(turned[0], {1, 2}, {0, -2});
  expect_ray(turned[1], {1, 2}, {2, 0});
  expect_ray(turned[2], {1, 2}, {0, 2});
  const Scene wide =
      with_ray(ray + "angle = 90\nfan = { count = 2, width = { keys = [[0, 1], [1, 3]] } }");
  expect_ray(ray_states(wide, 0).at(0), {1.5, 2}, {0, 2});
  expect_ray(ray_states(wide, 1).at(1), {-0.5, 2}, {0, 2});
}

TEST(MovingRays, AreCopiedWithDrawsOfTheirOwn) {
  const Scene scene = with_ray(
      "at = [0, 0]\ndirection = [1, { uniform = [0, 1] }]\nrepeat = { grid = { count = [3, 1], "
      "step "
      "= [2, 0] } }\n");
  const auto rays = ray_states(scene, 0);
  ASSERT_EQ(rays.size(), 3U);
  EXPECT_EQ(scene.rays[2].name, "r.2");
  EXPECT_EQ(rays[2].start.origin, Vec2(4, 0));
  EXPECT_NE(rays[0].start.direction, rays[1].start.direction);
  EXPECT_LT(scene.rays[0].order, scene.rays[1].order);
}

// Row 19 of 40 is lit where the ray flies: from (2, 5) to the wall at x = 9.
TEST(MovingRays, FlyOnceMoreAfterTheLastBounce) {
  const auto lit = [](const std::string& keys) {
    const Scene scene = with_ray("at = [2, 5]\n" + keys,
                                 "[[chamber]]\nshape = { box = { min = [1, 1], max = [9, 9] } }\n"
                                 "stroke = 'none'\n");
    const Image image = picture(scene);
    const auto dark = [&](int x, int y) {
      return image.pixels[static_cast<std::size_t>(image.channels * (40 * y + x)) + 1] < 200;
    };
    return std::pair(dark(30, 20) || dark(30, 19), dark(6, 20) || dark(6, 19));
  };
  EXPECT_EQ(lit("direction = [1, 0]\n"), std::pair(true, false));
  EXPECT_EQ(lit("direction = [1, 0]\nbounces = 1\n"), std::pair(true, true));
}

std::vector<std::string> told(const std::string& text) {
  std::vector<std::string> messages;
  for (const Diagnostic& one : unseen_in(
           scene_of("flatray = 1\nfilm = { size = [40, 40], world = [[0, 0], [10, 10]] }\n" + text),
           0))
    messages.push_back(one.message);
  return messages;
}

TEST(Unseen, RaysThatStartWhereWallsMeetAreTold) {
  const std::string room = "[[chamber]]\nshape = { box = { min = [1, 1], max = [9, 9] } }\n";
  const auto ray = [&](const std::string& keys) {
    return told(room + "[[ray]]\nname = 'r'\n" + keys);
  };
  EXPECT_TRUE(ray("at = [2, 2]\ndirection = [1, 0]\n").empty());
  ASSERT_EQ(ray("at = [1, 1]\ndirection = [1, 1]\n").size(), 1U);
  EXPECT_NE(ray("at = [1, 1]\ndirection = [1, 1]\n")[0].find("where walls meet"),
            std::string::npos);
  EXPECT_NE(ray("at = [2, 1]\ndirection = [1, 0]\n").at(0).find("runs along"), std::string::npos);
}

TEST(Unseen, LampsInWallsAreTold) {
  const auto lamp = [](const std::string& body) {
    return told("[[entity]]\nname = 'b'\nshape = { circle = { radius = 2 } }\nat = [5, 5]\n" +
                body + "\n[[lamp]]\nname = 'l'\nsource = { point = {} }\nat = [5, 5]\n");
  };
  EXPECT_TRUE(lamp("").empty());
  EXPECT_TRUE(lamp("material = 'mirror'\nfill = 'none'").empty());
  EXPECT_TRUE(lamp("material = 'mirror'\nlayer = -2").empty());
  EXPECT_NE(lamp("material = 'absorb'\nfill = 'none'").at(0).find("entity 'b', which absorbs"),
            std::string::npos);
  EXPECT_NE(lamp("material = 'mirror'").at(0).find("whose fill covers"), std::string::npos);
  const auto outside = told(
      "[[chamber]]\nshape = { box = { min = [1, 1], max = [4, 9] } }\n[[lamp]]\nsource = { point "
      "= {} }\nat = [5, 5]\n");
  EXPECT_NE(outside.at(0).find("outside the chamber"), std::string::npos);
}

TEST(Unseen, LightThatDoesNotComeToTheFilmIsTold) {
  const auto beam = [](const std::string& angle) {
    return told("[[lamp]]\nsource = { beam = { width = 1 } }\nat = [12, 5]\nangle = " + angle +
                "\n");
  };
  EXPECT_TRUE(beam("180").empty());
  EXPECT_NE(beam("0").at(0).find("no light is seen in frame 1"), std::string::npos);
}

// However small a part of the room is shown: a few rays from the lamp do not come there.
TEST(Unseen, LightIsFoundInSmallViews) {
  const auto told = [](double width, const std::string& material, const std::string& more,
                       std::uint64_t seed) {
    return unseen_in(
        scene_of(fmt::format("flatray = 1\nfilm = {{ size = [6, 4], world = [[0, 0], [{}, {}]] }}\n"
                             "[[lamp]]\nsource = {{ point = {{}} }}\nat = [5, 5]\n[[chamber]]\n"
                             "shape = {{ box = {{ min = [-6, -6], max = [6, 6] }} }}\n"
                             "material = {}\n{}",
                             width, width * 2 / 3, material, more)),
        seed);
  };
  const std::string diffuse = "{ diffuse = { reflectance = 0.6 } }";
  for (const double width : {0.1, 0.01, 0.003, 0.001, 1e-5})
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      EXPECT_TRUE(told(width, diffuse, "", seed).empty()) << width;
      EXPECT_TRUE(told(width, "\"mirror\"", "", seed).empty()) << width;
      const Diagnostics dark =
          told(width, diffuse,
               "[[entity]]\nshape = { box = { min = [-1, -1], max = [1, 1] } }\n"
               "material = \"absorb\"\nfill = \"none\"\n",
               seed);
      ASSERT_EQ(dark.size(), 1U) << width;
      EXPECT_NE(dark.front().message.find("no light is seen"), std::string::npos);
    }
}

TEST(Unseen, OfFilmsThatAreVeryTallIsAskedToo) {
  for (const int height : {2048, 2049, 65535})
    EXPECT_TRUE(unseen_in(scene_of(fmt::format(
                              "flatray = 1\nfilm = {{ size = [1, {}], world = [[0, 0], [1, "
                              "{}]] }}\n[[lamp]]\nsource = {{ point = {{}} }}\nat = [0.5, 0.25]\n",
                              height, height)),
                          0)
                    .empty());
}

}  // namespace
}  // namespace flatray
