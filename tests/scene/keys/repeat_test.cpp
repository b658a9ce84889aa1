// needs: shapes/box shapes/circle
#include "scene/repeat.h"

#include <set>

#include "base/philox.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string repeated_entity(const std::string& keys) {
  return "flatray = 1\nseed = 5\n[[entity]]\nname = \"e\"\n" + keys + "\n";
}
std::string disc(const std::string& keys) {
  return repeated_entity("shape = { circle = { radius = 1 } }\n" + keys);
}

std::vector<Vec2> places(const Scene& scene) {
  std::vector<Vec2> all;
  for (const Entity& one : scene.entities) all.push_back(one.at);
  return all;
}

TEST(Repeat, AGridGoesAlongItsRows) {
  const Scene scene =
      loaded(disc("at = [10, 20]\nrepeat = { grid = { count = [3, 2], step = [0.5, -4] } }")).scene;
  EXPECT_EQ(places(scene),
            (std::vector<Vec2>{{10, 20}, {10.5, 20}, {11, 20}, {10, 16}, {10.5, 16}, {11, 16}}));
  EXPECT_EQ(scene.entities[0].name, "e.0");
  EXPECT_EQ(scene.entities[5].name, "e.5");
}

TEST(Repeat, AQuarterOfARingIsExact) {
  const Scene scene =
      loaded(disc("at = [1, 1]\nrepeat = { ring = { count = 4, radius = 3, turn = true } }")).scene;
  EXPECT_EQ(places(scene), (std::vector<Vec2>{{4, 1}, {1, 4}, {-2, 1}, {1, -2}}));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(scene.entities[i].angle, radians(90.0 * static_cast<double>(i)));
}

TEST(Repeat, ARingMayStartAnywhereAndStopShort) {
  const Scene scene =
      loaded(disc("repeat = { ring = { count = 3, radius = 1, start = 90, step = -90 } }")).scene;
  EXPECT_EQ(places(scene), (std::vector<Vec2>{{0, 1}, {1, 0}, {0, -1}}));
  EXPECT_EQ(scene.entities[2].angle, 0);
}

TEST(Repeat, WhatIsNotDrawnIsOneShape) {
  EXPECT_EQ(loaded(disc("repeat = { ring = { count = 100, radius = 9 } }")).scene.shapes.size(),
            1u);
  EXPECT_EQ(loaded(disc("angle = { uniform = [0, 1] }\nrepeat = { ring = { count = 100, radius = 9 "
                        "} }"))
                .scene.shapes.size(),
            1u);
}

constexpr const char* kScatter = "repeat = { scatter = { count = %, in = [[-2, 3], [4, 3.5]] } }";
std::string scatter(int count) {
  std::string text = kScatter;
  return text.replace(text.find('%'), 1, std::to_string(count));
}

TEST(Repeat, ScatterStaysInItsBoxAndDiffersBySeed) {
  const Scene scene = loaded(disc(scatter(1000))).scene;
  std::set<double> seen;
  for (const Vec2& at : places(scene)) {
    EXPECT_TRUE(at.x() >= -2 && at.x() <= 4 && at.y() >= 3 && at.y() <= 3.5);
    seen.insert(at.x());
  }
  EXPECT_EQ(seen.size(), 1000u);
  const Scene other = loaded(disc(scatter(1000)), {{"seed", "6"}}).scene;
  EXPECT_NE(places(other), places(scene));
}

TEST(Repeat, ScatterIsTheDrawsTheFormatNames) {
  const Scene scene = loaded(disc(scatter(7))).scene;
  const double u = unit_double(random_bits(5, Stream::scatter, 0, 6, 0));
  const double v = unit_double(random_bits(5, Stream::scatter, 0, 6, 1));
  EXPECT_EQ(scene.entities[6].at, Vec2(-2 + u * 6, 3 + v * 0.5));
}

TEST(Repeat, MoreCopiesLeaveTheFirstOnesAsTheyAre) {
  const std::string drawn = "angle = { normal = [0, 40] }\n";
  const Scene few = loaded(disc(drawn + scatter(5))).scene;
  const Scene many = loaded(disc(drawn + scatter(50))).scene;
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(few.entities[i].at, many.entities[i].at);
    EXPECT_EQ(few.entities[i].angle, many.entities[i].angle);
  }
}

TEST(Repeat, TheSeedOfTheCommandLineDrawsToo) {
  const auto one = load_scene_text("t.toml", disc(scatter(3)), {}, {}, 9);
  ASSERT_TRUE(one);
  EXPECT_EQ(places(one->scene), places(loaded(disc(scatter(3)), {{"seed", "9"}}).scene));
  EXPECT_EQ(one->scene.seed, 9u);
}

TEST(Repeat, CopiesAreDrawnInTheirOrderBetweenTheirNeighbours) {
  const Scene scene = loaded(disc("repeat = { grid = { count = [3, 1], step = [1, 0] } }") +
                             "[[entity]]\nshape = { circle = { radius = 1 } }\n")
                          .scene;
  for (std::size_t i = 0; i + 1 < scene.entities.size(); ++i)
    EXPECT_LT(scene.entities[i].order, scene.entities[i + 1].order);
}

TEST(Repeat, OneCopyCanBeCalledByItsName) {
  const std::string text = disc("repeat = { grid = { count = [3, 1], step = [1, 0] } }");
  EXPECT_EQ(loaded(text + "[camera]\nfollow = \"e.2\"").scene.camera.follow, 2u);
  EXPECT_NE(refusal(text + "[camera]\nfollow = \"e\"").find("'e' has copies"), std::string::npos);
}

TEST(Random, UniformNumbersFillTheirRange) {
  const Scene scene =
      loaded(disc("at = [{ uniform = [2, 3] }, 1]\n" + scatter(4000).replace(0, 0, ""))).scene;
  double sum = 0, low = 9, high = -9;
  for (std::size_t i = 0; i < scene.entities.size(); ++i) {
    const double u = unit_double(random_bits(5, Stream::scatter, 0, i, 0));
    const double drawn = scene.entities[i].at.x() - (-2 + u * 6);
    sum += drawn, low = std::min(low, drawn), high = std::max(high, drawn);
  }
  EXPECT_NEAR(sum / 4000, 2.5, 0.02);  // three sigmas are 0.0137
  EXPECT_GE(low, 2 - 1e-12);
  EXPECT_LE(high, 3 + 1e-12);
}

TEST(Random, NormalNumbersHaveTheirMeanAndSpread) {
  const Scene scene = loaded(disc("velocity = [{ normal = [10, 2] }, 0]\n" + scatter(10000))).scene;
  double sum = 0, squares = 0;
  for (const Entity& one : scene.entities)
    sum += one.velocity.x(), squares += (one.velocity.x() - 10) * (one.velocity.x() - 10);
  EXPECT_NEAR(sum / 10000, 10, 0.06);  // three sigmas
  EXPECT_NEAR(squares / 10000, 4, 0.17);
}

TEST(Random, AChoiceTakesEachOfItsListAboutAsOften) {
  const Scene scene =
      loaded(disc("fill = { choice = [\"#000001\", \"#000002\", \"none\"] }\n" + scatter(3000)))
          .scene;
  int counts[3] = {0, 0, 0};
  for (const Entity& one : scene.entities) ++counts[one.fill ? one.fill->b - 1 : 2];
  for (const int count : counts) EXPECT_NEAR(count, 1000, 78);  // three sigmas
}

TEST(Random, ShapesAndPointsAreChosenToo) {
  const Scene scene =
      loaded(repeated_entity(
                 "shape = { choice = [{ circle = { radius = { uniform = [1, 2] } } }, { box = { "
                 "min = [0, 0], max = [1, 1] } }] }\nvelocity = { choice = [[1, 2], [3, 4]] }\n" +
                 scatter(100)))
          .scene;
  std::set<std::size_t> circles, speeds;
  for (const Entity& one : scene.entities) {
    circles.insert(scene.shapes[one.shape].circles.size());
    speeds.insert(static_cast<std::size_t>(one.velocity.x() + one.velocity.y()));
  }
  EXPECT_EQ(circles, (std::set<std::size_t>{0, 1}));
  EXPECT_EQ(speeds, (std::set<std::size_t>{3, 7}));
}

TEST(Random, ADrawIsNamedByItsPlaceAmongTheTablesDistributions) {
  const Scene scene =
      loaded(disc("angular_velocity = { uniform = [0, 1] }\nvelocity = [0, { uniform = [0, 1] }]"))
          .scene;
  EXPECT_EQ(scene.entities[0].velocity.y(), unit_double(random_bits(5, Stream::value, 0, 0, 2)));
  EXPECT_EQ(scene.entities[0].angular_velocity,
            radians(unit_double(random_bits(5, Stream::value, 0, 0, 0))));
}

TEST(Random, RefusalsSayWhatToWrite) {
  const Refused cases[] = {
      {"flatray = 1\nfilm = { world = [[{ uniform = [0, 1] }, 0], [1, 1]] }",
       "film.world[0][0] cannot be drawn at random"},
      {disc("angle = { uniform = [1] }"), "entity.angle.uniform is an array, not two numbers"},
      {disc("angle = { uniform = [2, 1] }"), "entity.angle.uniform ends below its beginning"},
      {disc("angle = { normal = [2, -1] }"), "entity.angle.normal has a spread below 0"},
      {disc("angle = { normal = [2, 1e301] }"), "entity.angle.normal reaches beyond 1e300"},
      {disc("angle = { choice = [] }"), "entity.angle.choice is empty"},
      {disc("angle = { choice = 3 }"), "entity.angle.choice is a number, not a list"},
      {disc("angle = { choice = [1, \"2\"] }"), "entity.angle[1] is a string, not a number"},
      {disc("angle = { unifrom = [0, 1] }"), "entity.angle is a table, not a number"},
      {disc("fill = { uniform = [0, 1] }"), "entity.fill is a table, not a string"},
      {repeated_entity("shape = { circle = { radius = { uniform = [-2, -1] } } }\n" + scatter(9)),
       "circle has a radius of -1."},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

// Found by a reviewer: their copies landed elsewhere.
TEST(Repeat, CopiesBeyondAllNumbersAreRefused) {
  for (const char* repeat :
       {"ring = { count = 2, radius = 1e305 }", "grid = { count = [10, 1], step = [1e300, 0] }"})
    EXPECT_NE(refusal(repeated_entity("shape = { circle = { radius = 1 } }\nrepeat = { " +
                                      std::string(repeat) + " }"))
                  .find("has copies beyond 1e300"),
              std::string::npos)
        << repeat;
}

TEST(Repeat, RefusalsSayWhatToWrite) {
  const Refused cases[] = {
      {disc("repeat = {}"), "repeat has 0 kinds, not one"},
      {disc("repeat = { grid = { count = [1, 1], step = [1, 1] }, ring = { count = 2, radius = 1 "
            "} }"),
       "repeat has 2 kinds, not one"},
      {disc("repeat = { grid = { count = 3, step = [1, 1] } }"),
       "repeat.grid.count is a number, not two whole numbers"},
      {disc("repeat = { ring = { count = 0, radius = 1 } }"), "repeat.ring.count is 0"},
      {disc("repeat = { ring = { count = 2 } }"), "repeat.ring needs 'radius'"},
      {disc("repeat = { scatter = { count = 2, in = [[0, 0], [0, 1]] } }"),
       "repeat.scatter.in has no area"},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

TEST(Repeat, AMistakeOfManyCopiesIsToldOnce) {
  const std::string shown = refusal(disc("angel = 3\nlayer = 0.5\n" + scatter(1000)));
  EXPECT_EQ(shown.find("unknown key 'angel'"), shown.rfind("unknown key 'angel'"));
  EXPECT_EQ(shown.find("entity.layer"), shown.rfind("entity.layer"));
}

TEST(StiffCases, E6ManyCopiesAreRefusedBeforeTheyAreMade) {
  const std::string shown =
      refusal(disc("repeat = { grid = { count = [32768, 32768], step = [1, 1] } }"));
  EXPECT_EQ(shown,
            R"(t.toml:6:1: error: entity stands for 1073741824, after 0 before it
    repeat = { grid = { count = [32768, 32768], step = [1, 1] } }
    ^~~~~~  the limit is 1000000; --max-entities raises it
)");
  EXPECT_NE(refusal(disc("repeat = { grid = { count = [1099511627776, 1099511627776], step = [1, "
                         "1] } }"))
                .find("stands for more than 10^18"),
            std::string::npos);
}

TEST(Repeat, TheLimitIsTheCallersAndNamesItsOption) {
  LoadLimits limits;
  limits.max_entities = 4;
  const std::string three = disc("repeat = { ring = { count = 3, radius = 1 } }");
  EXPECT_TRUE(load_scene_text("t.toml", three, {}, limits));
  const auto refused = load_scene_text(
      "t.toml", three + "[[entity]]\nrepeat = { ring = { count = 2, radius = 1 } }", {}, limits);
  ASSERT_FALSE(refused);
  EXPECT_NE(format(refused.error()).find("entity stands for 2, after 3 before it\n"),
            std::string::npos)
      << format(refused.error());
  EXPECT_NE(format(refused.error()).find("the limit is 4; --max-entities raises it"),
            std::string::npos);
}

}  // namespace
}  // namespace flatray
