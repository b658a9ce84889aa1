#include <gtest/gtest.h>

#include <algorithm>

#include "base/portable_math.h"
#include "geom/clip.h"
#include "geom/polygon.h"
#include "oracle/exact.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

const Ring kStiffSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

struct Expected {
  HitClass kind;
  double enter = 1, exit = 0;
};
constexpr Expected kMiss{HitClass::miss};

struct StiffCase {
  Ring polygon;
  Ray ray;
  Range within;
  Expected expected;
};

// The answer itself, and B7: the same, to the bit, for every first vertex and both orientations.
void expect_clip(const StiffCase& c) {
  Ring ring = c.polygon;
  for (int reversal = 0; reversal < 2; ++reversal) {
    for (std::size_t first = 0; first < ring.size(); ++first) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      const HitInterval hit = clip_convex(c.ray, ring, c.within);
      EXPECT_STREQ(name(hit.kind), name(c.expected.kind));
      EXPECT_EQ(hit.t_enter, c.expected.enter);
      EXPECT_EQ(hit.t_exit, c.expected.exit);
      const oracle::Clip truth = oracle::clip_polygon(c.ray, ring, c.within);
      EXPECT_EQ(hit.edge_enter, truth.edge_enter);
      EXPECT_EQ(hit.edge_exit, truth.edge_exit);
    }
    std::reverse(ring.begin(), ring.end());
  }
}

Ring box(double low_x, double low_y, double high_x, double high_y) {
  return {{low_x, low_y}, {high_x, low_y}, {high_x, high_y}, {low_x, high_y}};
}

TEST(StiffCases, A1Huge) {
  expect_clip({box(-1e300, -1e300, 1e300, 1e300),
               {{-2e300, 0}, {4e300, 0}},
               kRay,
               {HitClass::through, 0.25, 0.75}});
}

TEST(StiffCases, A2Tiny) {
  expect_clip({box(-1e-300, -1e-300, 1e-300, 1e-300),
               {{-2e-300, 0}, {4e-300, 0}},
               kRay,
               {HitClass::through, 0.25, 0.75}});
}

TEST(StiffCases, A3Denormal) {
  const double u = 5e-324;
  expect_clip(
      {box(-u, -u, u, u), {{-2 * u, 0}, {4 * u, 0}}, kRay, {HitClass::through, 0.25, 0.75}});
}

TEST(StiffCases, A4Offset1e15) {
  expect_clip({box(1e15, 1e15, 1e15 + 1, 1e15 + 1),
               {{1e15 - 1, 1e15 + 0.5}, {3, 0}},
               kRay,
               {HitClass::through, 1.0 / 3, 2.0 / 3}});
}

// 1e16 and 1e16 + 1 read as one double, so the box is a vertical segment.
TEST(StiffCases, A5LostFeatureIsClippedAsASegment) {
  const double x = 1e16, same = 10000000000000001.0;
  ASSERT_EQ(x, same);
  expect_clip({box(x, 0, same, 1), {{0, 0.5}, {1e16, 0}}, kRay, {HitClass::touch, 1, 1}});
  expect_clip({box(x, 0, same, 1), {{x, -1}, {0, 1}}, kRay, {HitClass::along, 1, 2}});
  EXPECT_EQ(9007199254740992.0, 9007199254740993.0);
}

TEST(StiffCases, A6OneUlpRay) {
  const Ray ray{{1, 0.5}, {0x1p-52, 0}};
  expect_clip({box(1, 0, 2, 1), ray, kLine, {HitClass::through, 0, 0x1p52}});
  expect_clip({box(1, 0, 2, 1), ray, kSegment, {HitClass::through, 0, 1}});
}

TEST(StiffCases, A7NearParallelHit) {
  expect_clip({kStiffSquare, {{-1, -1e-17}, {1, 1e-17}}, kRay, {HitClass::through, 1, 2}});
}

TEST(StiffCases, A8NearParallelTouch) {
  expect_clip({kStiffSquare, {{-1, -2e-17}, {1, 1e-17}}, kRay, {HitClass::touch, 2, 2}});
}

TEST(StiffCases, A9NearParallelMiss) {
  expect_clip({kStiffSquare, {{-1, -3e-17}, {1, 1e-17}}, kRay, kMiss});
}

TEST(StiffCases, A10TopEdge) {
  expect_clip({kStiffSquare, {{-1, 1}, {1, 1e-17}}, kRay, kMiss});
  expect_clip({kStiffSquare, {{-1, 1 - 0x1p-53}, {1, 1e-17}}, kRay, {HitClass::through, 1, 2}});
}

TEST(StiffCases, A11DenormalSlope) {
  expect_clip({kStiffSquare, {{-1, -5e-324}, {2, 5e-324}}, kSegment, {HitClass::touch, 1, 1}});
}

TEST(StiffCases, A12LongDirection) {
  expect_clip(
      {kStiffSquare, {{-1, 0.5}, {0x1p1000, 0}}, kRay, {HitClass::through, 0x1p-1000, 0x1p-999}});
}

// As decimals, (0.1, 0.3), (0.2, 0.6), (0.3, 0.9) lie on y = 3 x. As doubles the middle one is a
// little off, and the verdict is the doubles'.
TEST(StiffCases, A14DecimalsAreTakenAsTheirDoubles) {
  const Ray ray{{0.1, 0.3}, {0.3 - 0.1, 0.9 - 0.3}};
  const Sign middle = side_of_ray(ray, {0.2, 0.6});
  const Rational cross =
      Rational(0.3 - 0.1) * (Rational(0.6) - 0.3) - Rational(0.9 - 0.3) * (Rational(0.2) - 0.1);
  EXPECT_EQ(middle, cross.sign());
  EXPECT_NE(middle, Sign::zero);
  const Ring triangle = {{0.2, 0.6}, {1, 0}, {1, 0.1}};
  EXPECT_EQ(clip_convex(ray, triangle, kLine).kind == HitClass::touch, middle == Sign::zero);
}

TEST(StiffCases, B1Sliver) {
  expect_clip(
      {{{0, 0}, {1, 0}, {0.5, 5e-324}}, {{0.5, 1}, {0, -1}}, kRay, {HitClass::through, 1, 1}});
}

TEST(StiffCases, B2SharedEdgeLeavesNoGap) {
  const Ring lower = {{0, 0}, {1, 0}, {0, 1}}, upper = {{1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k <= 1024; ++k) {
    const Ray up{{k / 1024.0, -1}, {0, 1}};
    const HitInterval a = clip_convex(up, lower), b = clip_convex(up, upper);
    ASSERT_EQ(a.t_enter, 1) << k;
    ASSERT_EQ(a.t_exit, b.t_enter) << k;
    ASSERT_EQ(b.t_exit, 2) << k;
  }
}

TEST(StiffCases, B3FanLeaksNoRayAtItsCentre) {
  constexpr int n = 1000;
  const Vec2 centre(1.0 / 3, 1.0 / 3);
  const double step = 2 * 3.14159265358979323846 / n;
  const auto rim = [&](int i) {
    return Vec2(centre.x() + portable::cos(step * i), centre.y() + portable::sin(step * i));
  };
  Ring ring;
  for (int i = 0; i < n; ++i) ring.push_back(rim(i));
  for (int k = 0; k < n; k += 7) {
    const Vec2 from = centre + 2 * Vec2(rim(k) - centre);
    const Ray ray{from, centre - from};
    double nearest = kInfinity;
    for (int i = 0; i < n; ++i) {
      const Ring piece = {centre, ring[static_cast<std::size_t>(i)],
                          ring[static_cast<std::size_t>((i + 1) % n)]};
      if (const HitInterval hit = clip_convex(ray, piece)) nearest = std::min(nearest, hit.t_enter);
    }
    const HitInterval whole = clip_convex(ray, ring);
    ASSERT_NEAR(nearest, whole.t_enter, 0x1p-53) << k;  // 1 ulp of 0.5
  }
}

TEST(StiffCases, B4AlongAnEdge) {
  expect_clip({kStiffSquare, {{-1, 1}, {1, 0}}, kRay, {HitClass::along, 1, 2}});
}

TEST(StiffCases, B5ThroughAVertex) {
  expect_clip({kStiffSquare, {{-1, -1}, {1, 1}}, kRay, {HitClass::through, 1, 2}});
  expect_clip({kStiffSquare, {{2, -1}, {-1, 1}}, kRay, {HitClass::through, 1, 2}});
}

TEST(StiffCases, B6VertexTouch) {
  expect_clip({kStiffSquare, {{-1, 0}, {1, 1}}, kRay, {HitClass::touch, 1, 1}});
}

TEST(StiffCases, B7EdgesThatTieAtAVertexGiveTheLowerNumberOfTheListAsGiven) {
  const Ray diagonal{{-1, -1}, {1, 1}};
  EXPECT_EQ(clip_convex(diagonal, kStiffSquare).edge_enter, 0);  // edges 3 and 0 meet at (0, 0)
  EXPECT_EQ(clip_convex(diagonal, kStiffSquare).edge_exit, 1);   // edges 1 and 2 meet at (1, 1)
  const Ring clockwise = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  EXPECT_EQ(clip_convex(diagonal, clockwise).edge_enter, 2);
  EXPECT_EQ(clip_convex(diagonal, clockwise).edge_exit, 0);
}

TEST(StiffCases, B8DuplicatesAndCollinearVerticesChangeNothing) {
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) {
    ring.insert(ring.end(), 3, kStiffSquare[i]);
    ring.push_back(0.5 * (kStiffSquare[i] + kStiffSquare[(i + 1) % 4]));
  }
  const Ray rays[] = {{{-1, 0.25}, {1, 0}}, {{-1, 1}, {1, 0}},   {{-1, -1}, {1, 1}},
                      {{-1, 0}, {1, 1}},    {{0.5, -1}, {0, 3}}, {{0.3, 0.3}, {0.1, 0.7}}};
  for (const Ray& ray : rays) {
    const HitInterval plain = clip_convex(ray, kStiffSquare);
    expect_clip({ring, ray, kRay, {plain.kind, plain.t_enter, plain.t_exit}});
  }
  EXPECT_EQ(clip_convex(rays[0], ring).edge_enter,
            15);  // from (0, 0.5) to (0, 0), the last as given
}

TEST(StiffCases, B9AreaZeroIsASegmentOrAPoint) {
  const Ring point = {{1, 1}, {1, 1}, {1, 1}}, segment = {{0, 0}, {2, 0}},
             three = {{0, 0}, {2, 0}, {1, 0}};
  expect_clip({point, {{0, 0}, {1, 1}}, kRay, {HitClass::touch, 1, 1}});
  expect_clip({point, {{0, 0}, {1, 2}}, kRay, kMiss});
  expect_clip({segment, {{1, -1}, {0, 2}}, kRay, {HitClass::touch, 0.5, 0.5}});
  expect_clip({three, {{1, -1}, {0, 2}}, kRay, {HitClass::touch, 0.5, 0.5}});
  expect_clip({three, {{-1, 0}, {1, 0}}, kRay, {HitClass::along, 1, 3}});
  expect_clip({three, {{-1, 1}, {1, 0}}, kRay, kMiss});
  expect_clip({three, {{3, -1}, {0, 1}}, kRay, kMiss});
}

TEST(StiffCases, B12ManyGonIsClipped) {
  Ring ring;
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    ring.push_back({portable::cos(angle), portable::sin(angle)});
  }
  const HitInterval hit = clip_convex({{-2, 0}, {1, 0}}, ring);
  EXPECT_EQ(hit.kind, HitClass::through);
  EXPECT_EQ(hit.t_enter, 1);
  EXPECT_EQ(hit.t_exit, 3);
}

}  // namespace
}  // namespace flatray
