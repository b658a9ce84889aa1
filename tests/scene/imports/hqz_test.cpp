// needs: formats/hqz lamps/ranges materials/mix shapes/segment
// Scenes of HQZ, and what is made of them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/philox.h"
#include "scene/curve.h"
#include "scene/lamp.h"
#include "scene/scatterer.h"
#include "scene/scene_text.h"
#include "scene/spectrum.h"

namespace flatray {
namespace {

Result<LoadedScene> hqz(std::string text, const LoadLimits& limits = {}) {
  return load_scene_text("t.json", std::move(text), {}, limits);
}
LoadedScene hqz_scene(const std::string& text) {
  Result<LoadedScene> result = hqz(text);
  FLATRAY_CHECK(result.has_value(), result ? "" : format(result.error()));
  return std::move(*result);
}
std::string hqz_refusal(std::string text) {
  const auto result = hqz(std::move(text));
  return result ? "" : format(result.error());
}

// A scene of one light, with `more` keys and lists.
std::string hqz_text(const std::string& lights, const std::string& objects = "",
                     const std::string& materials = "", const std::string& more = "") {
  return R"({"resolution": [64, 32], "viewport": [10, 20, 128, 64], "exposure": 0.5, "rays": 5000)" +
         more + R"(, "lights": [)" + lights + R"(], "objects": [)" + objects +
         R"(], "materials": [)" + materials + "]}";
}
constexpr const char* kLight = "[1, 30, 40, 0, 0, [0, 360], 0]";

TEST(HqzFormat, ThePictureIsTheViewportWithYDown) {
  const Scene scene = hqz_scene(hqz_text(kLight, "", "", ", \"gamma\": 2, \"seed\": 7")).scene;
  EXPECT_EQ(scene.film.width, 64);
  EXPECT_EQ(scene.film.height, 32);
  EXPECT_EQ(scene.film.world->low, Vec2(10, -84));
  EXPECT_EQ(scene.film.world->high, Vec2(138, -20));
  EXPECT_EQ(scene.light.rays, 5000U);
  EXPECT_EQ(scene.light.tone, ToneCurve::gamma);
  EXPECT_EQ(scene.light.gamma, 2);
  EXPECT_EQ(scene.seed, 7U);
  // A pixel that one ray of power 1 crosses by its width shows 128 / 255 exp(1 + 10 exposure) of it in
  // a picture of 1024 x 576; a pixel is 2 units here.
  EXPECT_NEAR(*scene.light.exposure,
              128.0 / 255 * std::exp(6.0) * std::sqrt(64.0 * 32 / (1024 * 576)) * 2, 1e-9);
}

TEST(HqzFormat, LightsAreLampsOfRanges) {
  const Scene scene =
      hqz_scene(hqz_text("[2, [1, 3], 40, 90, [0, 5], [10, 70], 0], [1, 0, 0, 0, 0, 0, 600], "
                         "[1, 0, 0, 0, 0, 0, [5000, \"K\"]]"))
          .scene;
  ASSERT_EQ(scene.lamps.size(), 3U);
  const Lamp& lamp = scene.lamps[0];
  EXPECT_EQ(lamp.power.value, 2);
  const auto emitter = emitter_at(scene, lamp, 0);
  for (const double u : {0.0, 0.25, 0.75}) {
    const double numbers[5] = {u, u, u, 0, 0};  // ray angle, polar distance, x
    const Emitted out = emitter->emit(numbers);
    EXPECT_NEAR(out.at.x(), 1 + 2 * u, 1e-12);
    EXPECT_NEAR(out.at.y(), -(40 + 5 * u), 1e-12);  // 90 degrees are down there
    const double angle = (10 + 60 * u) * std::numbers::pi / 180;
    EXPECT_NEAR(out.direction.x(), std::cos(angle), 1e-12);
    EXPECT_NEAR(out.direction.y(), -std::sin(angle), 1e-12);
  }
  EXPECT_EQ(scene.lamps[1].wavelength->value, 600);
  EXPECT_EQ(scene.lamps[2].temperature->value, 5000);
  // As bright as the eye sees what HQZ emits: all light of a blackbody, much of it unseen.
  EXPECT_NEAR(scene.lamps[1].power.value * luminance(colour_of_wavelength(600)), 0.631, 0.02);
  EXPECT_NEAR(scene.lamps[2].power.value * luminance(colour_of_temperature(5000)), 0.118, 0.01);
}

TEST(HqzFormat, RangesOfWavelengthsAreSixteenLamps) {
  const Scene scene = hqz_scene(hqz_text("[16, 0, 0, 0, 0, 0, [500, 532]]")).scene;
  ASSERT_EQ(scene.lamps.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_DOUBLE_EQ(scene.lamps[i].wavelength->value, 501 + 2 * static_cast<double>(i));
}

TEST(HqzFormat, ObjectsAreWallsWithTheirMaterials) {
  const Scene scene = hqz_scene(hqz_text(kLight, "[1, 20, 30, 5, -7], [0, 0, 0, 1, 1]",
                                         R"([], [[0.5, "t"], [0.1, "d"], [0.25, "r"]])"))
                          .scene;
  ASSERT_EQ(scene.entities.size(), 2U);
  const Entity& black = scene.entities[0];
  EXPECT_EQ(black.material, Material::absorb);
  const Entity& wall = scene.entities[1];
  const Segment& segment = scene.shapes[wall.shape].segments.at(0);
  EXPECT_EQ(segment.a, Vec2(20, -30));
  EXPECT_EQ(segment.b, Vec2(25, -23));
  EXPECT_FALSE(wall.stroke);
  const Scatterer& mix = *scene.scatterers[wall.scatterer];
  const Arrival arrival{{1, 0}, {-1, 0}};
  int ways[4] = {0, 0, 0, 0};
  for (int i = 0; i < 1000; ++i) ++ways[static_cast<int>(mix.scatter(arrival, i / 1000.0).way)];
  EXPECT_NEAR(ways[static_cast<int>(Departure::Way::scattered)], 100, 1);
  EXPECT_NEAR(ways[static_cast<int>(Departure::Way::mirrored)], 250, 1);
  EXPECT_NEAR(ways[static_cast<int>(Departure::Way::through)], 500, 1);
}

// A wall from (0, 0) to (2, 0) whose normal turns from 90 degrees (down there) by 30: at its middle a
// ray straight down onto it is mirrored by twice 15 degrees.
TEST(HqzFormat, NormalsOfTheirOwnTurnMirrors) {
  const Scene scene = hqz_scene(hqz_text(kLight, "[0, 0, 0, 90, 2, 0, 30]", R"([[1, "r"]])")).scene;
  const Scatterer& mix = *scene.scatterers[scene.entities.at(0).scatterer];
  ASSERT_TRUE(mix.depends_on_place());
  const auto out = [&](double along) {
    return mix.scatter({{0, -1}, {0, 1}, false, 1, 0, along}, 0.5).direction;
  };
  EXPECT_NEAR(out(0).x(), 0, 1e-12);
  EXPECT_NEAR(out(0).y(), 1, 1e-12);
  // n = (cos 105, sin 105) with y down; d = (0, 1) there.
  EXPECT_NEAR(out(0.5).x(), 0.5, 1e-12);
  EXPECT_NEAR(out(0.5).y(), std::sqrt(0.75), 1e-12);
}

TEST(HqzFormat, WallsThatLieOnOneAnotherAreOne) {
  const LoadedScene loaded =
      hqz_scene(hqz_text(kLight,
                         "[0, 0, 0, 10, 0], [0, 4, 0, 20, 0], [0, 12, 0, -14, 0], [0, 3, 0, 2, 0], "
                         "[0, 0, 1, 10, 0], [0, 5, 0, 1, 1], [0, 0, 0, 3, 9], [0, 1, 3, 3, 9]",
                         R"([[1, "d"]])"));
  const Scene& scene = loaded.scene;
  std::vector<std::pair<double, double>> level;  // walls at y = 0, by x
  for (const Entity& entity : scene.entities) {
    const Segment& wall = scene.shapes[entity.shape].segments.at(0);
    if (wall.a.y() == 0 && wall.b.y() == 0)
      level.emplace_back(std::min(wall.a.x(), wall.b.x()), std::max(wall.a.x(), wall.b.x()));
  }
  std::sort(level.begin(), level.end());
  const std::vector<std::pair<double, double>> expected{{-2, 0}, {0, 10}, {10, 24}};
  EXPECT_EQ(level, expected);
  EXPECT_EQ(scene.entities.size(), 3U + 2U + 2U);
  EXPECT_EQ(loaded.warnings.size(), 4U);
  EXPECT_NE(format(loaded.warnings).find("a part of this object lies on one before it"),
            std::string::npos);
}

using Ends = std::vector<std::pair<std::size_t, std::size_t>>;  // of walls on one line

// By cells from 0 to 32: each belongs to the first wall that covers it.
Ends without_overlaps_by_cells(const Ends& walls) {
  Ends parts;
  std::array<bool, 32> taken{};
  for (const auto& [from, to] : walls) {
    std::array<bool, 32> own{};
    for (std::size_t i = std::min(from, to); i < std::max(from, to); ++i)
      own[i] = !std::exchange(taken[i], true);
    for (std::size_t i = 0, begin = 0; i < 32; ++i) {
      if (own[i] && (i == 0 || !own[i - 1])) begin = i;
      if (own[i] && (i == 31 || !own[i + 1])) parts.emplace_back(begin, i + 1);
    }
  }
  std::ranges::sort(parts);
  return parts;
}

TEST(HqzFormat, WhateverLiesOnWhatEachPlaceBelongsToTheFirstWall) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    std::uint64_t draw = 0;
    const auto below = [&](std::size_t n) {
      return std::size_t{random_bits(seed, Stream::test, draw++, 0) % n};
    };
    const bool steep = below(2) == 1;
    const auto place = [&](std::size_t along) {
      const auto t = static_cast<double>(along);
      return steep ? Vec2(3 - t, 2 * t) : Vec2(2 * t, 5 + t);
    };
    Ends walls;
    std::string objects;
    for (std::size_t i = 2 + below(16); i > 0; --i) {
      const std::size_t from = below(33), to = (from + 1 + below(32)) % 33;
      walls.emplace_back(from, to);
      const Vec2 at = place(from), along = place(to) - at;
      objects += fmt::format("{}[0, {}, {}, {}, {}]", objects.empty() ? "" : ", ", at.x(), at.y(),
                             along.x(), along.y());
    }
    Ends parts;
    const Scene scene = hqz_scene(hqz_text(kLight, objects, R"([[1, "d"]])")).scene;
    for (const Entity& entity : scene.entities) {
      const Segment& wall = scene.shapes[entity.shape].segments.at(0);
      const auto cell = [&](const Vec2& end) {
        return static_cast<std::size_t>(steep ? 3 - end.x() : end.x() / 2);
      };
      parts.push_back(std::minmax({cell(wall.a), cell(wall.b)}));
    }
    std::ranges::sort(parts);
    EXPECT_EQ(parts, without_overlaps_by_cells(walls)) << seed << ": " << objects;
  }
}

// Short walls apart from one another, then long ones over all of them: the first of these fills the
// gaps, and each goes on at both ends. It took 28 s when each was compared with all before it.
TEST(HqzFormat, ThousandsOfWallsOnALineLeaveWhatIsBetweenAndBeyond) {
  std::string objects;
  for (int i = 0; i < 4096; ++i)
    objects += i < 2048 ? fmt::format("[0, {}, 0, 1, 0], ", 2 * i)
                        : fmt::format("[0, {}, 0, {}, 0], ", -i, 2 * i + 5000);
  objects.resize(objects.size() - 2);
  const std::size_t walls =
      hqz_scene(hqz_text(kLight, objects, R"([[1, "d"]])")).scene.entities.size();
  EXPECT_EQ(walls, 2048 + (2047 + 2) + 2 * 2047);
}

TEST(HqzFormat, WhatIsNotHonouredIsTold) {
  const std::string told =
      format(hqz_scene(hqz_text("[[1, 3], 0, 0, 0, 0, 0, 0], [1, 0, 0, 0, 0, 0, 100]",
                                "[0, 0, 0, 0, 0], [0, 0, [1, 5], 3, 0]", R"([[0.5, "x"]])",
                                R"(, "timelimit": 5, "gama": 2, "debug": 1)"))
                 .warnings,
             "warning");
  const auto gamma = hqz_scene(hqz_text(kLight, "", "", R"(, "gamma": -2)")).warnings;
  ASSERT_EQ(gamma.size(), 1U);
  EXPECT_NE(gamma[0].message.find("gamma of 0 and less counts as 1"), std::string::npos);
  for (const char* part :
       {"t.json:1:", "timelimit is not honoured", "unknown key 'gama'", "did you mean 'gamma'?",
        "debug is not honoured", "power is not drawn", "light of 100 nm is not seen",
        "an object without length", "its middle is taken", "unknown outcome"})
    EXPECT_NE(told.find(part), std::string::npos) << part << "\n" << told;
}

TEST(HqzFormat, OfManyWarningsAlikeTwentyAreTold) {
  std::string objects = "[0, 0, 0, 10, 0]";
  for (int i = 0; i < 50; ++i) objects += ", [0, 0, 0, 10, 0]";
  const Diagnostics warnings =
      hqz_scene(hqz_text(kLight, objects, R"([[1, "d"]])", R"(, "debug": 1)")).warnings;
  ASSERT_EQ(warnings.size(), 22U);
  EXPECT_EQ(warnings.back().message,
            "30 more like this: a part of this object lies on one before it");
}

TEST(HqzFormat, MistakesAreToldWhereTheyStand) {
  const auto with = [](const std::string& lights, const std::string& objects = "",
                       const std::string& materials = "") {
    return hqz_text("\n" + lights, "\n" + objects, "\n" + materials);
  };
  const std::string light = kLight;
  const std::vector<Refused> cases = {
      {"[1]", "the scene is no object"},
      {"{}", R"(the scene needs "resolution")"},
      {"{\"resolution\": [0, 5]}", "resolution does not lie between 1 and"},
      {"{\"resolution\": [0, 5]}", "write a number from 1 to 2147483647"},
      {"{\"resolution\": 5}", "write \"resolution\": [1920, 1080]"},
      {"{}", "add \"objects\": []"},
      {"{\"lights\": null}", "lights is null, not an array"},
      {hqz_text(""), "no light shines"},
      {with("[1, 2, 3]"), "t.json:2:1: error: a light is no list of 7 numbers"},
      {with("[-1, 0, 0, 0, 0, 0, 0]"), "t.json:2:2: error: power does not lie between"},
      {with("[1e999, 0, 0, 0, 0, 0, 0]"), "power is beyond 1e300"},
      {with("[1, \"x\", 0, 0, 0, 0, 0]"), "x is a string, not a number"},
      {with("[1, [1, 2, 3], 0, 0, 0, 0, 0]"), "x is no number and no range"},
      {with("[1, 0, 0, 0, 0, 0, [5, \"K\"]]"), "a temperature in kelvin does not lie between"},
      {with("[1, 0, 0, 0, 0, 0, -5]"), "wavelength does not lie between"},
      {with(light, "[0, 0, 0, 1, 1]"), "t.json:3:2: error: there is no such material"},
      {with(light, "[1, 0, 0, 1, 1]", "[]"), "t.json:3:2: error: there is no such material"},
      {with(light, "[0.5, 0, 0, 1, 1]", "[]"), "there is no such material"},
      {with(light, "[-1, 0, 0, 1, 1]", "[]"), "material does not lie between"},
      {with(light, "[0, 0, 0, 1e12, 1, 0, 0]", "[[1, \"r\"]]"),
       "t.json:3:11: error: angle does not lie between -360000 and 360000"},
      {with(light, "[0, 0, 0, 0, 1, 0, -4e5]", "[[1, \"r\"]]"),
       "t.json:3:20: error: turn does not lie between"},
      {with(light, "[0, 0, 0, 1]", "[]"), "an object is no list of 5 or 7 numbers"},
      {with(light, "", "[[-1, \"d\"]]"), "a probability does not lie between"},
      {with(light, "", "[5]"), "an outcome is a probability and what comes"},
      {hqz_text(light, "", "", R"(, "gamma": 100)"), "gamma does not lie between"},
      {hqz_text(light, "", "", R"(, "seed": 1.5)"), "seed is no whole number"},
      {R"({"resolution": [4, 4], "viewport": [0, 0, 0, 4], "rays": 1, "lights": [], "objects": 5,
          "materials": []})",
       "viewport has no area"},
  };
  expect_refused(cases, &hqz_refusal);
  const auto all = hqz(with("[1]", "[0]", "[[2]]"));
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().size(), 3U);
  EXPECT_TRUE(
      std::ranges::is_sorted(all.error(), {}, [](const Diagnostic& d) { return d.where.offset; }));
}

// Both ends of the mirror_turn that is made of them are one that `mix` takes.
TEST(HqzFormat, TheLargestNormalsAreTaken) {
  for (const char* sign : {"", "-"})
    hqz_scene(hqz_text(kLight, fmt::format("[0, 0, 0, {}360000, 0, -1, {}360000]", sign, sign),
                       R"([[1, "r"]])"));
}

TEST(HqzFormat, LimitsNameTheirOptions) {
  LoadLimits limits;
  limits.max_entities = 2;
  const auto many = hqz(hqz_text(kLight, "[0,0,0,1,0],[0,0,1,1,0],[0,0,2,1,0]", "[]"), limits);
  ASSERT_FALSE(many);
  EXPECT_NE(format(many.error()).find("--max-entities raises the limit"), std::string::npos);
  // 12 numbers of a light and 4 of a wall in each line.
  const std::string line = hqz_text(kLight, "[0, 0, 0, 4, 0]", R"([[1, "d"]])");
  limits.max_corners = 47;
  EXPECT_TRUE(hqz(line + "\n" + line, limits));
  const auto lines = hqz(line + "\n" + line + "\n" + line, limits);
  ASSERT_FALSE(lines);
  EXPECT_TRUE(format(lines.error())
                  .starts_with("t.json:3:1: error: objects and lights come to more "
                               "than 47 numbers up to here"))
      << format(lines.error());
  EXPECT_NE(format(lines.error()).find("--max-corners N"), std::string::npos);
}

TEST(HqzFormat, ShareOfOutcomesEndsAtOne) {
  const Scene scene =
      hqz_scene(hqz_text(kLight, "[0, 0, 0, 1, 0]", R"([[0.75, "d"], [0.75, "r"]])")).scene;
  const Scatterer& mix = *scene.scatterers[scene.entities.at(0).scatterer];
  int mirrored = 0;
  for (int i = 0; i < 1000; ++i)
    mirrored += mix.scatter({{1, 0}, {-1, 0}}, i / 1000.0).way == Departure::Way::mirrored ? 1 : 0;
  EXPECT_NEAR(mirrored, 250, 1);
}

TEST(HqzFormat, ASceneALineIsAnAnimation) {
  const std::string first = hqz_text(kLight, "[0, 0, 0, 4, 0], [0, 0, 5, 4, 0]", R"([[1, "d"]])"),
                    second = hqz_text("[3, 31, 40, 0, 0, [0, 360], 0]", "[0, 0, 1, 4, 0]",
                                      R"([[1, "d"]])"),
                    third = hqz_text(kLight, "[0, 0, 2, 4, 0]", R"([[1, "r"]])");
  const Scene scene = hqz_scene(first + "\n" + second + "\n\n" + third + "\n").scene;
  EXPECT_EQ(scene.frames, 3U);
  EXPECT_EQ(scene.entities.size(), 3U);  // two that scatter at most, and one mirror
  ASSERT_EQ(scene.lamps.size(), 1U);
  const auto power = [&](unsigned frame) {
    return plus(scene, scene.lamps[0].power, (frame - 1) / scene.fps);
  };
  EXPECT_EQ(power(1), 1);
  EXPECT_EQ(power(2), 3);
  EXPECT_EQ(power(3), 1);
}

// What comes to nothing and begins again steps down to 0 and up; what never changes has no curve.
TEST(HqzFormat, WallsAreThereInTheirLinesAlone) {
  const std::string wall = hqz_text(kLight, "[0, 0, 0, 4, 0]", R"([[1, "d"]])"),
                    none = hqz_text(kLight, "", R"([[1, "d"]])");
  const Scene scene = hqz_scene(none + "\n" + wall + "\n" + none + "\n" + none + "\n" + wall).scene;
  ASSERT_EQ(scene.entities.size(), 1U);
  const auto& curves = scene.curves;
  bool found = false;
  for (const Curve& curve : curves)
    if (curve.values == std::vector<double>{0, 4, 0, 4}) {
      found = true;
      EXPECT_EQ(curve.times, (std::vector<double>{0, 1 / 24.0, 2 / 24.0, 4 / 24.0}));
    }
  EXPECT_TRUE(found);
  EXPECT_TRUE(scene.ends);
  EXPECT_FALSE(hqz_scene(wall).scene.ends);
}

// Brightness is told in parts of the exposure of the first line.
TEST(HqzFormat, PowerBeyondAllBoundsIsToldWhereItIs) {
  std::string dark = hqz_text(kLight), bright = hqz_text("[1e12, 0, 0, 0, 0, 0, 0]");
  dark.replace(dark.find("0.5"), 3, "-6"), bright.replace(bright.find("0.5"), 3, "6");
  const std::string told = hqz_refusal(dark + "\n" + bright);
  EXPECT_NE(told.find("t.json:2:"), std::string::npos) << told;
  EXPECT_NE(told.find("power comes to 1.3e+64 with the exposure of its line, beyond 1e+30"),
            std::string::npos)
      << told;
}

TEST(HqzFormat, IsKnownByItsContent) {
  const auto read = load_scene_text("-", hqz_text(kLight), {}, {});
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_EQ(read->scene.lamps.size(), 1U);
}

TEST(HqzFormat, AnyStartOfAFileIsReadOrRefused) {
  const std::string text = hqz_text(kLight, "[0, 0, 0, 4, 0]", R"([[1, "d"]])");
  for (std::size_t size = 0; size < text.size(); ++size) EXPECT_FALSE(hqz(text.substr(0, size)));
}

}  // namespace
}  // namespace flatray
