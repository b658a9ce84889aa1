// needs: shapes/arc shapes/box shapes/sector shapes/segment lamps/arc lamps/beam lamps/cone lamps/point lamps/ranges lamps/ray lamps/segment materials/diffuse materials/glass materials/isotropic materials/mirror materials/mix materials/pass formats/toml
// Lamps and materials as scenes have them, and what they do with rays.
#include <cmath>

#include "scene/lamp.h"
#include "scene/material.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string with_material(const std::string& material) {
  return "flatray = 1\n[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\nmaterial = " +
         material + "\n";
}

std::unique_ptr<const Emitter> emitter(const std::string& source, double time = 0) {
  const Scene scene = loaded(with_lamp("source = " + source)).scene;
  return emitter_at(scene, scene.lamps.at(0), time);
}

TEST(Lamps, SendOutRaysOfLengthOneWhereTheyAre) {
  for (const char* source :
       {"{ ray = {} }", "{ point = {} }", "{ cone = { spread = 40 } }", "{ beam = { width = 3 } }",
        "{ segment = { from = [1, 1], to = [4, 5] } }",
        "{ arc = { radius = 2, from = 10, to = 100 } }"}) {
    const auto made = emitter(source);
    for (int i = 0; i < 100; ++i) {
      const double u[] = {i / 100.0, std::fmod(i * 0.618, 1.0)};
      EXPECT_NEAR(made->emit(u).direction.squaredNorm(), 1, 1e-14) << source;
    }
  }
  const double half[] = {0.5, 0.25};
  EXPECT_EQ(emitter("{ ray = {} }")->emit(half).direction, Vec2(1, 0));
  EXPECT_EQ(emitter("{ cone = { spread = 40 } }")->emit(half).direction, Vec2(1, 0));
  EXPECT_EQ(emitter("{ point = {} }")->emit(half).direction, Vec2(-1, 0));
  EXPECT_EQ(emitter("{ beam = { width = 3 } }")->emit(half).at, Vec2(0, 0));
  const Emitted line = emitter("{ segment = { from = [0, 0], to = [4, 0] } }")->emit(half);
  EXPECT_EQ(line.at, Vec2(1, 0));
  EXPECT_EQ(line.direction, Vec2(0, 1));
  const Emitted arc =
      emitter("{ arc = { radius = 2, from = 0, to = 360, inward = true } }")->emit(half);
  EXPECT_EQ(arc.at, Vec2(0, 2));
  EXPECT_EQ(arc.direction, Vec2(0, -1));
}

// Found by a reviewer: at both keys it is a whole turn, in between more.
TEST(Lamps, AreRefusedWhereTwoNumbersAreWrongBetweenTheirKeys) {
  const std::string refused = refusal(
      "flatray = 1\nframes = 5\nfps = 2\n[[lamp]]\nsource = { arc = { radius = 1, from = { keys = "
      "[[0, 0], [2, 360]] }, to = { keys = [[0, 360], [2, 720]], ease = \"smooth\" } } }\n");
  EXPECT_NE(refused.find("393.75 degrees from lamp.arc.from, more than a whole turn "
                         "at 1.5 s"),
            std::string::npos)
      << refused;
}

TEST(Lamps, ShineBeforeBlackWhereNoBackgroundIsSaid) {
  const std::string lamp = "[[lamp]]\nsource = { point = {} }\n";
  const auto background = [&](const std::string& rest) {
    return loaded("flatray = 1\n" + rest).scene.film.background;
  };
  EXPECT_EQ(background(lamp), (Colour{0, 0, 0, 255}));
  EXPECT_EQ(background("film = { size = [9, 9] }\n" + lamp), (Colour{0, 0, 0, 255}));
  EXPECT_EQ(background("film = { background = \"#ffffff\" }\n" + lamp),
            (Colour{255, 255, 255, 255}));
  EXPECT_EQ(background(""), (Colour{255, 255, 255, 255}));
}

TEST(Lamps, ChangeWithTheirCurves) {
  const double u[] = {0, 0};
  const char* source = "{ cone = { spread = { keys = [[0, 0], [1, 180]] } } }";
  EXPECT_EQ(emitter(source, 0)->emit(u).direction, Vec2(1, 0));
  EXPECT_EQ(emitter(source, 1)->emit(u).direction, Vec2(0, -1));
  EXPECT_EQ(emitter("{ beam = { width = { keys = [[0, 0], [1, 2]] } } }", 0), nullptr);
}

TEST(Lamps, OfRangesTakeANumberForEachThatIsOne) {
  const auto made = emitter(
      "{ ranges = { x = [1, 3], y = 4, polar_angle = 90, polar_distance = [0, 5], ray_angle = "
      "[90, 180] } }");
  const double u[] = {1.0 / 3, 0.5, 0.25, 9, 9};  // ray angle, distance, x
  const Emitted out = made->emit(u);
  EXPECT_NEAR(out.at.x(), 1.5, 1e-14);
  EXPECT_NEAR(out.at.y(), 4 + 2.5, 1e-14);
  EXPECT_NEAR(out.direction.x(), -0.5, 1e-14);
  EXPECT_NEAR(out.direction.y(), std::sqrt(0.75), 1e-14);
  const double none[] = {0, 0, 0, 0, 0};
  EXPECT_EQ(emitter("{ ranges = {} }")->emit(none).direction, Vec2(1, 0));
  const char* moving = "{ ranges = { x = [{ keys = [[0, 0], [1, 8]] }, 8] } }";
  EXPECT_EQ(emitter(moving, 0.5)->emit(none).at, Vec2(4, 0));
  EXPECT_EQ(emitter("{ ranges = { x = { keys = [[0, 0], [1, 8]] } } }", 0.5)->emit(none).at,
            Vec2(4, 0));
  expect_problem(with_lamp("source = { ranges = { x = [1, 2, 3] } }"), "lamp.ranges.x");
  expect_problem(with_lamp("source = { ranges = { ray_angle = 1e200 } }"), "reaches beyond 1e150");
}

TEST(Lamps, SayWhatIsWrong) {
  expect_problem(with_lamp(""), "lamp needs 'source'");
  expect_problem(with_lamp("source = { bulb = {} }"), "unknown lamp 'bulb'");
  expect_problem(with_lamp("source = { cone = { spread = 400 } }"),
                 "lamp.cone.spread is 400, not between 0 and 360");
  expect_problem(with_lamp("source = { beam = { width = -1 } }"), "lamp.beam.width is -1");
  expect_problem(with_lamp("source = { segment = { from = [1, 1], to = [1, 1] } }"),
                 "lamp.segment.to is where it begins");
  expect_problem(with_lamp("source = { arc = { radius = 1, to = 400 } }"),
                 "more than a whole turn");
  expect_problem(with_lamp("source = { point = {} }\npower = -1"),
                 "lamp.power is -1, not 0 to 1e+30");
  expect_problem(with_lamp("source = { point = {} }\nnm = 200"), "lamp.nm is 200, not 380 to 780");
  expect_problem(with_lamp("source = { point = {} }\nnm = { keys = [[0, 400], [1, 900]] }"),
                 "lamp.nm comes to 900, not 380 to 780");
  expect_problem(with_lamp("source = { point = {} }\nkelvin = 10"),
                 "lamp.kelvin is 10, not 800 to 1e+05");
  expect_problem(with_lamp("source = { cone = { spread = { keys = [[0, 10], [3, 400]] } } }"),
                 "lamp.cone.spread is 400, not between 0 and 360 at 3 s");
  expect_problem(with_lamp("source = { beam = { width = { keys = [[0, 1], [2, -1]] } } }"),
                 "lamp.beam.width goes below 0");
  expect_problem(with_lamp("source = { point = { width = 1 } }"), "it has no keys");
  expect_problem(with_lamp("source = { point = {} }\ncolour = '#ff000080'"), "has an opacity");
  expect_problem("film = { size = [1, 65537] }\n" + with_lamp("source = { point = {} }"),
                 "light of lamps is not kept on a film of 1 x 65537");
  expect_problem("flatray = 1\n[light]\nrays = 0\n", "light.rays");
  expect_problem("flatray = 1\n[light]\nexposure = 0\n", "light.exposure is 0, not above 0");
}

TEST(Lamps, ThatAreDarkInAllFramesAreWarnedOf) {
  const auto warning = [](const std::string& keys) {
    const Diagnostics warnings = loaded(with_lamp("source = { point = {} }\n" + keys)).warnings;
    return warnings.empty() ? std::string() : warnings.front().message;
  };
  EXPECT_EQ(warning(""), "");
  EXPECT_EQ(warning("power = 0"), "the lamp is dark: its power is 0");
  EXPECT_EQ(warning("power = { keys = [[0, 0], [1, 1]] }"), "");
  EXPECT_EQ(warning("colour = '#000000'"), "the lamp is dark: its colour is black");
  EXPECT_EQ(warning("colour = { keys = [[0, '#000000'], [1, '#010000']] }"), "");
}

TEST(Lamps, AreCopied) {
  const Scene scene = loaded(with_lamp("source = { point = {} }\nname = 'l'\n"
                                       "repeat = { grid = { count = [3, 2], step = [1, 2] } }"))
                          .scene;
  ASSERT_EQ(scene.lamps.size(), 6U);
  EXPECT_EQ(scene.lamps[5].at, Vec2(2, 2));
  EXPECT_EQ(scene.lamps[5].name, "l.5");
}

const Scatterer& scatterer(Scene& kept, const char* material) {
  kept = loaded(with_material(material)).scene;
  return *kept.scatterers.at(kept.entities[0].scatterer);
}

// The part of u for which light goes one way.
double part(const Scatterer& wall, Departure::Way way, const Arrival& arrival = {{0, -1}, {0, 1}}) {
  constexpr int kSteps = 10'000;
  int count = 0;
  for (int i = 0; i < kSteps; ++i)
    if (wall.scatter(arrival, (i + 0.5) / kSteps).way == way) ++count;
  return static_cast<double>(count) / kSteps;
}

TEST(Materials, GoTheirWaysByTheirParts) {
  using Way = Departure::Way;
  Scene scene;
  EXPECT_NEAR(part(scatterer(scene, "{ mirror = { reflectance = 0.25 } }"), Way::mirrored), 0.25,
              1e-3);
  EXPECT_NEAR(part(scatterer(scene, "{ diffuse = { reflectance = 0.75 } }"), Way::scattered), 0.75,
              1e-3);
  EXPECT_NEAR(part(scatterer(scene, "{ pass = { transmittance = 0.5 } }"), Way::through), 0.5,
              1e-3);
  const Scatterer& mix =
      scatterer(scene, "{ mix = { diffuse = 0.1, isotropic = 0.2, mirror = 0.3, pass = 0.25 } }");
  EXPECT_NEAR(part(mix, Way::scattered), 0.3, 1e-3);
  EXPECT_NEAR(part(mix, Way::mirrored), 0.3, 1e-3);
  EXPECT_NEAR(part(mix, Way::through), 0.25, 1e-3);
  EXPECT_NEAR(part(mix, Way::absorbed), 0.15, 1e-3);
}

TEST(Materials, OfAColourKeepItsTint) {
  Scene scene;
  const Scatterer& red = scatterer(scene, "{ mirror = { reflectance = 0.5, colour = '#ff0000' } }");
  EXPECT_NEAR(part(red, Departure::Way::mirrored), 0.5, 1e-3);
  EXPECT_EQ(red.scatter({{0, -1}, {0, 1}}, 0).tint, (std::array<float, 3>{1, 0, 0}));
  const Scatterer& black = scatterer(scene, "{ diffuse = { colour = '#000000' } }");
  EXPECT_EQ(part(black, Departure::Way::absorbed), 1);
}

// Lambert's law in two dimensions: the cosine's mean is pi / 4, the sine's 0.
TEST(Materials, MattOnesScatterByLambert) {
  Scene scene;
  const Scatterer& matt = scatterer(scene, "{ diffuse = {} }");
  double cosine = 0, sine = 0;
  constexpr int kSteps = 100'000;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 out = matt.scatter({{0, -1}, {0, 1}}, (i + 0.5) / kSteps).direction;
    cosine += out.y() / kSteps, sine += out.x() / kSteps;
  }
  EXPECT_NEAR(cosine, 3.14159265358979 / 4, 1e-6);
  EXPECT_NEAR(sine, 0, 1e-9);
}

TEST(Materials, GlassFollowsSnellAndFresnel) {
  using Way = Departure::Way;
  Scene scene;
  const Scatterer& glass = scatterer(scene, "{ glass = { index = 1.5 } }");
  EXPECT_NEAR(part(glass, Way::mirrored), 0.04, 2e-4);  // ((1.5 - 1) / (1.5 + 1))^2
  for (const double degrees : {10.0, 35.0, 56.309932474020215, 80.0}) {
    const double in = degrees / 180 * 3.14159265358979323846;
    const Arrival arrival{{std::sin(in), -std::cos(in)}, {0, 1}};
    const Departure out = glass.scatter(arrival, 0.999999);
    ASSERT_EQ(out.way, Way::scattered);
    EXPECT_NEAR(out.direction.x() * 1.5, std::sin(in), 1e-14) << degrees;
    EXPECT_LT(out.direction.y(), 0);
    const double beyond = std::asin(std::sin(in) / 1.5);
    const double s = std::sin(in - beyond) / std::sin(in + beyond);
    const double p = std::tan(in - beyond) / std::tan(in + beyond);  // 0 at Brewster's angle
    EXPECT_NEAR(part(glass, Way::mirrored, arrival), (s * s + p * p) / 2, 2e-4) << degrees;
    const Arrival back{-out.direction, {0, -1}, true};
    EXPECT_NEAR(glass.scatter(back, 0.999999).direction.x(), -std::sin(in), 1e-14) << degrees;
  }
  const Arrival shallow{{0.7, -std::sqrt(0.51)}, {0, 1}, true};  // beyond 41.8 degrees from inside
  EXPECT_EQ(part(glass, Way::mirrored, shallow), 1);
  const Arrival same{{0.6, -0.8}, {0, 1}, false, 1.5};
  EXPECT_EQ(part(glass, Way::mirrored, same), 0);
  EXPECT_NEAR(glass.scatter(same, 0).direction.x(), 0.6, 1e-15);
}

TEST(Materials, OfGlassHaveATintWhereTheyAbsorb) {
  Scene scene;
  using Channels = std::array<double, 3>;
  EXPECT_EQ(scatterer(scene, "{ glass = {} }").absorption(), (Channels{0, 0, 0}));
  const Scatterer& grey = scatterer(scene, "{ glass = { absorption = 0.5 } }");
  EXPECT_EQ(grey.absorption(), (Channels{0.5, 0.5, 0.5}));
  EXPECT_FALSE(grey.colours());
  const Scatterer& blue = scatterer(scene, "{ glass = { absorption = [2, 1, 0.1] } }");
  EXPECT_EQ(blue.absorption(), (Channels{2, 1, 0.1}));
  EXPECT_TRUE(blue.colours());
}

TEST(Materials, SayWhatIsWrong) {
  expect_problem(with_material("'glass'"), "entity.material 'glass' has numbers of its own");
  expect_problem(with_material("'glas'"), "did you mean 'glass'?");
  expect_problem(with_material("{ wood = {} }"), "unknown material 'wood'");
  expect_problem(with_material("{ mirror = { reflectance = 1.5 } }"),
                 "material.mirror.reflectance is 1.5, not between 0 and 1");
  expect_problem(with_material("{ mirror = { colour = '#ffffff80' } }"), "has an opacity");
  const std::string pillar = refusal(
      "flatray = 1\n[[chamber]]\nshape = { box = { min = [0, 0], max = [9, 9] } }\n"
      "[[chamber.pillars]]\nshape = { segment = { from = [1, 1], to = [2, 2] } }\n"
      "material = { glass = {} }\n");
  EXPECT_NE(pillar.find(":4:"), std::string::npos) << pillar;
  const std::string index = refusal(with_material("{ glass = { index = 0, dispersion = 4000 } }"));
  EXPECT_NE(index.find("material.glass.index is 0"), std::string::npos) << index;
  EXPECT_EQ(index.find("dispersion"), index.rfind("dispersion")) << index;
  expect_problem(with_material("{ mix = { mirror = 0.7, pass = 0.7 } }"), "more than 1 together");
  expect_problem(with_material("{ glass = { index = 0 } }"),
                 "material.glass.index is 0, not above 0 and at most 100");
  expect_problem(with_material("{ glass = { absorption = -1 } }"),
                 "material.glass.absorption is -1, not 0 to 1e30");
  expect_problem(with_material("{ glass = { absorption = [0, 1, 1e31] } }"),
                 "material.glass.absorption is 1e+31");
  expect_problem(with_material("{ glass = { absorption = [1, 2] } }"),
                 "a number, or three of them");
  expect_problem(with_material("{ glass = { absorption = '#ff0000' } }"),
                 "material.glass.absorption");
  expect_problem(with_material("{ glass = { index = 1.5, dispersion = -1e9 } }"),
                 "material.glass.dispersion");
}

TEST(Materials, ThatSendNoLightOnAreWarnedOf) {
  for (const char* dark :
       {"{ mirror = { reflectance = 0 } }", "{ diffuse = { colour = '#000000' } }",
        "{ pass = { transmittance = 0 } }", "{ mix = {} }"})
    EXPECT_EQ(loaded(with_material(dark)).warnings.at(0).message, "the material sends no light on")
        << dark;
  EXPECT_TRUE(loaded(with_material("{ mix = { pass = 0.1 } }")).warnings.empty());
}

TEST(Materials, ThatAreClearHaveAFillThatLightIsSeenThrough) {
  const auto alpha = [](const std::string& material) {
    return loaded(with_material(material)).scene.entities[0].fill->a;
  };
  EXPECT_EQ(alpha("{ mirror = {} }"), 255);
  EXPECT_LT(alpha("{ glass = {} }"), 64);
  EXPECT_LT(alpha("{ pass = {} }"), 64);
}

TEST(Materials, TurnedMirrorsAreForStraightWalls) {
  const Scene scene =
      loaded(with_material("{ mix = { mirror = 1, mirror_turn = [0, 90] } }")).scene;
  const Scatterer& mix = *scene.scatterers.at(0);
  ASSERT_TRUE(mix.depends_on_place());
  const Departure end = mix.scatter({{0, -1}, {0, 1}, false, 1, 0, 1}, 0.5);
  EXPECT_EQ(end.way, Departure::Way::scattered);
  EXPECT_NEAR(end.direction.y(), -1, 1e-14);  // its normal runs along the wall: it goes through
  expect_problem(with_material("{ mix = { mirror_turn = [0, 1e7] } }"),
                 "more than 1000000 degrees");
}

TEST(Entities, HaveAlternativesThatAreSegments) {
  const std::string wall =
      "flatray = 1\n[[entity]]\nshape = { segment = { from = [0, 0], to = [1, 0] } }\nmaterial = "
      "'mirror'\nalternatives = ";
  EXPECT_EQ(loaded(wall + "[{ segment = { from = [0, 1], to = [1, 1] } }]")
                .scene.entities.at(0)
                .alternatives.size(),
            1U);
  expect_problem(
      wall +
          "[{ segment = { from = [0, 1], to = [1, 1] } }]\n[[lamp]]\nsource = { point = {} "
          "}\n[light]\nestimator = 'backward'\n",
      "paths from pixels do not know the alternatives");
  for (const char* shape :
       {"{ box = { min = [0, 0], max = [1, 1] } }", "{ segment = { from = [2, 2], to = [2, 2] } }",
        "{ segment = { from = [0, 0], to = [1, { keys = [[0, 1], [1, 2]] }] } }"})
    EXPECT_NE(refusal(wall + "[" + shape + "]").find("error: "), std::string::npos) << shape;
  expect_problem(with_shape("circle = { radius = 1 }") +
                     "alternatives = [{ segment = { from = [0, 1], to = [1, 1] } }]\n",
                 "alternatives are not one segment each");
}

TEST(Materials, OfCopiesAreOneUnlessTheyAreDrawn) {
  const auto scatterers = [](const std::string& reflectance) {
    return loaded(with_material("{ mirror = { reflectance = " + reflectance + " } }") +
                  "repeat = { grid = { count = [5, 1], step = [2, 0] } }\n")
        .scene.scatterers.size();
  };
  EXPECT_EQ(scatterers("0.5"), 1U);
  EXPECT_EQ(scatterers("{ uniform = [0, 1] }"), 5U);
}

TEST(Materials, OfGlassNeedAnInside) {
  for (const char* shape :
       {"segment = { from = [0, 0], to = [1, 1] }", "arc = { radius = 1, from = 0, to = 90 }"})
    expect_problem("flatray = 1\n[[entity]]\nshape = { " + std::string(shape) +
                       " }\nmaterial = { glass = {} }\n",
                   "what is of glass here has no inside");
  expect_problem(
      "flatray = 1\n[[entity]]\nshape = { sector = { radius = 2, inner = 1, from = 0, to = 360 } "
      "}\n"
      "material = { glass = {} }\n",
      "or is a ring with a slit");
  expect_problem(
      "flatray = 1\n[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "material = { glass = {} }\nholes = [{ edge = 0, from = 0.2, to = 0.3 }]\n",
      "walls of glass have no holes");
  EXPECT_TRUE(
      loaded("flatray = 1\n[[entity]]\nshape = { sector = { radius = 2, from = 0, to = 360 } }\n"
             "material = { glass = {} }\n")
          .scene.shapes.at(0)
          .arc_paths.at(0)
          .is_ellipse());
  const char* periodic =
      "flatray = 1\n[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\nmaterial = "
      "'periodic'\n[[lamp]]\nsource = { point = {} }\n";
  ASSERT_EQ(loaded(periodic).warnings.size(), 1U);
  EXPECT_EQ(loaded("flatray = 1\n[light]\nrays = 5\n").warnings.at(0).message, "no lamp shines");
}

TEST(Lamps, WallsOfTooManyAlternativesAreToldWhereTheyAre) {
  const auto refused = load_scene_text(
      "t.toml",
      "flatray = 1\n[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n[[entity]]\n"
      "shape = { segment = { from = [0, 0], to = [1, 0] } }\nmaterial = 'absorb'\n"
      "alternatives = [{ segment = { from = [0, 0], to = [2, 0] } }]\n",
      {}, {.max_corners = 60});
  ASSERT_FALSE(refused);
  EXPECT_NE(format(refused.error()).find("t.toml:4:1: error: the corners of all walls, once for"),
            std::string::npos)
      << format(refused.error());
}

}  // namespace
}  // namespace flatray
