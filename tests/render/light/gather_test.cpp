// needs: shapes/arc shapes/box shapes/circle shapes/ngon shapes/segment lamps/arc lamps/beam lamps/cone lamps/point lamps/ray lamps/segment materials/diffuse materials/glass materials/isotropic materials/mirror materials/mix materials/pass passes/light passes/entities formats/toml
// Light gathered from pixels against closed forms, and against light from lamps.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/light/light_picture.h"
#include "render/lit.h"
#include "transport/light/seen_lamps.h"

namespace flatray {
namespace {

constexpr double kT15 = 2.131;  // 95 % of Student's t with 15 degrees of freedom

// A film of 16 by 16 pixels from (-4, -4) to (4, 4).
std::string seen(const std::string& rest, const std::string& light) {
  return "flatray = 1\nfilm = { size = [16, 16], world = [[-4, -4], [4, 4]] }\n[light]\n" + light +
         "\n" + rest;
}

GatheredLight gathered(const std::string& rest, const std::string& light = "rays = 65536",
                       unsigned threads = 1, std::uint64_t seed = 0) {
  const Scene scene = scene_of(seen(rest, light));
  const Timeline timeline(scene, seed, 1);
  return gather_frame_light(scene, at(timeline, 1), nullptr, seed, threads, nullptr);
}

std::vector<double> from_lamps(const std::string& rest) {
  return fluence(scene_of(seen(rest, "rays = 262144\nbounces = 50")), 2).rgb;
}

Vec2 middle(std::size_t pixel) {
  return {-3.75 + 0.5 * static_cast<double>(pixel % 16),
          3.75 - 0.5 * static_cast<double>(pixel / 16)};
}

// Mean and standard error of the red light, over the whole film.
std::array<double, 2> red(const GatheredLight& light) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < light.fluence.size(); i += 3)
    sum += light.fluence[i], squares += light.error[i] * light.error[i];
  return {sum / 256, std::sqrt(squares) / 256};
}

// Red pixels whose 95 % interval covers what lamps send; of those that both know to be lit.
double covered(const std::string& rest) {
  const GatheredLight here = gathered(rest, "rays = 131072\nbounces = 50", 2);
  const std::vector<double> there = from_lamps(rest);
  unsigned all = 0, inside = 0;
  for (std::size_t i = 0; i < there.size(); i += 3) {
    if (here.error[i] == 0) continue;
    ++all;
    inside += std::abs(here.fluence[i] - there[i]) <= kT15 * here.error[i] + 0.005 * there[i];
  }
  EXPECT_GT(all, 100U);
  const auto [mean, error] = red(here);
  double truth = 0;
  for (std::size_t i = 0; i < there.size(); i += 3) truth += there[i] / 256;
  EXPECT_NEAR(mean, truth, 4 * error + 0.003 * truth);
  return static_cast<double>(inside) / all;
}

TEST(Gather, OfAPointFallsWithTheDistance) {
  const GatheredLight light = gathered("[[lamp]]\nsource = { point = {} }\npower = 3\n");
  for (std::size_t i = 0; i < 256; ++i) {
    const double r = std::sqrt(middle(i).squaredNorm());
    if (r < 1) continue;
    const double mean = 3 / (2 * std::numbers::pi * r) * (1 + 1.0 / (24 * 4 * r * r));
    EXPECT_NEAR(light.fluence[3 * i] / mean, 1, 0.01) << i;
  }
}

TEST(Gather, OfABeamAndAConeIsTheirPowerOverTheirWidth) {
  const GatheredLight beam =
      gathered("[[lamp]]\nsource = { beam = { width = 2 } }\nat = [-3, 0]\npower = 5\n");
  EXPECT_NEAR(beam.fluence[3 * (7 * 16 + 10)], 2.5, 1e-9);
  EXPECT_EQ(beam.fluence[3 * (4 * 16 + 10)], 0);
  EXPECT_EQ(beam.fluence[3 * (7 * 16 + 1)], 0);
  const GatheredLight cone =
      gathered("[[lamp]]\nsource = { cone = { spread = 60 } }\nat = [-3.75, 0]\n");
  const double r = middle(8 * 16 + 14).x() + 3.75;
  EXPECT_NEAR(cone.fluence[3 * (8 * 16 + 14)] / (3 / (std::numbers::pi * r)), 1, 0.01);
  EXPECT_EQ(cone.fluence[3 * (0 * 16 + 2)], 0);
}

// Of a line: its radiance, power / (2 length), times the angle under which it is seen.
TEST(Gather, OfALineIsTheAngleUnderWhichItIsSeen) {
  const GatheredLight light = gathered(
      "[[lamp]]\nsource = { segment = { from = [1, -4], to = [1, 4] } }\n", "rays = 1000000");
  unsigned covered = 0, all = 0;
  for (std::size_t i = 0; i < 256; ++i) {
    const Vec2 at = middle(i);
    if (at.x() > 1) {
      EXPECT_EQ(light.fluence[3 * i], 0) << i;
      continue;
    }
    const double out = 1 - at.x();
    const double angle = std::atan((4 - at.y()) / out) + std::atan((4 + at.y()) / out);
    ++all;
    covered += std::abs(light.fluence[3 * i] - angle / 16) <= kT15 * light.error[3 * i] + 2e-4;
  }
  EXPECT_GE(covered, all * 9 / 10);
}

TEST(Gather, InAClosedMattRoomIsPowerOverLoss) {
  const GatheredLight light = gathered(
      "[[lamp]]\nsource = { arc = { radius = 2.999999, inward = true } }\n"
      "[[chamber]]\nshape = { circle = { radius = 3 } }\n"
      "material = { diffuse = { reflectance = 0.5 } }\n");
  const auto [mean, error] = red(light);
  EXPECT_NEAR(64 * mean, std::numbers::pi * 3 / 2 / 0.5, 3 * 64 * error);
  EXPECT_LT(error, 0.01 * mean);
}

constexpr const char* kRoom =
    "[[chamber]]\nshape = { box = { min = [-3.9, -3.9], max = [3.9, 3.9] } }\n"
    "material = { diffuse = { reflectance = 0.5, colour = '#ffa0a0' } }\n";

TEST(Gather, AgreesWithLampsAmongMattAndClearWalls) {
  const std::string walls = std::string(kRoom) +
                            "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [1.5, 1]\n"
                            "material = { isotropic = { reflectance = 0.8 } }\n"
                            "[[entity]]\nshape = { segment = { from = [-3, -1], to = [0, -2] } }\n"
                            "material = { mix = { pass = 0.5, diffuse = 0.2, isotropic = 0.2 } }\n";
  for (const char* lamps :
       {"[[lamp]]\nsource = { point = {} }\nat = [-2, 1]\n"
        "[[lamp]]\nsource = { cone = { spread = 90 } }\nat = [-3.9, 0]\n"
        "[[lamp]]\nsource = { beam = { width = 1 } }\nat = [-3, 3]\nangle = -60\npower = 2\n",
        "[[lamp]]\nsource = { segment = { from = [-2, 0], to = [-1, 2], both_sides = true } }\n"
        "[[lamp]]\nsource = { arc = { radius = 1, from = 10, to = 250 } }\nat = [-1, 1]\n"})
    EXPECT_GT(covered(lamps + walls), 0.9) << lamps;
}

TEST(Gather, AgreesWithLampsByMirrorsAndGlass) {
  const std::string walls =
      std::string(kRoom) +
      "[[entity]]\nshape = { segment = { from = [-3.5, -3], to = [-1, -3.7] } }\n"
      "material = 'mirror'\n"
      "[[entity]]\nshape = { circle = { radius = 3 } }\nat = [0.5, 0]\n"
      "material = { glass = { index = 1.6 } }\n"
      "[[entity]]\nshape = { box = { min = [-0.5, -0.5], max = [0.5, 0.5] } }\nat = [1.5, 1]\n"
      "material = { glass = { index = 1.2 } }\n";
  EXPECT_GT(
      covered("[[lamp]]\nsource = { segment = { from = [-3.2, -1], to = [-3.2, 3] } }\n" + walls),
      0.9);
}

// On a wall it shines to its side alone, whichever way it is followed.
// Tinted glass with a bubble in it, a lamp inside of the glass and one outside.
TEST(Gather, AgreesWithLampsWhereGlassAbsorbs) {
  const std::string tinted =
      "[[chamber]]\nshape = { box = { min = [-4, -4], max = [4, 4] } }\n"
      "material = { diffuse = { reflectance = 0.6 } }\n"
      "[[entity]]\nshape = { circle = { radius = 2.3 } }\nat = [0.4, -0.2]\n"
      "material = { glass = { index = 1.3, absorption = [0.8, 0.1, 0] } }\n"
      "[[entity]]\nshape = { circle = { radius = 0.7 } }\nat = [0.9, -0.6]\n"
      "material = { glass = { index = 1 } }\n"
      "[[lamp]]\nsource = { segment = { from = [-0.8, 0.3], to = [-0.2, 0.9] } }\n"
      "[[lamp]]\nsource = { segment = { from = [-3.5, -3], to = [-3.4, 3], both_sides = true } }\n";
  EXPECT_GT(covered(tinted), 0.9);
}

TEST(Gather, OfALampAlongAWallDoesNotGoThroughTheWall) {
  const std::string room =
      "[[entity]]\nshape = { box = { min = [-3, -3], max = [3, 3] } }\n"
      "material = { diffuse = { reflectance = 0.5 } }\n";
  const std::string out = "[[lamp]]\nsource = { segment = { from = [2, -3], to = [-2, -3] } }\n";
  const std::string in = "[[lamp]]\nsource = { segment = { from = [-2, -3], to = [2, -3] } }\n";
  const GatheredLight dark = gathered(out + room);
  EXPECT_EQ(dark.fluence[3 * (7 * 16 + 7)], 0);
  const GatheredLight lit = gathered(in + room);
  EXPECT_EQ(lit.fluence[3 * (15 * 16 + 7)], 0);
  EXPECT_GT(covered(in + room), 0.9);
  const Scene scene = scene_of(seen(in + room, ""));
  const Timeline timeline(scene, 0, 1);
  EXPECT_EQ(walls_beside(lamp_states(scene, at(timeline, 1)).front(),
                         build_world(scene, at(timeline, 1)).surfaces)
                .walls.size(),
            1U);
}

// A wall and a lamp along a part of it, in a group that turns: by rounding rays set off from either side.
TEST(Light, OfALampAlongAWallIsNotTakenByItHoweverBothAreTurned) {
  struct Case {
    const char *lamp, *wall;
  };
  const std::string straight = "segment = { from = [-1, 0], to = [1, 0] }";
  for (const auto& [lamp, wall] :
       {Case{"source = { segment = { from = [-0.7, 0], to = [0.9, 0] } }", straight.c_str()},
        Case{"source = { beam = { width = 1.3 } }\nangle = 90", straight.c_str()},
        Case{"source = { arc = { radius = 1, from = 20, to = 70 } }",
             "arc = { radius = 1, from = 0, to = 90 }"}})
    for (int degrees = 0; degrees < 360; degrees += 17) {
      const Scene scene = scene_of(
          seen(fmt::format("[[group]]\nname = 'panel'\nat = [0.3, -0.2]\nangle = {}\n"
                           "[[lamp]]\ngroup = 'panel'\n{}\n"
                           "[[entity]]\ngroup = 'panel'\nmaterial = 'absorb'\nshape = {{ {} }}\n",
                           degrees, lamp, wall),
               "rays = 4096"));
      const LightCounts counts =
          trace_frame_light(scene, at(Timeline(scene, 0, 1), 1), nullptr, 1, 1, nullptr).counts;
      EXPECT_EQ(counts.escaped, counts.emitted) << lamp << ' ' << degrees;
    }
}

// Lamps at decimals beside a slanted wall, by their doubles on one side of it by some 1e-17.
TEST(Gather, OfALampBesideAWallByRoundingStaysOnItsSide) {
  for (const int tenths : {1, 3, 6, 7, 9, 11, 13, 19}) {
    const Vec2 lamp(tenths / 10.0, tenths / 30.0);
    const Sign side = orientation({-3, -1}, {3, 1}, lamp);
    if (side == Sign::zero) continue;
    const GatheredLight light = gathered(
        fmt::format("[[lamp]]\nsource = {{ point = {{}} }}\nat = [{}, {}]\n"
                    "[[entity]]\nshape = {{ segment = {{ from = [-3, -1], to = [3, 1] }} }}\n"
                    "material = 'absorb'\n",
                    lamp.x(), lamp.y()));
    for (const double above : {1.0, -1.0}) {
      const Vec2 pixel(0.25, above + 0.25);
      const auto column = static_cast<std::size_t>((pixel.x() + 4) * 2);
      const auto row = static_cast<std::size_t>((4 - pixel.y()) * 2);
      EXPECT_EQ(light.fluence[3 * (row * 16 + column)] > 0, (above > 0) == (side == Sign::positive))
          << tenths << ' ' << above;
    }
  }
}

// A pixel sees the cone by its angle, however narrow: 1e-7 degrees here.
TEST(Gather, OfANarrowConeIsNoBrighterThanItsWidth) {
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [16, 16], world = [[0, -5e-9], [1e-8, 5e-9]] }\n"
      "[light]\nrays = 65536\n[[lamp]]\nsource = { cone = { spread = 1e-7 } }\nat = [-1, 0]\n");
  const GatheredLight light =
      gather_frame_light(scene, at(Timeline(scene, 0, 1), 1), nullptr, 0, 1, nullptr);
  double lit = 0;
  for (std::size_t row = 0; row < 16; ++row) lit += light.fluence[3 * (row * 16 + 8)];
  EXPECT_NEAR(lit * 6.25e-10, 1, 0.2);  // rows of 6.25e-10, the light's width is 1.75e-9
}

// Its light leaves along a line: what of it a wall cuts off is dark.
TEST(Gather, OfABeamThatAWallCrossesIsCutThere) {
  const GatheredLight light = gathered(
      "[[lamp]]\nsource = { beam = { width = 2 } }\n"
      "[[entity]]\nshape = { segment = { from = [-1, -1], to = [1, 1] } }\nmaterial = 'absorb'\n");
  EXPECT_EQ(light.fluence[3 * (6 * 16 + 12)], 0);            // above, behind the wall
  EXPECT_NEAR(light.fluence[3 * (9 * 16 + 12)], 0.5, 1e-9);  // below, before it
}

TEST(Gather, IsTheSameForAnyThreadsAndSeedsDiffer) {
  const std::string scene = std::string(kRoom) + "[[lamp]]\nsource = { point = {} }\n";
  const GatheredLight one = gathered(scene, "rays = 10000");
  EXPECT_EQ(gathered(scene, "rays = 10000", 2).fluence, one.fluence);
  EXPECT_EQ(gathered(scene, "rays = 10000", 7).fluence, one.fluence);
  EXPECT_NE(gathered(scene, "rays = 10000", 1, 1).fluence, one.fluence);
}

// The problem of a scene that asks for paths from pixels.
std::string refusal(const std::string& rest) {
  const auto loaded = load_scene_text("test.toml", seen(rest, "estimator = 'backward'"), {});
  return loaded ? "" : loaded.error().front().message;
}

TEST(Gather, NamesTheLampAndTheMirrorThatHinderIt) {
  const std::string mirror =
      "[[entity]]\nname = 'pane'\nshape = { box = { min = [0, 0], max = [1, 1] } }\nmaterial = ";
  const std::string sun = "[[lamp]]\nname = 'sun'\nsource = { point = {} }\nat = [-2, 0]\n";
  for (const char* material :
       {"'mirror'", "{ mirror = {} }", "{ glass = {} }", "{ mix = { mirror = 0.1 } }"}) {
    const std::string why = refusal(sun + mirror + material + "\n");
    EXPECT_NE(why.find("'sun'"), std::string::npos) << material << why;
    EXPECT_NE(why.find("'pane'"), std::string::npos) << material << why;
  }
  EXPECT_NE(refusal("[[lamp]]\nname = 'laser'\nsource = { ray = {} }\n").find("'laser'"),
            std::string::npos);
  EXPECT_NE(refusal("[[lamp]]\nsource = { segment = { from = [0, 2], to = [1, 2] } }\n" + mirror +
                    "{ glass = { dispersion = 5000 } }\n")
                .find("'pane'"),
            std::string::npos);
  EXPECT_NE(refusal("[[lamp]]\nsource = { segment = { from = [0, 2], to = [1, 2] } }\n"
                    "[[entity]]\nname = 'pane'\nshape = { segment = { from = [0, 0], to = [1, 0] } "
                    "}\nmaterial = { mix = { mirror = 1, mirror_turn = [0, 9] } }\n")
                .find("'pane'"),
            std::string::npos);
  EXPECT_EQ(refusal(sun + mirror + "{ diffuse = {} }\n"), "");
  // No point lies on one ray but by chance.
  for (const char* spread : {"0", "{ keys = [[0, 10], [1, 0], [2, 10]] }"}) {
    const std::string why =
        refusal("[[lamp]]\nname = 'needle'\nsource = { cone = { spread = " + std::string(spread) +
                " } }\n");
    EXPECT_NE(why.find("'needle', a cone that is one ray"), std::string::npos) << why;
  }
}

// To go through a wall is a bounce, whichever way light is followed.
TEST(Gather, OfLightThroughWallsHasAsManyBouncesAsForward) {
  const std::string panes =
      "[[lamp]]\nsource = { point = {} }\nat = [-3, 0]\n"
      "[[entity]]\nshape = { segment = { from = [-1, -9], to = [-1, 9] } }\nmaterial = { pass = {} "
      "}\n"
      "[[entity]]\nshape = { segment = { from = [1, -9], to = [1, 9] } }\nmaterial = { pass = {} "
      "}\n";
  const auto columns = [](const std::vector<double>& rgb) {
    std::array<bool, 3> lit_columns{};
    for (const std::size_t column : {4U, 8U, 12U})
      lit_columns[column / 4 - 1] = rgb[3 * (7 * 16 + column)] > 0;
    return lit_columns;
  };
  for (unsigned bounces = 0; bounces < 4; ++bounces) {
    const std::string light = "rays = 65536\nbounces = " + std::to_string(bounces);
    EXPECT_EQ(columns(gathered(panes, light).fluence),
              columns(fluence(scene_of(seen(panes, light)), 2).rgb))
        << bounces;
  }
}

TEST(Gather, BesideWhatScattersAlikeIsWarnedOf) {
  const auto warnings = [](const char* material) {
    const auto loaded =
        load_scene_text("test.toml", seen("[[lamp]]\nsource = { point = {} }\nat = [-2, "
                                          "0]\n[[entity]]\nname = 'fog'\nshape = { circle "
                                          "= { radius = 1 } }\nmaterial = { mix = { " +
                                              std::string(material) + " = 0.5 } }\n",
                                          "estimator = 'backward'"));
    FLATRAY_CHECK(loaded.has_value());
    return format(loaded->warnings);
  };
  EXPECT_NE(warnings("isotropic").find("noise without bounds near entity 'fog'"),
            std::string::npos);
  EXPECT_EQ(warnings("diffuse"), "");
}

// Whatever the unit of length is: powers of two scale doubles exactly.
TEST(Gather, IsTheSameInWorldsOfAnySize) {
  const auto scene_in = [](double unit, const std::string& rest) {
    const std::string text =
        "flatray = 1\nfilm = {{ size = [16, 16], world = [[-{2}, -{2}], [{2}, {2}]] }}\n"
        "[light]\nrays = 4096\n[[lamp]]\nsource = {{ ";
    return scene_of(fmt::format(fmt::runtime(text + rest), unit, 2 * unit, 4 * unit, 201 * unit));
  };
  const auto light_in = [&](double unit, const std::string& rest) {
    const Scene scene = scene_in(unit, rest);
    const FrameState state = at(Timeline(scene, 0, 1), 1);
    std::vector<double> light = gather_frame_light(scene, state, nullptr, 0, 1, nullptr).fluence;
    for (double& one : light) one *= unit;
    return light;
  };
  const std::string matt = "material = {{ diffuse = {{ reflectance = 0.5 }} }}\n";
  const std::string room =
      "[[chamber]]\nshape = {{ box = {{ min = [-{1}, -{1}], max = [{2}, {1}] }} }}\n" + matt;
  const std::string hall =
      "[[chamber]]\nshape = {{ box = {{ min = [-{3}, -{3}], max = [{3}, {3}] }} }}\n" + matt;
  for (const std::string lamp :
       {"point = {{}} }}\n", "cone = {{ spread = 60 }} }}\n", "beam = {{ width = {0} }} }}\n",
        "segment = {{ from = [-{0}, {0}], to = [{0}, 0] }} }}\n",
        "arc = {{ radius = {0} }} }}\n"}) {
    const std::vector<double> free = light_in(1, lamp), held = light_in(1, lamp + room);
    const Scene wide = scene_in(1, lamp + hall);
    for (const double unit : {0x1p-600, 0x1p-900, 0x1p600, 0x1p900}) {
      EXPECT_EQ(light_in(unit, lamp), free) << lamp << unit;
      const std::vector<double> there = light_in(unit, lamp + room);
      double all = 0, off = 0;
      for (std::size_t i = 0; i < held.size(); ++i)
        all += held[i], off += std::abs(there[i] - held[i]);
      EXPECT_LE(off, 1e-9 * all) << lamp << unit;  // rays set off from walls elsewhere by rounding
      const Scene scene = scene_in(unit, lamp + hall);
      EXPECT_EQ(is_gathered(scene, at(Timeline(scene, 0, 1), 1)),
                is_gathered(wide, at(Timeline(wide, 0, 1), 1)));
    }
  }
}

// Of 2500 times the size of the picture, and where it can.
TEST(Gather, IsChosenForASmallPartOfTheWalls) {
  const auto chosen = [](const char* half, const char* material, const char* lamp = "point = {}") {
    const Scene scene =
        scene_of(seen("[[chamber]]\nshape = { box = { min = [-" + std::string(half) + ", -" + half +
                          "], max = [" + half + ", " + half + "] } }\nmaterial = " + material +
                          "\n[[lamp]]\nsource = { " + lamp + " }\n",
                      ""));
    const Timeline timeline(scene, 0, 1);
    return is_gathered(scene, at(timeline, 1));
  };
  EXPECT_TRUE(chosen("201", "{ diffuse = {} }"));
  EXPECT_FALSE(chosen("199", "{ diffuse = {} }"));
  EXPECT_FALSE(chosen("201", "'mirror'"));
  EXPECT_FALSE(chosen("201", "{ isotropic = {} }"));  // whose noise has no bounds from there
  // What few paths find.
  EXPECT_TRUE(chosen("201", "{ diffuse = {} }", "beam = { width = 600 }"));
  EXPECT_FALSE(chosen("201", "{ diffuse = {} }", "beam = { width = 500 }"));
  EXPECT_TRUE(chosen("2010", "{ diffuse = {} }", "cone = { spread = 4 }"));
  EXPECT_FALSE(chosen("2010", "{ diffuse = {} }", "cone = { spread = 3 }"));
  EXPECT_FALSE(chosen("2010", "{ diffuse = {} }", "segment = { from = [0, 0], to = [1, 0] }"));
}

}  // namespace
}  // namespace flatray
