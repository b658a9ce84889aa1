// What `flatray explain` says of the walls that rays are traced by is what is built for them.
// needs: shapes/arc shapes/box shapes/capsule shapes/circle shapes/convex shapes/ellipse shapes/import shapes/mushroom shapes/ngon shapes/penrose shapes/polygon shapes/polyline shapes/sector shapes/segment shapes/star shapes/text shapes/tokarsky formats/toml formats/obj formats/list tracers/brute tracers/grid tracers/exact
#include "render/ray_walls.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "counting_tracer.h"
#include "support/pictures.h"

namespace flatray {
namespace {

// All "A x B cells" of a text, A * B of each.
std::size_t cells_in(const std::string& words) {
  static const std::regex kCells("([0-9]+) x ([0-9]+) cells");
  std::size_t count = 0;
  for (std::sregex_iterator found(words.begin(), words.end(), kCells), end; found != end; ++found)
    count += std::stoul((*found)[1]) * std::stoul((*found)[2]);
  return count;
}

void expect_told_as_built(const Scene& scene, const std::string& name) {
  const Timeline timeline(scene, scene.seed, 1);
  const RayWalls built(scene, at(timeline, 1), nullptr);
  const std::vector<RenderPlan::Choice> told = ray_wall_choices(scene, at(timeline, 1), nullptr);
  ASSERT_EQ(told.size(), 2U);
  if (scene.field() != 0) {
    EXPECT_EQ(told[0].decision, "left out");
    return;
  }
  EXPECT_EQ(told[0].decision, built.orbits().choice().tracer->name) << name;
  EXPECT_EQ(cells_in(told[0].reason), built.orbits().walls().cells()) << name;
  EXPECT_EQ(cells_in(told[1].decision), built.orbits().origin_cells().cells()) << name;
  for (const std::string& words : {told[0].reason, told[1].decision})
    EXPECT_TRUE(cells_in(words) > 0 || words.find("one list") != std::string::npos) << words;
}

std::string room(int walls, int circles) {
  std::string text = "flatray = 1\n[[ray]]\nat = [-1, 0.5]\ndirection = [1, 0.01]\nbounces = 3\n";
  for (int i = 0; i < walls / 4; ++i)
    text += fmt::format(
        "[[entity]]\nmaterial = \"mirror\"\nshape = {{ box = {{ min = [{}, 0], max = [{}, 1] }} "
        "}}\n",
        2 * i, 2 * i + 1);
  for (int i = 0; i < circles; ++i)
    text += fmt::format(
        "[[entity]]\nmaterial = \"mirror\"\nshape = {{ circle = {{ centre = [{}, 9], radius = 1 }} "
        "}}\n",
        3 * i);
  return text;
}

TEST(RayWalls, AreToldAsTheyAreBuilt) {
  for (const auto& file : std::filesystem::recursive_directory_iterator(source_path("/scenes")))
    if (file.path().extension() == ".toml" &&
        file.path().string().find("parts") == std::string::npos) {
      const Result<LoadedScene> loaded = load_scene(file.path(), {}, {.root = source_path()});
      ASSERT_TRUE(loaded) << file.path();
      if (need_of_ray_walls(loaded->scene).needed)
        expect_told_as_built(loaded->scene, file.path().filename().string());
    }
  for (const int walls : {0, 4, 16, 20, 24, 28, 400})
    for (const int circles : {0, 1, 8, 9, 200})
      expect_told_as_built(scene_of(room(walls, circles)), fmt::format("{}, {}", walls, circles));
}

TEST(RayWalls, OfTheHallAreInListsAlone) {
  const Scene scene = scene_at("scenes/chamber/hall.toml");
  const Timeline timeline(scene, scene.seed, 1);
  const RayWalls built(scene, at(timeline, 1), nullptr);
  EXPECT_EQ(built.orbits().walls().cells(), 0U);
  EXPECT_EQ(built.orbits().origin_cells().cells(), 0U);
  EXPECT_EQ(built.orbits().origin_cells().entries(), 0U);
}

std::size_t builds_of(const std::string& text, bool keep_all = false) {
  const Scene scene = scene_of(text);
  const Timeline timeline(scene, scene.seed, 1);
  EXPECT_TRUE(draw_list(make_plan(scene, keep_all, counting_tracer()), timeline, 1));
  return tracer_counts().builds;
}

TEST(RayWalls, AreBuiltOnceAFrameForRaysThatNeedThem) {
  std::string rays = room(8, 0);
  for (int i = 0; i < 200; ++i)
    rays += fmt::format("[[ray]]\nat = [-1, {}]\ndirection = [1, 0.02]\nbounces = {}\n", 0.001 * i,
                        1 + i % 3);
  EXPECT_EQ(builds_of(rays), 1U);
  const std::string none = "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\n";
  EXPECT_EQ(builds_of(none, true), 0U);
  const std::string moving =
      none + "[[ray]]\nat = [3, 0]\ndirection = [1, 0]\nbounces = 2\nspeed = 1\n";
  EXPECT_EQ(builds_of(moving), 0U);
  const Scene scene = scene_of(moving);
  const Timeline timeline(scene, scene.seed, 1);
  for (const RenderPlan::Choice& choice : ray_wall_choices(scene, at(timeline, 1), nullptr))
    EXPECT_EQ(choice.decision, "left out");
}

}  // namespace
}  // namespace flatray
