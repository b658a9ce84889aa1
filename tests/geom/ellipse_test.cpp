#include "geom/ellipse.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

TEST(Ellipses, PartsRiseOrFallInBothCoordinatesAndShareTheirEnds) {
  for (const double sweep : {2 * kHalfTurn, -2 * kHalfTurn, 1.5, -4.0, 0.01}) {
    const EllipseArc arc{{3, -1}, {5, 2}, {-1, 0.5}, 0.7, sweep};
    const std::vector<MonotoneArc> parts = monotone_parts(arc);
    EXPECT_LE(parts.size(), 6U);
    EXPECT_EQ(parts.front().a, arc.start());
    EXPECT_EQ(parts.back().b, arc.end());
    for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_EQ(parts[i - 1].b, parts[i].a);
  }
}

TEST(Ellipses, TheBoxHoldsTheArcAndNoMore) {
  const Bounds whole = path_bounds({{EllipseArc{{1, 2}, {3, 0}, {4, 5}}}, true});
  EXPECT_DOUBLE_EQ(whole.high.x(), 6);  // half the width is |(3, 4)|
  EXPECT_DOUBLE_EQ(whole.low.y(), -3);
  const Bounds quarter =
      path_bounds({{EllipseArc{{0, 0}, {2, 0}, {0, 2}, 0, kHalfTurn / 2}}, false});
  EXPECT_NEAR(quarter.low.x(), 0, 1e-15);
  EXPECT_EQ(quarter.high, Vec2(2, 2));
}

TEST(Ellipses, ChordsStayWithinTheSagitta) {
  for (const double r : {0.1, 3.0, 100.0, 1e5}) {
    const std::vector<Vec2> points =
        flattened({{EllipseArc{{0, 0}, {r, 0}, {0, r}}}, true}, 1.0 / 256);
    EXPECT_EQ(points.front(), points.back());
    double most = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      most = std::max(most, r - (0.5 * (points[i] + points[i + 1])).norm());
    EXPECT_LE(most, 1.0 / 256) << r;
  }
}

TEST(Ellipses, FlatteningHasAnEnd) {
  EXPECT_LE(flattened({{EllipseArc{{0, 0}, {1e150, 0}, {0, 1e150}}}, true}, 1.0 / 256).size(),
            std::size_t{1} << 18);
  EXPECT_EQ(flattened({{EllipseArc{{4, 5}, {0, 0}, {0, 0}}}, true}, 1.0 / 256),
            (std::vector<Vec2>{{4, 5}}));
}

}  // namespace
}  // namespace flatray
