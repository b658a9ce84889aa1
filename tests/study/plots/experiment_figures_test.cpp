// needs: shapes/box shapes/circle
// What every experiment draws: a figure that says what its axes are, as SVG and as pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include "image/png.h"
#include "study/chamber_scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

std::size_t count(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return static_cast<std::size_t>(std::distance(
      std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator()));
}

void expect_figure(const ExperimentResult::File& file) {
  const std::string& text = file.content;
  EXPECT_TRUE(is_well_formed(text)) << file.name;
  EXPECT_EQ(count(text, "<title>[^<]+</title>\n<style>"), 1U) << file.name;
  EXPECT_EQ(count(text, "font-weight=\"bold\"[^>]*>[^<]+</text>"), 1U) << file.name << ": title";
  EXPECT_GE(count(text, "text-anchor=\"middle\" class=[^>]*>[A-Za-z][^<]+</text>"), 1U)
      << file.name << ": label of x";
  EXPECT_GE(count(text, "transform=\"rotate\\(-90[^>]*>[A-Za-z][^<]+</text>"), 1U)
      << file.name << ": label of y";
  EXPECT_GE(count(text, "text-anchor=\"middle\" class=[^>]*>-?[0-9.e-]+</text>"), 2U)
      << file.name << ": ticks of x";
  EXPECT_GE(count(text, "text-anchor=\"end\" class=[^>]*>-?[0-9.e-]+</text>"), 2U)
      << file.name << ": ticks of y";
  EXPECT_EQ(count(text, "prefers-color-scheme:dark"), 1U) << file.name;
}

TEST(ExperimentFigures, HaveATitleLabelsAndTicks) {
  const Scene room = sinai("0.25");
  const Scene open = scene_of(
      "film = { size = [32, 24], world = [[-2, -2], [2, 2]] }\n"
      "[[ray]]\nat = [-2, 0.5]\ndirection = [1, 0]\n" +
      mirror_disc("0, 0"));
  const Scene movers = scene_of(
      "film = { size = [32, 24] }\nframes = 3\n"
      "[[entity]]\nname = \"a\"\nshape = { circle = { radius = 1 } }\nvelocity = [1, 0]\n"
      "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [4, 0]\n");
  std::map<std::string, std::size_t> figures;
  for (const auto& [name, scene] : std::map<std::string, const Scene*>{{"poincare", &room},
                                                                       {"phase-portion", &room},
                                                                       {"coverage", &room},
                                                                       {"caustic", &room},
                                                                       {"reflections", &room},
                                                                       {"divergence", &room},
                                                                       {"escape", &open},
                                                                       {"avoidance", &movers}}) {
    const ExperimentResult result =
        run(name, {.scene = *scene, .count = 6400, .bounces = 50, .map = PixelMap::usual});
    for (const ExperimentResult::File& file : result.files)
      if (file.name.ends_with(".svg")) {
        ++figures[name];
        expect_figure(file);
      } else if (file.name.ends_with(".png")) {
        const auto image = decode_png(std::as_bytes(std::span(file.content)), file.name);
        ASSERT_TRUE(image) << file.name;
        const int side = std::max(image->width, image->height);
        // Poincare sections have 820 pixels within the axes, each of which is seen.
        EXPECT_TRUE(name == "poincare" ? side > 1000 : side == 1000) << file.name << side;
      }
    EXPECT_GT(figures[name], 0U) << name;
  }
}

// The bar beside a Poincare section ends at the most bounces that any of its pixels has.
TEST(ExperimentFigures, TheBarOfASectionCountsBounces) {
  const Scene room = sinai("0.25");
  const ExperimentResult result = run("poincare", {.scene = room, .bounces = 3000});
  std::uint64_t most = 0;
  const std::string& table = content_of(result, "poincare_density.csv");
  const std::regex counts(",([0-9]+)(?![.0-9])");
  for (std::sregex_iterator one(table.begin() + static_cast<std::ptrdiff_t>(table.find('\n')),
                                table.end(), counts);
       one != std::sregex_iterator(); ++one)
    most = std::max<std::uint64_t>(most, std::stoull((*one)[1]));
  EXPECT_GT(most, 3U);
  const std::string& text = content_of(result, "poincare.svg");
  const std::size_t bar = text.rfind("<image");
  EXPECT_NE(text.find(">bounces in a pixel</text>", bar), std::string::npos);
  EXPECT_NE(text.find(">" + std::to_string(most) + "</text>", bar), std::string::npos) << most;
}

// Gone are the pixels whose orbits escape, and those whose orbits are absorbed.
TEST(ExperimentFigures, EscapeTimesCountPixels) {
  const Scene scene = scene_of(
      "film = { size = [20, 20], world = [[-2, -2], [2, 2]] }\n[[entity]]\nname = \"disc\"\n"
      "shape = { circle = { radius = 1 } }\nmaterial = \"absorb\"\n");
  const ExperimentResult result = run("escape", {.scene = scene, .count = 100});
  std::istringstream table(content_of(result, "escape_times.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "bounces,pixels_gone,pixels_remaining");
  double gone = 0, remaining = 0;
  while (std::getline(table, line)) {
    gone += std::stod(line.substr(line.find(',') + 1));
    remaining = std::stod(line.substr(line.rfind(',') + 1));
  }
  const double absorbed = measure(result, "into disc").value;
  EXPECT_GT(absorbed, 0);
  EXPECT_NEAR(absorbed + measure(result, "into the open").value, gone / (gone + remaining), 1e-12);
}

// Threads share rows and blocks, and no byte of a figure depends on how many there are.
TEST(ExperimentFigures, AreTheSameBytesWhateverTheThreads) {
  const Scene room = sinai("0.25");
  expect_same_files(run("reflections", {.scene = room, .threads = 1, .bounces = 20}),
                    run("reflections", {.scene = room, .threads = 3, .bounces = 20}));
}

// The numbers beside a map: as many rows as the film has, under the x of its columns.
TEST(ExperimentFigures, TheNumbersOfAMapStandBesideIt) {
  const Scene room = sinai("0.25");
  const ExperimentResult result = run("reflections", {.scene = room, .bounces = 7});
  const std::string& text = content_of(result, "reflections_pixels.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 25);
  EXPECT_EQ(std::count(text.begin(), text.end(), ','), 25 * 32);
  EXPECT_TRUE(has(text, ",7,7,"));
  EXPECT_TRUE(has(text, ",,")) << "no orbit starts in the disc";
}

}  // namespace
}  // namespace flatray
