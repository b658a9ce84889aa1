// needs: shapes/tokarsky shapes/penrose shapes/mushroom
// Rooms of which theorems say where orbits never come.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "anim/timeline.h"
#include "anim/world.h"
#include "scene/load.h"
#include "transport/chambers.h"

namespace flatray {
namespace {

Surfaces walls_of(const std::string& shape) {
  const auto loaded =
      load_scene_text("room.toml", "flatray = 1\n[[chamber]]\nshape = { " + shape + " }\n");
  EXPECT_TRUE(loaded.has_value());
  const Scene& scene = loaded->scene;
  return build_world(scene, at(Timeline(scene, scene.seed, 1), 1)).surfaces;
}

double distance_to(const Vec2& point, const Segment& line) {
  const Vec2 way = line.b - line.a, from = point - line.a;
  const double along = std::clamp(from.dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (from - along * way).norm();
}

// Tokarsky 1995: no ray from (2, 2) comes to (6, 2). One in the direction of whole numbers p, q
// without a common divisor ends in a corner after (p^2 + q^2)^(1/2), which doubles may pass by; until
// then it passes copies of the dark point at distances of whole multiples of 2 / (p^2 + q^2)^(1/2).
TEST(Tokarsky, NoRayFromTheCandleComesToTheDarkPoint) {
  const Surfaces walls = walls_of("tokarsky = { size = 1 }");
  const Vec2 dark(6, 2);
  double nearest = kInfinity;
  for (int p = -20; p <= 20; ++p)
    for (int q = -20; q <= 20; ++q) {
      if (std::gcd(p, q) != 1) continue;
      const double whole = std::sqrt(p * p + q * q);
      double length = 0;
      for (const OrbitLine& part : orbit_lines(in_mirrors(walls, {{2, 2}, Vec2(p, q)}, 200))) {
        length += (part.line.b - part.line.a).norm();
        if (length > whole - 1e-9) break;
        nearest = std::min(nearest, whole * distance_to(dark, part.line));
      }
    }
  EXPECT_NEAR(nearest, 2, 1e-9);
}

// The light of a lamp between the foci stays between them: of the walls of the alcoves, those
// beyond the foci, none is met.
TEST(Penrose, ALampInTheMiddleLeavesAllAlcovesDark) {
  const Surfaces walls = walls_of("penrose = { size = 1 }");
  ASSERT_EQ(walls.size(), 14U);
  const auto in_alcove = [&](std::uint32_t wall) {
    if (walls.segment_slot(wall) == kNoSurface) return false;
    const Segment& line = walls.segment(wall);
    return std::fabs(line.a.x() + line.b.x()) > 8;
  };
  std::size_t alcoves = 0;
  for (std::uint32_t i = 0; i < walls.size(); ++i) alcoves += in_alcove(i) ? 1 : 0;
  EXPECT_EQ(alcoves, 8U);
  std::vector<std::size_t> met(walls.size());
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.031415926 * k + 1e-4;
    watch(walls, {{0.1, 0.2}, {std::cos(angle), std::sin(angle)}}, 300,
          [&](const Bounce& bounce) { ++met[bounce.surface]; });
  }
  for (std::uint32_t i = 0; i < walls.size(); ++i) EXPECT_EQ(met[i] == 0, in_alcove(i)) << i;
}

// Lit from beyond the foci of the upper half, the lower alcoves stay dark.
TEST(Penrose, ALampInAnUpperAlcoveLeavesTheLowerOnesDark) {
  const Surfaces walls = walls_of("penrose = { size = 1 }");
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.031415926 * k + 1e-4;
    watch(walls, {{4.5, 3.1}, {std::cos(angle), std::sin(angle)}}, 300, [&](const Bounce& bounce) {
      EXPECT_FALSE(std::fabs(bounce.point.x()) > 4 && bounce.point.y() < -1 &&
                   bounce.point.y() > -3);
    });
  }
}

// An orbit of the cap that turns about its centre farther out than the stem is wide is that of the
// whole disc, folded: it keeps its distance from the centre.
TEST(Mushroom, OrbitsAboutTheStemStayInTheCap) {
  const Surfaces walls = walls_of("mushroom = { radius = 1, width = 0.6, height = 0.8 }");
  const double distance = 0.5;
  const auto stop = watch(walls, {{0, distance}, {1, 0}}, 100'000, [&](const Bounce& bounce) {
    EXPECT_GE(bounce.point.y(), 0);
    EXPECT_NEAR(std::fabs(cross(bounce.point, bounce.out)), distance, 1e-10);
  });
  EXPECT_EQ(stop.end, OrbitEnd::limit);
  bool in_stem = false;
  watch(walls, {{0, 0.2}, {1, 0.1}}, 1000,
        [&](const Bounce& bounce) { in_stem = in_stem || bounce.point.y() < -0.5; });
  EXPECT_TRUE(in_stem);
}

}  // namespace
}  // namespace flatray
