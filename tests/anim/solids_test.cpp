// needs: shapes/bezier shapes/segment shapes/capsule shapes/ellipse shapes/sector shapes/box shapes/circle shapes/polygon
#include "anim/solids.h"

#include <gtest/gtest.h>

#include "scene/load.h"

namespace flatray {
namespace {

constexpr const char* kRoom = R"(flatray = 1
[[chamber]]
name = "hall"
shape = { polygon = { points = [[0, 0], [4, 0], [4, 4], [2, 2], [0, 4]] } }
pillars = [{ name = "post", shape = { circle = { radius = 0.5 } }, at = [2, 1] }]
[[entity]]
name = "scenery"
shape = { box = { min = [0, 0], max = [4, 4] } }
[[entity]]
name = "mirror"
shape = { box = { min = [9, 9], max = [10, 10] } }
material = "mirror"
)";

TEST(Solids, HoldTheirBorderAndNothingElse) {
  auto loaded = load_scene_text("t.toml", kRoom);
  ASSERT_TRUE(loaded) << format(loaded.error());
  const Scene& scene = loaded->scene;
  const Solids solids(scene, at(Timeline(scene, 0, 1), 1));
  EXPECT_TRUE(solids.has_chamber());
  EXPECT_TRUE(solids.in_chamber({0, 4}));
  EXPECT_TRUE(solids.in_chamber({2, 2}));
  EXPECT_FALSE(solids.in_chamber({2, 2 + 0x1p-50}));
  EXPECT_FALSE(solids.holder({1, 3}));  // scenery is passed through
  const auto post = solids.holder({2.5, 1});
  ASSERT_TRUE(post);
  EXPECT_EQ(post->kind, SurfaceOwner::Kind::pillar);
  EXPECT_FALSE(solids.holder({2.5 + 0x1p-50, 1}));
  const auto mirror = solids.holder({9, 10});
  ASSERT_TRUE(mirror);
  EXPECT_EQ(mirror->index, 1U);
  EXPECT_NEAR(solids.free_area(), 12 - 0.25 * 3.141592653589793, 1e-15);
}

Solids solids_of(const std::string& shape) {
  auto loaded =
      load_scene_text("t.toml", "flatray = 1\n[[chamber]]\nname = \"room\"\nshape = " + shape);
  EXPECT_TRUE(loaded) << format(loaded.error());
  return {loaded->scene, at(Timeline(loaded->scene, 0, 1), 1)};
}

TEST(Solids, CurvedRoomsHoldWhatIsBetweenTheirWalls) {
  constexpr double pi = 3.141592653589793;
  const Solids stadium = solids_of("{ capsule = { from = [-1, 0], to = [1, 0], radius = 1 } }");
  for (const Vec2& inside : {Vec2(0, 0), Vec2(1.5, 0.5), Vec2(2, 0), Vec2(0, 1), Vec2(1, -1)})
    EXPECT_TRUE(stadium.in_chamber(inside)) << inside.transpose();
  for (const Vec2& outside : {Vec2(2 + 0x1p-50, 0), Vec2(1.9, 0.9), Vec2(0, 1 + 0x1p-50)})
    EXPECT_FALSE(stadium.in_chamber(outside)) << outside.transpose();
  EXPECT_NEAR(stadium.free_area(), 4 + pi, 1e-14);
  EXPECT_NEAR(solids_of("{ ellipse = { radii = [3, 2] } }").free_area(), 6 * pi, 1e-13);
  const Solids ring = solids_of("{ sector = { radius = 2, inner = 1, from = 0, to = 90 } }");
  EXPECT_TRUE(ring.in_chamber({1, 1}));
  EXPECT_FALSE(ring.in_chamber({0.5, 0.5}));
  EXPECT_NEAR(ring.free_area(), 0.75 * pi, 1e-14);
}

TEST(Solids, ARoomOfLinesHasNoOutside) {
  EXPECT_TRUE(solids_of("{ segment = { from = [0, 0], to = [1, 0] } }").in_chamber({5, 5}));
  EXPECT_TRUE(
      solids_of("{ bezier = { points = [[0, 0], [2, 3], [-1, 3], [0, 0]] } }").in_chamber({5, 5}));
}

}  // namespace
}  // namespace flatray
