// needs: shapes/circle shapes/arc views/visibility tracers/brute
// Shadows of round walls that the point of a visibility view does not lie on.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "seen.h"

namespace flatray {
namespace {

constexpr double kRadius = 1.25;

// Of the way from p to the light, the square of how near it comes to the origin.
double nearest_squared(const Vec2& p, const Vec2& light) {
  const Vec2 way = light - p;
  const double t = std::clamp(-p.dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (p + t * way).squaredNorm();
}

// Whether the way crosses the circle in its upper half; each crossing is a root of a quadratic.
bool crosses_upper_half(const Vec2& p, const Vec2& light) {
  const Vec2 way = light - p;
  const double a = way.squaredNorm(), b = p.dot(way), c = p.squaredNorm() - kRadius * kRadius;
  if (b * b < a * c) return false;
  const double root = std::sqrt(b * b - a * c);
  for (const double t : {(-b - root) / a, (-b + root) / a})
    if (t >= 0 && t <= 1 && p.y() + t * way.y() > 0) return true;
  return false;
}

template <class Lit>
void expect_shape_lit(const std::string& shape, const Vec2& light, const Lit& lit) {
  expect_lit(
      "flatray = 1\nfilm = { size = [81, 81], world = [[-4, -4], [4, 4]] }\n"
      "[[entity]]\nshape = { " +
          shape + " }\nstroke = { width = 0.1, colour = \"#000000\" }\n",
      light, lit);
}

// A wall through the centres of pixels is lit on all of them.
TEST(View, WhatEndsOnAWallIsLit) {
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [40, 40], world = [[0, 0], [40, 40]] }\n"
      "[[entity]]\nshape = { segment = { from = [0, 40], to = [40, 0] } }\n");
  for (const Vec2& point : {Vec2(0.3, 0.7), Vec2(0.37, 5.1), Vec2(0.41, 5.1), Vec2(0.17, 39.3)}) {
    const Image seen = view_of(scene, "visibility", point);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(seen.at(i, i)[0], 255) << i;
  }
}

// Along its line, up to its near end all is lit, and nothing behind it.
TEST(View, AWallSeenAlongItselfHidesWhatIsBehindItsNearEnd) {
  for (const Vec2& way : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1), Vec2(-1, 1)}) {
    const Vec2 near = -3 * way, far = -5 * way;
    const Scene scene = scene_of(fmt::format(
        "flatray = 1\nfilm = {{ size = [17, 17], world = [[-8.5, -8.5], [8.5, 8.5]] }}\n"
        "[[entity]]\nshape = {{ segment = {{ from = [{}, {}], to = [{}, {}] }} }}\n",
        far.x(), far.y(), near.x(), near.y()));
    for (const double from : {-2.0, 0.0, 5.0, 8.0}) {
      const Image seen = view_of(scene, "visibility", from * way);
      for (int i = -8; i <= 8; ++i) {
        const Vec2 place = i * way;
        const bool lit =
            seen.at(8 + static_cast<int>(place.x()), 8 - static_cast<int>(place.y()))[0] == 255;
        EXPECT_EQ(lit, i >= -3) << place.transpose() << " from " << from;
      }
    }
  }
}

TEST(View, VisibilityIsThatOfThePointWhicheverMoves) {
  const auto seen = [](const std::string& motion) {
    const Scene scene = scene_of(
        "flatray = 1\nfps = 8\nfilm = { size = [64, 48] }\n[camera]\nat = [0, 0]\nheight = 12\n"
        "velocity = [4, 2]\nmotion = \"" +
        motion + "\"\n[[entity]]\nshape = { circle = { radius = 1 } }\nat = [3, 1]\n");
    const Timeline timeline(scene, scene.seed, 5);
    return draw_view({&view_called("visibility"), {1, 0.5}}, find_tracer("brute"), scene,
                     at(timeline, 5), {})
        .pixels;
  };
  EXPECT_EQ(seen("frame-origin"), seen("objects"));
}

// All of its inside and what is behind it.
TEST(View, ADiscIsDarkAndThrowsAShadow) {
  for (const Vec2& light : {Vec2(3.1, 0.57), Vec2(-1.9, -2.3)})
    expect_shape_lit("circle = { radius = 1.25 }", light,
                     [&](const Vec2& p) { return nearest_squared(p, light) > kRadius * kRadius; });
}

TEST(View, AnArcThrowsAShadowByItsHalfAlone) {
  const Vec2 light(0.11, 3.2);
  expect_shape_lit("arc = { centre = [0, 0], radius = 1.25, from = 0, to = 180 }", light,
                   [&](const Vec2& p) { return !crosses_upper_half(p, light); });
}

}  // namespace
}  // namespace flatray
