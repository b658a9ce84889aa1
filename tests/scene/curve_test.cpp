#include "scene/curve.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

using Ease = Curve::Ease;

TEST(Curve, IsItsKeysAtTheirTimesAndConstantOutside) {
  for (const Ease ease : {Ease::linear, Ease::smooth, Ease::step}) {
    const Curve curve{ease, {0.1, 0.7, 2, 3}, {0.3, -1e9, 7, 7.1}};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(value_at(curve, curve.times[i]), curve.values[i]);
    EXPECT_EQ(value_at(curve, -5), 0.3);
    EXPECT_EQ(value_at(curve, 99), 7.1);
  }
}

TEST(Curve, LinearIsInProportion) {
  const Curve curve{Ease::linear, {1, 3, 4}, {10, 20, 0}};
  EXPECT_EQ(value_at(curve, 1.5), 12.5);
  EXPECT_EQ(value_at(curve, 3.25), 15);
}

TEST(Curve, StepsJumpAtTheirKeys) {
  const Curve curve{Ease::step, {1, 3, 4}, {10, 20, 0}};
  EXPECT_EQ(value_at(curve, 2.999), 10);
  EXPECT_EQ(value_at(curve, 3), 20);
  EXPECT_EQ(value_at(curve, 3.5), 20);
  EXPECT_TRUE(cubic_between(curve, 1, 3).is_constant());
  EXPECT_EQ(cubic_between(curve, 1, 3)(0.9), 10);
}

TEST(Curve, SmoothBetweenTwoKeysIsTheCubicThatStartsAndEndsAtRest) {
  const Curve curve{Ease::smooth, {0, 1}, {0, 1}};
  for (int i = 0; i <= 8; ++i) {
    const double u = i / 8.0;
    EXPECT_EQ(value_at(curve, u), u * u * (3 - 2 * u));
  }
}

TEST(Curve, SmoothGoesOnThroughKeysThatRiseEvenly) {
  const Curve curve{Ease::smooth, {0, 1, 2}, {0, 1, 2}};
  const double step = 0x1p-20;
  EXPECT_NEAR((value_at(curve, 1 + step) - value_at(curve, 1 - step)) / (2 * step), 1, 1e-6);
  EXPECT_NEAR((value_at(curve, 2) - value_at(curve, 2 - step)) / step, 0, 1e-5);
}

// The same curve with other units of time and value: as a straight rise beyond its ends, however
// steep or flat.
TEST(Curve, SmoothOfSteepestAndFlattestKeysIsScaled) {
  const Curve curve{Ease::smooth, {0, 1, 2, 3}, {0, 1, 2, 3}};
  for (const auto& [time, value] : {std::pair(0x1p-96, 0x1p896), std::pair(0x1p900, 0x1p-170),
                                    std::pair(0x1p996, 0x1p-40), std::pair(0x1p-900, 0x1p90)}) {
    Curve scaled = curve;
    for (double& t : scaled.times) t *= time;
    for (double& v : scaled.values) v *= value;
    for (int i = 0; i <= 48; ++i) {
      const double t = i / 16.0;
      EXPECT_NEAR(value_at(scaled, t * time) / value, value_at(curve, t), 0x1p-50) << t;
      EXPECT_NEAR(
          cubic_between(scaled, std::floor(t) * time, (std::floor(t) + 1) * time)(0.5) / value,
          cubic_between(curve, std::floor(t), std::floor(t) + 1)(0.5), 0x1p-50);
    }
  }
}

TEST(Curve, SmoothNeverOvershoots) {
  const Curve curve{Ease::smooth, {0, 1, 1.1, 5, 6}, {0, 10, 10.5, 10.6, -3}};
  double last = -1;
  for (int i = 0; i <= 5000; ++i) {
    const double value = value_at(curve, i * 0.001);
    EXPECT_GE(value, last);  // rises to the key at 5
    last = value;
  }
  for (int i = 5000; i <= 6000; ++i) EXPECT_LE(value_at(curve, i * 0.001), 10.6);
}

Path square(bool closed) {
  Path path{{{0, 0}, {3, 0}, {3, 4}}, {0, 3, 7}, closed};
  if (closed) path.points.push_back({0, 0}), path.lengths.push_back(12);
  return path;
}

TEST(Path, IsWalkedByLength) {
  EXPECT_EQ(point_at(square(false), 0).at, Vec2(0, 0));
  EXPECT_EQ(point_at(square(false), 1.5).at, Vec2(1.5, 0));
  EXPECT_EQ(point_at(square(false), 3).at, Vec2(3, 0));
  EXPECT_EQ(point_at(square(false), 3).direction, Vec2(0, 4));
  EXPECT_EQ(point_at(square(false), 5).at, Vec2(3, 2));
}

TEST(Path, StandsAtItsEndsUnlessItIsClosed) {
  EXPECT_EQ(point_at(square(false), -1).at, Vec2(0, 0));
  EXPECT_EQ(point_at(square(false), 99).at, Vec2(3, 4));
  EXPECT_EQ(point_at(square(false), 99).direction, Vec2(0, 4));
  EXPECT_EQ(point_at(square(true), 12 + 1.5).at, Vec2(1.5, 0));
  EXPECT_EQ(point_at(square(true), 7 - 24).at, Vec2(3, 4));
  EXPECT_EQ(point_at(square(true), 12).at, Vec2(0, 0));
  EXPECT_EQ(point_at(square(true), 1e308 * 10).at, Vec2(0, 0));
}

}  // namespace
}  // namespace flatray
