#include "render/coverage/pixel_rest.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/families.h"

namespace flatray {
namespace {

Piece piece(double x_top, double y_top, double x_bottom, double y_bottom, int direction = 1) {
  Piece made{};
  made.x_top = x_top, made.y_top = y_top, made.x_bottom = x_bottom, made.y_bottom = y_bottom;
  made.direction = direction;
  return made;
}

// Twice the area of a ring, positive where it goes from x to y.
double twice_area(const std::vector<Vec2>& ring) {
  double twice = 0;
  for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++)
    twice += ring[k].x() * ring[i].y() - ring[i].x() * ring[k].y();
  return twice;
}

// What of a convex ring is on one side of lines: on the right of them, or on the left.
std::vector<Vec2> within(std::vector<Vec2> ring, const Piece& line, double side) {
  const auto right = [&](const Vec2& p) {
    return side * ((p.x() - line.x_top) * (line.y_bottom - line.y_top) -
                   (p.y() - line.y_top) * (line.x_bottom - line.x_top));
  };
  std::vector<Vec2> kept;
  for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
    const double before = right(ring[k]), here = right(ring[i]);
    if ((before < 0) != (here < 0))
      kept.push_back(ring[k] + before / (before - here) * (ring[i] - ring[k]));
    if (here >= 0) kept.push_back(ring[i]);
  }
  return kept;
}

// From border to border of the pixel.
Piece random_line(oracle::Draw& draw) {
  const double a = draw.unit(), b = draw.unit();
  const int direction = draw.unit() < 0.5 ? 1 : -1;
  return draw.unit() < 0.5 ? piece(a, 0, b, 1, direction) : piece(0, a, 1, b, direction);
}

const std::vector<Vec2> kPixel = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(PixelRest, OfHalvesCutAcrossIsTheProductOfWhatEachLeaves) {
  PixelRest rest;
  EXPECT_EQ(rest.area(), 1);
  const Piece slant = piece(0.25, 0, 0.75, 1), level = piece(0, 0.25, 1, 0.25);
  EXPECT_EQ(rest.cut({&slant, 1}, 1), 0.5) << "right of it";
  EXPECT_EQ(rest.area(), 0.5);
  EXPECT_EQ(rest.cut({&level, 1}, -1), 0.421875) << "below it: 0.75 high, on average 0.5625 wide";
  EXPECT_EQ(rest.area(), 0.078125);
  rest.begin();
  EXPECT_EQ(rest.area(), 1);
}

// What is outside of all items is inside of one side of each line, where these are one a piece.
TEST(PixelRest, IsTheAreaOutsideOfAllItemsAndWhatEachTakesIsWhatTheyShare) {
  for (std::uint64_t item = 0; item < 3000; ++item) {
    oracle::Draw draw(2, 1, item);
    PixelRest rest;
    std::vector<Vec2> outside = kPixel;
    double taken = 0;
    for (int i = 0; i < 5; ++i) {
      const Piece line = random_line(draw);
      const int sign = draw.unit() < 0.5 ? 1 : -1;
      ASSERT_TRUE(PixelRest::can_cut({&line, 1}, sign));
      const std::optional<double> area = rest.cut({&line, 1}, sign);
      ASSERT_TRUE(area);
      EXPECT_GE(*area, 0);
      taken += *area;
      if (outside.size() > 2) outside = within(outside, line, -sign * line.direction);
      const double expected = outside.size() > 2 ? 0.5 * twice_area(outside) : 0;
      ASSERT_NEAR(rest.area(), expected, 0x1p-45) << item << " after " << i + 1;
      ASSERT_NEAR(taken, 1 - expected, 0x1p-45) << item << " after " << i + 1;
    }
  }
}

TEST(PixelRest, ACornerTakesWhatIsInsideOfBothItsSides) {
  std::size_t corners = 0;
  for (std::uint64_t item = 0; item < 2000; ++item) {
    oracle::Draw draw(2, 2, item);
    const Vec2 tip = draw.point();
    const Piece sides[] = {piece(draw.unit(), 0, tip.x(), tip.y(), 1),
                           piece(tip.x(), tip.y(), draw.unit(), 1, 1)};
    if (!PixelRest::can_cut(sides, 1)) continue;
    ++corners;
    PixelRest rest;
    const double expected = 0.5 * twice_area(within(within(kPixel, sides[0], 1), sides[1], 1));
    const std::optional<double> area = rest.cut(sides, 1);
    ASSERT_TRUE(area);
    ASSERT_NEAR(*area, expected, 0x1p-45) << item;
    ASSERT_NEAR(rest.area(), 1 - expected, 0x1p-45) << item;
  }
  EXPECT_GT(corners, 300U);
}

TEST(PixelRest, CutsNeitherPointsNorCurvesNorSidesThatTurnAway) {
  const Piece point = piece(0.5, 0.5, 0.5, 0.5);
  EXPECT_FALSE(PixelRest::can_cut({&point, 1}, 1));
  const Piece reflex[] = {piece(0.5, 0, 0.2, 0.5), piece(0.2, 0.5, 0.5, 1)};
  EXPECT_NE(PixelRest::can_cut(reflex, 1), PixelRest::can_cut(reflex, -1)) << "one of them";
}

}  // namespace
}  // namespace flatray
