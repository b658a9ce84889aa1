// needs: shapes/circle shapes/convex shapes/segment
#include <gtest/gtest.h>

#include <numbers>

#include "scene/scene_text.h"

namespace flatray {
namespace {

constexpr const char* kEveryKey = R"(flatray = 1
frames = 120
fps = 12.5
seed = 7
[film]
size = [320, 200]
world = [[-1, -2], [30, 40]]
background = "#01020304"
coverage = "centre"
[camera]
height = 9
follow = "runner"
offset = [3, 4]
velocity = [5, 6]
motion = "objects"
[[entity]]
name = "runner"
shape = { box = { min = [0, 0], max = [1, 2] } }
at = [4, 1]
angle = 90
velocity = [12, 0.5]
angular_velocity = -180
fill = "#aabbcc"
stroke = { width = 0.5, colour = "#102030" }
bounding_box = { width_px = 2, colour = "#405060" }
layer = -3
material = "mirror"
markov = { chain = "run", start = "RUN" }
[entity.states]
RUN = [
  { name = "RUN1", shape = { circle = { radius = 2 } }, fill = "#000001", velocity = [1, 2] },
  { name = "RUN2", fill = "none", stroke = { width_px = 3 } },
]
DIE = { fill = "#ff0000" }
[[entity]]
name = "line"
shape = { segment = { from = [0, 0], to = [1, 1] } }
[[chamber]]
name = "hall"
shape = { box = { min = [0, 0], max = [20, 20] } }
material = "absorb"
fill = "#111111"
stroke = { width = 1, colour = "#222222" }
layer = 4
[[chamber.pillars]]
name = "wedge"
shape = { convex = { points = [[0, 0], [2, 0], [0, 2]] } }
at = [5, 5]
angle = 45
material = "absorb"
fill = "#333333"
stroke = { width_px = 1, colour = "#444444" }
[[ray]]
name = "probe"
at = [15, 5]
direction = [1, -1]
bounces = 12
stroke = { width = 0.1, colour = "#555555" }
hit_points = "#666666"
layer = 6
[[edge_rays]]
from = "line"
against = "runner"
stroke = { width_px = 4, colour = "#777777" }
inside = "#888888"
enter = "#999999"
exit = "#aaaaaa"
layer = 8
[markov.run]
hold = 10
repair = "scaled"
STAND = { RUN = 0.5, DIE = 0.5 }
RUN = { RUN = 0.25, DIE = 0.25 }
DIE = { DIE = 1 }
)";

const Scene& every_key() {
  static const LoadedScene scene = loaded(kEveryKey);
  return scene.scene;
}

TEST(SceneKeys, FilmCameraAndTime) {
  const Scene& scene = every_key();
  EXPECT_EQ(scene.name, "t");
  EXPECT_EQ(scene.frames, 120u);
  EXPECT_EQ(scene.fps, 12.5);
  EXPECT_EQ(scene.seed, 7u);
  EXPECT_EQ(scene.film.width, 320);
  EXPECT_EQ(scene.film.height, 200);
  EXPECT_EQ(scene.film.world->low, Vec2(-1, -2));
  EXPECT_EQ(scene.film.world->high, Vec2(30, 40));
  EXPECT_EQ(scene.film.background, (Colour{1, 2, 3, 4}));
  EXPECT_EQ(scene.film.coverage, Coverage::centre);
  EXPECT_EQ(loaded("flatray = 1\ncamera = { at = [1, 2] }").scene.camera.at->value, Vec2(1, 2));
  EXPECT_EQ(scene.camera.height->value, 9);
  EXPECT_EQ(*scene.camera.follow, 0u);
  EXPECT_EQ(scene.camera.offset, Vec2(3, 4));
  EXPECT_EQ(scene.camera.velocity, Vec2(5, 6));
  EXPECT_EQ(scene.camera.motion, CameraMotion::objects);
}

TEST(SceneKeys, AnOffsetOfACameraThatFollowsNothingIsWarnedOf) {
  const Diagnostics told = loaded("flatray = 1\ncamera = { offset = [1, 0] }").warnings;
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].message, "offset moves nothing: the camera follows no entity");
}

TEST(SceneKeys, Entity) {
  const Entity& entity = every_key().entities[0];
  EXPECT_EQ(entity.name, "runner");
  EXPECT_EQ(entity.at, Vec2(4, 1));
  EXPECT_EQ(entity.angle, std::numbers::pi / 2);
  EXPECT_EQ(entity.velocity, Vec2(12, 0.5));
  EXPECT_EQ(entity.angular_velocity, -std::numbers::pi);
  EXPECT_EQ(*entity.fill, (Colour{0xaa, 0xbb, 0xcc, 255}));
  EXPECT_EQ(entity.stroke->width, 0.5);
  EXPECT_FALSE(entity.stroke->in_pixels);
  EXPECT_EQ(entity.stroke->colour, (Colour{0x10, 0x20, 0x30, 255}));
  EXPECT_EQ(entity.bounding_box->width, 2);
  EXPECT_TRUE(entity.bounding_box->in_pixels);
  EXPECT_EQ(entity.layer, -3);
  EXPECT_EQ(entity.material, Material::mirror);
  EXPECT_EQ(entity.where.source->position(entity.where.offset).line, 16);
}

TEST(SceneKeys, StatesChooseLooks) {
  const Scene& scene = every_key();
  const MarkovUse& use = *scene.entities[0].markov;
  EXPECT_EQ(use.chain, 0u);
  EXPECT_EQ(use.start, 1u);
  ASSERT_EQ(use.looks.size(), 3u);
  EXPECT_TRUE(use.looks[0].empty());
  ASSERT_EQ(use.looks[1].size(), 2u);
  EXPECT_EQ(use.looks[1][0].name, "RUN1");
  EXPECT_EQ(scene.shapes[*use.looks[1][0].shape].circles[0].radius, 2);
  EXPECT_EQ(*use.looks[1][0].velocity, Vec2(1, 2));
  EXPECT_FALSE(use.looks[1][1].shape);
  EXPECT_EQ(use.looks[1][1].fill->a, 0);  // "none" hides
  EXPECT_EQ(use.looks[1][1].stroke->width, 3);
  ASSERT_EQ(use.looks[2].size(), 1u);
  EXPECT_EQ(*use.looks[2][0].fill, (Colour{255, 0, 0, 255}));
}

TEST(SceneKeys, ChamberAndPillars) {
  const Chamber& chamber = every_key().chambers[0];
  EXPECT_EQ(chamber.name, "hall");
  EXPECT_EQ(chamber.material, Material::absorb);
  EXPECT_EQ(chamber.fill->r, 0x11);
  EXPECT_EQ(chamber.stroke->colour.r, 0x22);
  EXPECT_EQ(chamber.layer, 4);
  const Chamber::Pillar& pillar = chamber.pillars.at(0);
  EXPECT_EQ(pillar.name, "wedge");
  EXPECT_EQ(pillar.at, Vec2(5, 5));
  EXPECT_EQ(pillar.angle, std::numbers::pi / 4);
  EXPECT_EQ(pillar.material, Material::absorb);
  EXPECT_EQ(pillar.fill->r, 0x33);
  EXPECT_EQ(pillar.stroke->width, 1);
}

TEST(SceneKeys, RaysAndEdgeRays) {
  const RayPath& ray = every_key().rays.at(0);
  EXPECT_EQ(ray.name, "probe");
  EXPECT_EQ(ray.at, Vec2(15, 5));
  EXPECT_EQ(ray.direction.value, Vec2(1, -1));
  EXPECT_EQ(ray.bounces, 12u);
  EXPECT_EQ(ray.stroke.width, 0.1);
  EXPECT_EQ(ray.hit_points->r, 0x66);
  EXPECT_EQ(ray.layer, 6);
  const EdgeRays& edges = every_key().edge_rays.at(0);
  EXPECT_EQ(edges.from, 1u);
  EXPECT_EQ(edges.against, 0u);
  EXPECT_EQ(edges.stroke.width, 4);
  EXPECT_EQ(edges.inside.r, 0x88);
  EXPECT_EQ(edges.enter.r, 0x99);
  EXPECT_EQ(edges.exit.r, 0xaa);
  EXPECT_EQ(edges.layer, 8);
}

TEST(SceneKeys, ChainsKeepTheOrderOfTheFile) {
  const MarkovChain& chain = every_key().chains.at(0);
  EXPECT_EQ(chain.name, "run");
  EXPECT_EQ(chain.hold, 10u);
  EXPECT_EQ(chain.states, (std::vector<std::string>{"STAND", "RUN", "DIE"}));
  EXPECT_EQ(chain.start, 0u);
}

TEST(SceneKeys, DefaultsAreThoseOfTheDocument) {
  const Scene scene = loaded("flatray = 1").scene;
  EXPECT_EQ(scene.film.width, 640);
  EXPECT_EQ(scene.film.height, 360);
  EXPECT_EQ(scene.film.background, (Colour{255, 255, 255, 255}));
  EXPECT_EQ(scene.film.coverage, Coverage::area);
  EXPECT_FALSE(scene.film.world);
  EXPECT_EQ(scene.frames, 1u);
  EXPECT_EQ(scene.fps, 24);
  EXPECT_EQ(scene.seed, 0u);
  EXPECT_TRUE(scene.entities.empty());
}

TEST(SceneKeys, WhatHasNeitherFillNorStrokeIsDressed) {
  const Scene scene =
      loaded(with_shape("circle = { radius = 1 }") +
             "[[entity]]\nshape = { segment = { from = [0, 0], to = [1, 0] } }\n"
             "[[entity]]\nshape = { circle = { radius = 1 } }\nstroke = { width = 2 }\n"
             "[[entity]]\nshape = { circle = { radius = 1 } }\nfill = \"none\"\n"
             "[[chamber]]\nshape = { circle = { radius = 1 } }\n")
          .scene;
  EXPECT_EQ(*scene.entities[0].fill, (Colour{0x33, 0x33, 0x33, 255}));
  EXPECT_FALSE(scene.entities[1].fill);
  EXPECT_EQ(scene.entities[1].stroke->width, 1.5);
  EXPECT_FALSE(scene.entities[2].fill);
  EXPECT_FALSE(scene.entities[3].fill);
  EXPECT_FALSE(scene.entities[3].stroke);
  EXPECT_EQ(scene.chambers[0].stroke->width, 1.5);
  EXPECT_EQ(scene.chambers[0].material, Material::mirror);
}

TEST(SceneKeys, InlineTablesAndTablesOfTheirOwnAreTheSame) {
  const Scene inlined = loaded("flatray = 1\nfilm = { size = [3, 4] }").scene;
  const Scene own = loaded("flatray = 1\n[film]\nsize = [3, 4]").scene;
  const Scene dotted = loaded("flatray = 1\nfilm.size = [3, 4]").scene;
  EXPECT_EQ(inlined.film.height, own.film.height);
  EXPECT_EQ(inlined.film.height, dotted.film.height);
  EXPECT_NE(inlined.hash, own.hash);
}

TEST(SceneKeys, HashesDependOnTextAndOverridesAlone) {
  const std::string text = with_shape("circle = { radius = 1 }");
  EXPECT_EQ(load_scene_text("a.toml", text)->scene.hash,
            load_scene_text("b/c.toml", text)->scene.hash);
  EXPECT_NE(loaded(text).scene.hash, loaded(text + " ").scene.hash);
  EXPECT_NE(loaded(text).scene.hash, loaded(text, {{"frames", "1"}}).scene.hash);
}

TEST(SceneKeys, WrongValuesAreRefused) {
  const Refused cases[] = {
      {"frames = 0", "2:10: error: frames is 0"},
      {"frames = 1000000001", "2:10: error: frames is 1000000001"},
      {"frames = 2.5", "2:10: error: frames is 2.5"},
      {"fps = 0", "2:7: error: fps is not above 0"},
      {"fps = 1e-310", "2:7: error: fps is below 1e-100"},
      {"seed = -1", "2:8: error: seed is -1"},
      {"film = 3", "2:8: error: film is a number, not a table"},
      {"film = { world = [[0, 0], [0, 1]] }", "2:18: error: film.world has no area"},
      {"film = { world = [[-1e308, 0], [1e308, 1]] }",
       "2:19: error: film.world[0] lies beyond 1e300"},
      {"film = { background = \"red\" }", "2:23: error: film.background 'red' is not a colour"},
      {"film = { background = \"#12345g\" }",
       "2:23: error: film.background '#12345g' is not a colour"},
      {"film = { background = 1979-05-27 }", "2:23: error: film.background is a date"},
      {"camera = { height = 0 }", "2:21: error: camera.height is not above 0"},
      {"camera = { motion = \"object\" }", "did you mean 'objects'?"},
      {"camera = { follow = \"e\", at = [1, 1] }\n[[entity]]\nname = \"e\"\nshape = { circle = { "
       "radius = 1 } }",
       "2:10: error: follow and at both say where the camera looks"},
      {"[[entity]]\ngroup = \"g\"\nshape = { circle = { radius = 1 } }",
       "there is no group yet: write one, or leave this out"},
      {"entity = 1", "2:10: error: entity is a number, not an array of tables"},
      {"[[entity]]", "2:1: error: entity needs 'shape'"},
      {"[[entity]]\nshape = {}", "3:9: error: entity.shape has 0 kinds, not one"},
      {"[[entity]]\nshape = { blob = {} }", "3:11: error: unknown shape 'blob'"},
      {"[[ray]]\nat = [0, 0]\ndirection = [0, 0.0]", "4:13: error: ray.direction has no length"},
      {"[[ray]]\nat = [0, 0]\ndirection = [0, 1]\nbounces = -1", "ray.bounces is -1"},
      {"[[ray]]\nat = [0, 0]\ndirection = [0, 1]\nstroke = { width = 1, width_px = 1 }",
       "5:23: error: stroke has both width and width_px"},
      {"[[ray]]\nat = [0, 0]\ndirection = [0, 1]\nstroke = { width = 0 }",
       "stroke.width is not above 0"},
      {"[[chamber]]\nshape = { circle = { radius = 1 } }\n[[chamber]]\nshape = { circle = { radius "
       "= 1 } }",
       "4:1: error: a second chamber"},
  };
  expect_refused(cases,
                 [](const std::string& text) { return refusal("flatray = 1\n" + text + "\n"); });
}

TEST(SceneKeys, NamesMayRepeatWhereNoOneCallsThem) {
  const std::string two = with_shape("circle = { radius = 1 }") +
                          "[[entity]]\nname = \"e\"\nshape = { circle = { radius = 1 } }\n";
  EXPECT_EQ(loaded(two).scene.entities.size(), 2u);
  EXPECT_NE(refusal(two + "[camera]\nfollow = \"e\"\n").find("two entities are named 'e'"),
            std::string::npos);
}

TEST(SceneKeys, StatesNeedAChainAndItsStates) {
  const std::string entity = with_shape("circle = { radius = 1 }");
  EXPECT_NE(refusal(entity + "states = { A = {} }\n").find("5:1: error: entity has states but no"),
            std::string::npos);
  const std::string chain = "[markov.c]\nSTAND = { STAND = 1 }\n";
  EXPECT_NE(
      refusal(entity + "markov = { chain = \"d\" }\n" + chain).find("unknown Markov chain 'd'"),
      std::string::npos);
  EXPECT_NE(refusal(entity + "markov = { chain = \"c\", start = \"STAMD\" }\n" + chain)
                .find("(did you mean 'STAND'?)"),
            std::string::npos);
  EXPECT_NE(refusal(entity + "markov = { chain = \"c\" }\nstates = { STAMD = {} }\n" + chain)
                .find("6:12: error: unknown state of chain 'c'"),
            std::string::npos);
}

// Found by fuzzing: the rays asked the only shape of the scene, which there was not.
TEST(Scenes, EdgeRaysOfAnEntityWithoutAShapeTellTheShapesMistakeAlone) {
  EXPECT_EQ(refusal("flatray = 1\n"
                    "[[entity]]\nname = \"a\"\nshape = { segment = { from = [1, 2] } }\n"
                    "[[edge_rays]]\nfrom = \"a\"\nagainst = \"a\"\n"),
            R"(t.toml:4:21: error: segment needs 'to'
    shape = { segment = { from = [1, 2] } }
                        ^~~~~~~~~~~~~~~~~  write to = [x, y] or a curve
)");
}

TEST(Scenes, EdgeRaysOfAnEntityWithoutStraightEdgesAreWarnedOf) {
  const auto warnings = [](const std::string& shape) {
    return loaded("flatray = 1\n[[entity]]\nname = 'a'\nshape = { " + shape +
                  " }\n[[entity]]\nname = 'b'\nshape = { circle = { radius = 1 } }\n"
                  "[[edge_rays]]\nfrom = 'a'\nagainst = 'b'\n")
        .warnings;
  };
  const Diagnostics told = warnings("circle = { radius = 1 }");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message, "has no straight edges: these rays draw nothing");
  EXPECT_EQ(warnings("ellipse = { radii = [2, 1] }").size(), 1U);
  EXPECT_EQ(warnings("bezier = { points = [[0, 0], [1, 1], [2, 1], [3, 0]] }").size(), 1U);
  for (const char* shape :
       {"box = { min = [0, 0], max = [1, 1] }", "segment = { from = [0, 0], to = [1, 0] }",
        "capsule = { from = [0, 0], to = [1, 0], radius = 1 }",
        "sector = { radius = 1, from = 0, to = 90 }"})
    EXPECT_TRUE(warnings(shape).empty()) << shape;
}

TEST(Film, ShowsNoWorldOfWhichAUnitHasNoNumberOfPixels) {
  const auto film = [](const std::string& side) {
    return "flatray = 1\nfilm = { size = [8, 8], world = [[0, 0], [" + side + ", " + side +
           "]] }\n";
  };
  EXPECT_EQ(loaded(film("8e-307")).scene.film.world->high.x(), 8e-307);
  EXPECT_NE(refusal(film("8e-309")).find("t.toml:2:"), std::string::npos);
}

}  // namespace
}  // namespace flatray
