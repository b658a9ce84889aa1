#include <gtest/gtest.h>

#include "geom/clip.h"

namespace flatray {
namespace {

TEST(StiffCases, A15RayAtCircleTangent) {
  const Ray ray{{-5, 10}, {4, -3}};
  const HitInterval touch = clip_circle(ray, {{0, 0}, 5});
  EXPECT_EQ(touch.kind, HitClass::touch);
  EXPECT_EQ(touch.t_enter, 2);
  EXPECT_EQ(touch.t_exit, 2);
  EXPECT_FALSE(clip_circle(ray, {{0, 0}, std::nextafter(5.0, 0.0)}));
  const HitInterval chord = clip_circle(ray, {{0, 0}, std::nextafter(5.0, 6.0)});
  EXPECT_EQ(chord.kind, HitClass::through);
  EXPECT_LT(chord.t_enter, 2);
  EXPECT_GT(chord.t_exit, 2);
}

TEST(StiffCases, A16FarCircle) {
  const HitInterval hit = clip_circle({{-1e8, 1 - 0x1p-53}, {1, 0}}, {{0, 0}, 1});
  EXPECT_EQ(hit.kind, HitClass::through);
  EXPECT_LT(hit.t_enter, hit.t_exit);
  EXPECT_EQ(hit.t_exit - hit.t_enter,
            2 * 0x1p-26);  // 2 ulps of 1e8, the nearest to a chord of 2.98e-8
}

TEST(StiffCases, B13OddCircles) {
  const Circle point{{2, 1}, 0};
  const HitInterval hit = clip_circle({{0, 0}, {2, 1}}, point);
  EXPECT_EQ(hit.kind, HitClass::touch);
  EXPECT_EQ(hit.t_enter, 1);
  EXPECT_FALSE(clip_circle({{0, 0x1p-1074}, {2, 1}}, point));

  const HitInterval smallest = clip_circle({{-1, 0}, {1, 0}}, {{0, 0}, 5e-324});
  EXPECT_EQ(smallest.kind, HitClass::through);
  EXPECT_EQ(smallest.t_enter, 1);
  EXPECT_EQ(clip_circle({{-1, 5e-324}, {1, 0}}, {{0, 0}, 5e-324}).kind, HitClass::touch);

  const HitInterval huge = clip_circle({{-1.5e308, 0}, {1e308, 0}}, {{0, 0}, 1e308});
  EXPECT_EQ(huge.kind, HitClass::through);
  EXPECT_EQ(huge.t_enter, 0.5);
  EXPECT_EQ(huge.t_exit, 2.5);
}

TEST(ClipCircle, StartPlaceIsExact) {
  EXPECT_EQ(clip_circle({{3, 4}, {1, 0}}, {{0, 0}, 5}).start, StartPlace::boundary);
  EXPECT_EQ(clip_circle({{3, 4}, {1, 0}}, {{0, 0}, 5}).kind, HitClass::touch);
  EXPECT_EQ(clip_circle({{3, 4}, {-1, 0}}, {{0, 0}, 5}).t_exit, 6);
  EXPECT_EQ(clip_circle({{3, std::nextafter(4.0, 0.0)}, {0, 0}}, {{0, 0}, 5}).kind,
            HitClass::through);
  EXPECT_EQ(clip_circle({{3, 4}, {0, 0}}, {{0, 0}, 5}).kind, HitClass::touch);
}

}  // namespace
}  // namespace flatray
