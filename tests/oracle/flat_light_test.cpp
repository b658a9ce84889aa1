// The short tracer of light against closed forms.
#include "oracle/flat_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flatray::oracle {
namespace {

constexpr double kPi = std::numbers::pi;

FlatScene point_lamp() {
  FlatScene scene;
  scene.left = scene.top = -4;
  scene.width = scene.height = 8;
  scene.lamps.push_back({2, {1, 0.5, 0}, {}, {}, {}, {}, {0, 360}});
  return scene;
}

FlatScene::Wall still_wall(double x, double y, double dx, double dy) {
  return {{x, x}, {y, y}, {dx, dx}, {dy, dy}};
}

TEST(FlatLight, OfAPointFallsWithTheDistance) {
  const FlatLight light = trace_flat(point_lamp(), 8, 8, 200000, 1);
  EXPECT_EQ(light.ways, 200000U);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      // The mean of 2 / (2 pi r) over the pixel, by 64 x 64 points.
      double mean = 0;
      for (int i = 0; i < 4096; ++i) {
        const double px = x - 4 + (i % 64 + 0.5) / 64, py = y - 4 + (i / 64 + 0.5) / 64;
        mean += 1 / (kPi * std::sqrt(px * px + py * py)) / 4096;
      }
      const auto pixel = static_cast<std::size_t>(3 * (8 * y + x));
      EXPECT_NEAR(light.rgb[pixel] / mean, 1, 0.03) << x << " " << y;
      EXPECT_DOUBLE_EQ(light.rgb[pixel + 1], 0.5 * light.rgb[pixel]);
      EXPECT_EQ(light.rgb[pixel + 2], 0);
    }
}

// Every leg in a closed room of walls that scatter is pi area / perimeter long in the mean, half of what
// is scattered leaves by the wall, and a third is absorbed: 1 + p/2 + (p/2)^2 + ... legs inside.
TEST(FlatLight, InARoomIsThatOfItsLegs) {
  FlatScene scene = point_lamp();
  for (FlatScene::Wall one : {still_wall(-3, -3, 6, 0), still_wall(-3, 3, 6, 0),
                              still_wall(-3, -3, 0, 6), still_wall(3, -3, 0, 6)}) {
    one.mirrored = 1;
    scene.walls.push_back(one);
  }
  const FlatLight dark = [&] {
    FlatScene black = scene;
    for (FlatScene::Wall& one : black.walls) one.mirrored = 0;
    return trace_flat(black, 16, 16, 40000, 2);
  }();
  for (FlatScene::Wall& one : scene.walls) one.mirrored = 0.5;
  const FlatLight lit = trace_flat(scene, 16, 16, 40000, 3);
  // One leg of a central lamp: the mean of 3 / max(|cos|, |sin|); each mirrored one is twice as long.
  const double leg = 3 * 4 / kPi * std::log(1 + std::sqrt(2.0));
  EXPECT_NEAR(dark.mean()[0] * 64 / 2 / leg, 1, 0.01);
  EXPECT_GT(lit.mean()[0], 1.9 * dark.mean()[0]);
  EXPECT_NEAR(static_cast<double>(lit.ways) / 40000, 2, 0.03);
  EXPECT_EQ(dark.rgb[0], 0);  // outside
}

TEST(FlatLight, WallsLetThroughAndTurnTheirMirrors) {
  FlatScene scene = point_lamp();
  scene.lamps[0].ray_angle = {0, 0};
  scene.lamps[0].y = {0.5, 0.5};
  scene.walls.push_back(still_wall(2.5, -4, 0, 8));
  scene.walls[0].through = 1;
  const auto row = [&](const FlatLight& light, int x, int y) {
    return light.rgb[static_cast<std::size_t>(3 * (8 * y + x))];
  };
  const FlatLight through = trace_flat(scene, 8, 8, 10, 1);
  EXPECT_NEAR(row(through, 7, 4), 2, 1e-9);
  scene.walls[0].through = 0;
  scene.walls[0].mirrored = 1;
  scene.walls[0].has_normal = true;
  scene.walls[0].normal = {180 + 45, 180 + 45};  // up and to the left: (1, 0) goes straight up
  const FlatLight turned = trace_flat(scene, 8, 8, 10, 1);
  EXPECT_NEAR(row(turned, 7, 4), 0, 1e-9);
  EXPECT_NEAR(row(turned, 5, 4), 2, 1e-9);
  EXPECT_NEAR(row(turned, 6, 4), 2, 1e-9);  // half a pixel across and half up
  EXPECT_NEAR(row(turned, 6, 0), 2, 1e-9);
}

}  // namespace
}  // namespace flatray::oracle
