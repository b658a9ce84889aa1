#include "oracle/nearest.h"

#include <gtest/gtest.h>

#include "oracle/families.h"

namespace flatray::oracle {
namespace {

const std::vector<Segment> kRoom = {{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}};

TEST(NearestWall, ACornerBelongsToTheLowestOfItsWalls) {
  const NearestWall corner = nearest_wall({{2, 2}, {1, 1}}, kRoom);
  EXPECT_EQ(corner.wall, 1);
  EXPECT_TRUE(corner.at_end);
  EXPECT_EQ(corner.kind, HitClass::touch);
  EXPECT_EQ(corner.t, 2);
}

TEST(NearestWall, AlongAWallIsMetAtItsFirstEndOrWhereTheRayStarts) {
  const NearestWall ahead = nearest_wall({{6, 0}, {-1, 0}}, std::span(kRoom).first(1));
  EXPECT_EQ(ahead.kind, HitClass::along);
  EXPECT_EQ(ahead.t, 2);
  EXPECT_TRUE(ahead.at_end);
  const NearestWall within = nearest_wall({{1, 0}, {-1, 0}}, std::span(kRoom).first(1));
  EXPECT_EQ(within.kind, HitClass::along);
  EXPECT_EQ(within.t, 0);
  EXPECT_FALSE(within.at_end);
  const NearestWall leaving = nearest_wall({{0, 0}, {-1, 0}}, std::span(kRoom).first(1));
  EXPECT_EQ(leaving.kind, HitClass::touch);
  EXPECT_FALSE(nearest_wall({{-1, 0}, {-1, 0}}, std::span(kRoom).first(1)));
}

TEST(NearestWall, AThirdIsTheDoubleNearestToAThird) {
  EXPECT_EQ(nearest_wall({{1, 1}, {0, -3}}, kRoom).t, 1.0 / 3);
}

TEST(NearestWall, WithoutADirectionIsWhatTheOriginLiesOn) {
  EXPECT_EQ(nearest_wall({{4, 1}, {0, 0}}, kRoom).wall, 1);
  EXPECT_TRUE(nearest_wall({{4, 4}, {0, 0}}, kRoom).at_end);
  EXPECT_FALSE(nearest_wall({{2, 2}, {0, 0}}, kRoom));
}

// A wall far smaller than all others, so that no unit holds both, changes no answer.
TEST(NearestWall, AWallOfAnotherScaleChangesNothing) {
  int rays = 0;
  for (const Family& family : families()) {
    if (family.name == std::string("denormal")) continue;  // where a factor loses bits
    AimedScene scene = make_scene(family, 3, 1);
    if (!scene.curves.empty() || !scene.beziers.empty()) continue;
    scene.rays.resize(16);
    std::vector<Segment> walls = scene.walls;
    walls.push_back({{0, 0x1p-1000}, {0, 0x1p-1000}});  // far below all others
    for (const Ray& ray : scene.rays) {
      const NearestWall a = nearest_wall(ray, scene.walls), b = nearest_wall(ray, walls);
      if (b.wall == static_cast<std::int64_t>(scene.walls.size())) continue;
      ++rays;
      EXPECT_EQ(a.wall, b.wall) << family.name;
      EXPECT_EQ(a.kind, b.kind) << family.name;
      EXPECT_EQ(a.at_end, b.at_end) << family.name;
      EXPECT_EQ(a.t, b.t) << family.name;
    }
  }
  EXPECT_GT(rays, 100);
}

// Walls ruled out by bounds change no answer; many rays need nothing else.
TEST(NearestWalls, AnswerAsIfEveryWallWereDecidedExactly) {
  int rays = 0, by_bounds = 0;
  for (const Family& family : families())
    for (std::uint64_t item = 0; item < 4; ++item) {
      const AimedScene scene = make_scene(family, 5, item);
      if (!scene.curves.empty() || !scene.beziers.empty()) continue;
      const Surfaces surfaces = scene.surfaces();
      NearestWalls walls(surfaces);
      for (const Ray& ray : scene.rays) {
        const NearestWall a = nearest_wall(ray, scene.walls), b = walls.of(ray);
        ++rays;
        by_bounds += b.by == NearestWall::By::bounds ? 1 : 0;
        EXPECT_EQ(a.wall, b.wall) << family.name;
        EXPECT_EQ(a.kind, b.kind) << family.name;
        EXPECT_EQ(a.at_end, b.at_end) << family.name;
        EXPECT_EQ(a.t, b.t) << family.name;
      }
    }
  EXPECT_GT(3 * by_bounds, rays);
}

// A ray that passes an end of a wall by an ulp, far from it, and one that does not.
TEST(Suspects, AreSureOnlyOfWhatTheBoundsTell) {
  const std::vector<Segment> wall = {{{4, 0}, {4, 4}}};
  std::vector<Candidate> candidates;
  find_candidates({{0, 2}, {1, 0}}, wall, candidates);
  ASSERT_EQ(candidates.size(), 1U);
  EXPECT_TRUE(candidates[0].sure);
  EXPECT_LE(candidates[0].low, 4);
  EXPECT_GE(candidates[0].high, 4);
  find_candidates({{0, 4}, {1, 0}}, wall, candidates);
  ASSERT_EQ(candidates.size(), 1U);
  EXPECT_FALSE(candidates[0].sure);
  find_candidates({{0, 4}, {1, 0x1p-50}}, wall, candidates);
  EXPECT_TRUE(candidates.empty());
}

}  // namespace
}  // namespace flatray::oracle
