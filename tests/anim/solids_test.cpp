// needs: shapes/box shapes/circle shapes/polygon
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

}  // namespace
}  // namespace flatray
