// needs: shapes/ngon shapes/polyline shapes/star
#include <gtest/gtest.h>

#include "geom/clip.h"
#include "scene/outlines/corners.h"
#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string refused_corners(const std::string& shape) { return refusal(with_shape(shape)); }

std::vector<HitInterval> clips(const Shape& shape, const Ray& ray) {
  std::vector<HitInterval> hits;
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    hits.push_back(clip_convex(
        ray, std::span(shape.vertices).subspan(shape.begin[i], shape.begin[i + 1] - shape.begin[i]),
        kLine));
  return hits;
}

TEST(Corners, MultiplesOf90DegreesLieExactlyOnTheAxes) {
  const std::vector<Vec2> at_45 = corners({0, 0}, 4, 90, {2});
  EXPECT_EQ(at_45, (std::vector<Vec2>{{0, 2}, {-2, 0}, {0, -2}, {2, 0}}));
  for (const double angle : {-90.0, 270.0, 36000000270.0})
    EXPECT_EQ(corners({3, 1}, 8, angle, {1})[0], Vec2(3, 0)) << angle;
}

TEST(Corners, OppositeOnesAreOpposite) {
  for (const int count : {4, 6, 10, 14, 360}) {
    const std::vector<Vec2> ring = corners({0, 0}, count, 17.3, {1.7});
    for (std::size_t i = 0; i < ring.size() / 2; ++i)
      EXPECT_EQ(ring[i], Vec2(-ring[i + ring.size() / 2])) << count;
  }
}

TEST(Corners, TheirDistanceIsTheRadiusWithin2Ulp) {
  for (const Vec2& corner : corners({0, 0}, 997, 1, {1}))
    EXPECT_NEAR(corner.squaredNorm(), 1, 4 * 0x1p-52);
}

TEST(Shapes, AnNgonIsOneConvexPieceWithACornerOnTop) {
  const Shape shape = shape_of("ngon = { sides = 6, radius = 2, centre = [1, 1] }");
  ASSERT_EQ(shape.piece_count(), 1u);
  EXPECT_EQ(shape.vertices.size(), 6u);
  EXPECT_NE(std::find(shape.vertices.begin(), shape.vertices.end(), Vec2(1, 3)),
            shape.vertices.end());
}

TEST(Shapes, ARayThroughTheMiddleOfAnEvenNgonEntersAsFarAsItLeaves) {
  for (const int sides : {4, 6, 12, 100, 10000}) {
    const Shape shape =
        shape_of("ngon = { sides = " + std::to_string(sides) + ", radius = 1.7, angle = 11 }");
    for (const Vec2& direction : {Vec2(1, 0), Vec2(0.3, -2), Vec2(-1e-9, 1)}) {
      const HitInterval hit = clips(shape, {{0, 0}, direction}).front();
      EXPECT_EQ(hit.kind, HitClass::through);
      EXPECT_EQ(hit.t_enter, -hit.t_exit) << sides;
    }
  }
}

TEST(Shapes, AStarHasItsPointsOutsideAndItsNotchesInside) {
  const Shape shape = shape_of("star = { points = 5, outer = 3, inner = 1 }");
  EXPECT_GE(shape.piece_count(), 3u);
  double double_area = 0;
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    for (std::size_t k = shape.begin[i]; k < shape.begin[i + 1]; ++k)
      double_area += cross(shape.vertices[k],
                           shape.vertices[k + 1 < shape.begin[i + 1] ? k + 1 : shape.begin[i]]);
  // Ten triangles with sides 3 and 1 and 36 degrees between them: 10 * 3 * 1 * sin(36).
  EXPECT_NEAR(double_area, 10 * 3 * 0.58778525229247313, 1e-14);
  bool hit = false;
  for (const HitInterval& one : clips(shape, {{0, 4}, {0, -1}}))
    hit = hit || (one && one.t_enter == 1);
  EXPECT_TRUE(hit);  // the point on top
}

TEST(Shapes, APolylineIsItsSegmentsWhichShareTheirEnds) {
  const Shape open = shape_of("polyline = { points = [[0, 0], [2, 1], [2, 1], [4, 0]] }");
  ASSERT_EQ(open.segments.size(), 2u);
  EXPECT_EQ(open.segments[0].b, open.segments[1].a);
  EXPECT_EQ(open.segments[1].b, Vec2(4, 0));
  const Shape closed = shape_of("polyline = { points = [[0, 0], [2, 1], [4, 0]], closed = true }");
  ASSERT_EQ(closed.segments.size(), 3u);
  EXPECT_EQ(closed.segments[2].b, Vec2(0, 0));
}

TEST(Shapes, APolylineOfOnePointIsThatPoint) {
  const Shape shape = shape_of("polyline = { points = [[3, 4], [3, 4]], closed = true }");
  ASSERT_EQ(shape.circles.size(), 1u);
  EXPECT_EQ(shape.circles[0].centre, Vec2(3, 4));
  EXPECT_EQ(shape.circles[0].radius, 0);
}

TEST(Shapes, CornersLostInRoundingAreRefused) {
  EXPECT_NE(refused_corners("ngon = { sides = 6, radius = 1, centre = [1e17, 0] }")
                .find("error: the sides of the ngon are lost in rounding"),
            std::string::npos);
  EXPECT_NE(refused_corners("ngon = { sides = 100, radius = 5e-324 }").find("lost in rounding"),
            std::string::npos);
  EXPECT_NE(refused_corners("star = { points = 5, outer = 1e-20, inner = 5e-324, centre = [1, 1] }")
                .find("the points of the star are lost in rounding"),
            std::string::npos);
  EXPECT_EQ(shape_of("ngon = { sides = 7, radius = 1e300 }").vertices.size(), 7u);
  EXPECT_EQ(shape_of("ngon = { sides = 7, radius = 1e-300 }").vertices.size(), 7u);
}

TEST(Shapes, SizesAndCountsOfCornersHaveLimits) {
  const Refused cases[] = {
      {"ngon = { sides = 2, radius = 1 }", "ngon.sides is 2"},
      {"ngon = { sides = 10001, radius = 1 }", "it must be a whole number from 3 to 10000"},
      {"ngon = { sides = 3, radius = 0 }", "4:40: error: ngon.radius is 0"},
      {"ngon = { sides = 3, radius = 1e301 }", "write a number above 0, at most 1e300"},
      {"star = { points = 5, outer = 1, inner = -1 }", "star.inner is -1"},
      {"star = { points = 5, outer = 1 }", "star needs 'inner'"},
      {"star = { points = 1001, outer = 1, inner = 1 }", "from 3 to 1000"},
      {"polyline = { points = [] }", "polyline.points is empty"},
  };
  expect_refused(cases, refused_corners);
}

}  // namespace
}  // namespace flatray
