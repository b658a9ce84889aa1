// needs: formats/hqz lamps/ranges materials/mix shapes/segment passes/light passes/entities formats/toml
// Scenes of HQZ against a tracer that shares nothing with the engine, and what their pictures show.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "oracle/flat_light.h"
#include "render/light/light_picture.h"
#include "render/lit.h"
#include "scene/spectrum.h"

namespace flatray {
namespace {

using Channels = std::array<double, 3>;

// Means of several independent pictures, and how far the mean of them is off by chance.
struct Estimate {
  Channels mean{}, error{};
};
template <class Trace>
Estimate estimate(int runs, const Trace& trace) {
  std::vector<Channels> all;
  for (int i = 0; i < runs; ++i) all.push_back(trace(static_cast<std::uint64_t>(i)));
  Estimate made;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const Channels& one : all) made.mean[c] += one[c] / runs;
    double square = 0;
    for (const Channels& one : all) square += std::pow(one[c] - made.mean[c], 2);
    made.error[c] = std::sqrt(square / (runs - 1) / runs);
  }
  return made;
}

Channels engine_mean(const Scene& scene, std::uint64_t seed) {
  const std::vector<double> rgb = fluence(scene, 1, seed).rgb;
  Channels mean{};
  for (std::size_t i = 0; i < rgb.size(); ++i)
    mean[i % 3] += rgb[i] * 3 / static_cast<double>(rgb.size());
  return mean;
}

oracle::EvenRange range_of(const nlohmann::json& value) {
  if (value.is_array()) return {value[0], value[1]};
  return {value, value};
}

Channels colour_of(const nlohmann::json& value) {
  if (value.is_array()) {
    const LightColour colour = colour_of_temperature(value[0]);
    const double bright = luminance_of_temperature(value[0]) / luminance(colour);
    return {bright * colour[0], bright * colour[1], bright * colour[2]};
  }
  const double nm = value;
  if (nm == 0) return {1, 1, 1};
  const LightColour colour = colour_of_wavelength(nm);
  const double bright = luminance_of_wavelength(nm) / luminance(colour);
  return {bright * colour[0], bright * colour[1], bright * colour[2]};
}

oracle::FlatScene::Wall wall_of(const nlohmann::json& object, const nlohmann::json& materials) {
  oracle::FlatScene::Wall wall{range_of(object[1]), range_of(object[2]), {}, {}};
  const bool own_normal = object.size() == 7;
  wall.dx = range_of(object[own_normal ? 4 : 3]), wall.dy = range_of(object[own_normal ? 5 : 4]);
  if (own_normal)
    wall.has_normal = true, wall.normal = range_of(object[3]), wall.turn = range_of(object[6]);
  for (const auto& outcome : materials[object[0].get<std::size_t>()]) {
    const std::string what = outcome[1];
    (what == "d"   ? wall.scattered
     : what == "t" ? wall.through
                   : wall.mirrored) += outcome[0].get<double>();
  }
  return wall;
}

// By the text itself. What chance and rounding would decide is left out: of level walls that lie on one
// another the later one's share.
oracle::FlatScene flat_scene(const nlohmann::json& json) {
  oracle::FlatScene scene;
  for (const auto& light : json["lights"])
    scene.lamps.push_back({light[0], colour_of(light[6]), range_of(light[1]), range_of(light[2]),
                           range_of(light[3]), range_of(light[4]), range_of(light[5])});
  for (const auto& object : json["objects"]) {
    std::vector<oracle::FlatScene::Wall> parts{wall_of(object, json["materials"])};
    const auto level = [](const oracle::FlatScene::Wall& wall) {
      return wall.dy.low == 0 && wall.dy.high == 0 && wall.dx.low > 0;
    };
    for (std::size_t i = 0; level(parts[0]) && i < scene.walls.size(); ++i) {
      const oracle::FlatScene::Wall& cover = scene.walls[i];
      if (!level(cover) || cover.y.low != parts[0].y.low) continue;
      std::vector<oracle::FlatScene::Wall> left;
      for (const oracle::FlatScene::Wall& part : parts) {
        const double from = part.x.low, to = from + part.dx.low, low = cover.x.low,
                     high = low + cover.dx.low;
        for (const auto& [a, b] :
             {std::pair(from, std::min(to, low)), std::pair(std::max(from, high), to)}) {
          if (!(a < b)) continue;
          left.push_back(part);
          left.back().x = {a, a}, left.back().dx = {b - a, b - a};
        }
      }
      parts = left;
      if (parts.empty()) break;
    }
    scene.walls.insert(scene.walls.end(), parts.begin(), parts.end());
  }
  scene.left = json["viewport"][0], scene.top = json["viewport"][1];
  scene.width = json["viewport"][2], scene.height = json["viewport"][3];
  return scene;
}

void expect_the_same_light(const std::string& text, const std::string& name) {
  const nlohmann::json json = nlohmann::json::parse(text);
  constexpr int kRuns = 8, kRays = 6000, kShrink = 20;
  const int width = json["resolution"][0].get<int>() / kShrink,
            height = json["resolution"][1].get<int>() / kShrink;
  const oracle::FlatScene flat = flat_scene(json);
  const Estimate expected = estimate(kRuns, [&](std::uint64_t seed) {
    return oracle::trace_flat(flat, width, height, kRays, seed).mean();
  });
  const auto loaded = load_scene_text(name, text,
                                      {{"film.size", fmt::format("[{}, {}]", width, height)},
                                       {"light.rays", std::to_string(kRays)}});
  ASSERT_TRUE(loaded) << format(loaded.error());
  const Estimate found =
      estimate(kRuns, [&](std::uint64_t seed) { return engine_mean(loaded->scene, seed + 1); });
  for (std::size_t c = 0; c < 3; ++c) {
    const double error = std::hypot(expected.error[c], found.error[c]);
    EXPECT_NEAR(found.mean[c], expected.mean[c], 3 * error) << name << " " << c;
    EXPECT_LT(error, 0.02 * expected.mean[c] + 1e-12) << name << " " << c;
    EXPECT_GT(expected.mean[c], 0) << name << " " << c;
  }
}

TEST(HqzLight, IsThatOfAnIndependentTracer) {
  bool any = false;
  for (const char* name :
       {"colors", "duel-5000k", "laser-rainbow", "quick", "spotlight", "stormy"}) {
    const std::filesystem::path path =
        source_path(std::string("/../shared/data/hqz/") + name + ".json");
    std::ifstream file(path);
    if (!file) continue;
    any = true;
    expect_the_same_light(std::string(std::istreambuf_iterator<char>(file), {}),
                          name + std::string(".json"));
  }
  if (!any) GTEST_SKIP() << "shared/data is absent";
}

// All that the format has, in one small scene.
constexpr const char* kSmall = R"({
  "resolution": [640, 320], "viewport": [-10, 5, 640, 320], "exposure": 0.5, "rays": 1000,
  "lights": [[2, [100, 200], 100, [0, 360], [0, 20], [0, 360], 0],
             [1, 500, 250, 0, 0, [170, 250], 590],
             [1, 400, 50, 0, 0, [0, 180], [3000, "K"]]],
  "objects": [[0, 0, 300, 600, 0], [1, 300, 60, 20, 200], [2, 50, 200, 200, 80, -60, 140],
              [1, 0, 10, 0, 290], [0, 620, 20, -30, 280]],
  "materials": [[[0.9, "d"]], [[0.3, "t"], [0.3, "r"], [0.2, "d"]], [[0.8, "r"]]]
})";

TEST(HqzLight, OfEveryKindOfObjectIsThatOfAnIndependentTracer) {
  expect_the_same_light(kSmall, "small.json");
}

// A beam of power 4 along x; a wall that is in its way in one of four places swallows a quarter of it.
TEST(HqzLight, MeetsEveryAlternativeOfAWallAsOften) {
  const auto across = [](double x, double y) {
    return fmt::format("{{ segment = {{ from = [{0}, {1}], to = [{0}, {2}] }} }}", x, y, y + 4);
  };
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [8, 8], world = [[-4, -4], [4, 4]] }\nlight = { rays = 100000 "
      "}\n"
      "[[lamp]]\nsource = { beam = { width = 1 } }\nat = [-3.5, 0.5]\npower = 4\n[[entity]]\nshape "
      "= " +
      across(2, 3) + "\nmaterial = 'absorb'\nalternatives = [" + across(0, -2) + ", " +
      across(2, 2) + ", " + across(2, -9) + "]\n");
  const Fluence light = fluence(scene, 2);
  EXPECT_NEAR(light.at(2, 3), 4, 1e-3);
  EXPECT_NEAR(light.at(6, 3), 3, 0.05);
  EXPECT_NE(light.at(6, 3), 3);
}

// A lamp at rest in a window without walls: u = 128 / 255 exp(1 + 10 e) P / (2 pi r) a pixel, in pixels.
TEST(HqzLight, IsAsBrightAsItsExposureSays) {
  const auto loaded = load_scene_text(
      "t.json",
      R"({"resolution": [64, 36], "viewport": [0, 0, 64, 36], "exposure": 0.2, "rays": 100000,
          "lights": [[3, 32, 18, 0, 0, [0, 360], 0]], "objects": [], "materials": []})");
  ASSERT_TRUE(loaded) << format(loaded.error());
  const Image shown = picture(loaded->scene);
  for (const int x : {40, 50, 60}) {
    const double r = x + 0.5 - 32;
    const double level = 128.0 / 255 * std::exp(3.0) * std::sqrt(64.0 * 36 / (1024 * 576)) /
                         (2 * std::numbers::pi * r);  // of three lamps in one: power 1 a ray
    EXPECT_NEAR(shown.at(x, 18)[0], 255 * 3 * level, 1.5) << x;
  }
}

TEST(HqzLight, GammaCurveIsThePowerInLevels) {
  for (const double gamma : {0.1, 1.0, 2.2, 10.0}) {
    const GammaCurve curve(gamma);
    EXPECT_EQ(curve(0), 0);
    EXPECT_EQ(curve(1), 1);
    EXPECT_EQ(curve(1e300), 1);
    for (double light = 1e-30; light < 1; light *= 1.37) {
      const double level = std::pow(light, 1 / gamma);
      const double shown =
          level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
      const double relative = gamma < 1 ? 2e-3 : 1e-5;  // steeper where gamma is small
      EXPECT_NEAR(static_cast<double>(curve(light)), shown, relative * shown + 1e-30)
          << gamma << " " << light;
    }
  }
}

TEST(HqzLight, FramesOfAnAnimationAreItsLines) {
  const auto line = [](int x, const char* what) {
    return fmt::format(
        R"({{"resolution": [64, 32], "viewport": [0, 0, 64, 32], "exposure": 0.5, "rays": 3000, )"
        R"("lights": [[1, {}, 16, 0, 0, [0, 360], 0]], "objects": [[0, 30, 0, 0, 32]], )"
        R"("materials": [[[1, "{}"]]]}})",
        x, what);
  };
  const std::string lines[] = {line(10, "r"), line(20, "d"), line(50, "r")};
  const auto whole = load_scene_text("t.json", lines[0] + "\n" + lines[1] + "\n" + lines[2]);
  ASSERT_TRUE(whole) << format(whole.error());
  for (unsigned frame = 1; frame <= 3; ++frame) {
    const auto one = load_scene_text("t.json", lines[frame - 1]);
    ASSERT_TRUE(one) << format(one.error());
    EXPECT_EQ(picture(whole->scene, frame).pixels, picture(one->scene).pixels) << frame;
  }
}

}  // namespace
}  // namespace flatray
