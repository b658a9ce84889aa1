#include <gtest/gtest.h>

#include <cmath>

#include "oracle/families.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::Family;
using coverage_check::kFamilies;
using coverage_check::kFrame;
using coverage_check::make_region;
using coverage_check::RegionCase;
using coverage_check::ring_path;
using oracle::Draw;

std::size_t count_full(const Steps& steps) {
  return static_cast<std::size_t>(std::count(steps.begin(), steps.end(), kFullCoverage));
}

std::size_t centres(const FillRing& disc, const PixelBox& box) {
  return count_full(steps_of(disc, box, Coverage::centre));
}

TEST(StiffCases, E10CentresInsideDiscsOnAPixelCorner) {
  for (const auto& [r, expected] :
       {std::pair(7, 156U), std::pair(50, 7860U), std::pair(500, 785456U)}) {
    const PixelBox box{0, 0, 2 * r + 2, 2 * r + 2};
    const Vec2 corner(r + 1, r + 1);
    EXPECT_EQ(centres(FillRing{corner, static_cast<double>(r)}, box), expected) << r;
  }
}

TEST(StiffCases, E10TheTrianglesComplementTakesTheSlantedEdge) {
  const FillPath triangle = ring_path({{0, 0}, {100, 0}, {0, 100}}, false);
  const FillPath complement = ring_path({{100, 0}, {100, 100}, {0, 100}}, false);
  const PixelBox box{0, 0, 100, 100};
  const Steps inside = steps_of(triangle, box, Coverage::centre);
  const Steps outside = steps_of(complement, box, Coverage::centre);
  EXPECT_EQ(count_full(inside), 4950U);
  EXPECT_EQ(count_full(outside), 4950U + 100U);
  for (std::size_t i = 0; i < inside.size(); ++i) ASSERT_EQ(inside[i] + outside[i], kFullCoverage);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(outside[i * 100 + 99 - i], kFullCoverage);
}

// Whether the centre is in a convex piece, by the sides it lies on; one on an edge belongs to what
// lies right of it, or below a level edge.
bool holds(const std::vector<Vec2>& piece, const Vec2& p) {
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec2 &a = piece[i], &b = piece[(i + 1) % piece.size()];
    const Sign side = orientation(a, b, p);
    if (side == Sign::negative) return false;
    // Inside is where `orientation` is positive: y down, right of an edge that runs up.
    const bool takes = b.y() < a.y() || (b.y() == a.y() && b.x() > a.x());
    if (side == Sign::zero && !takes) return false;
  }
  return true;
}

TEST(CentreCoverage, EveryCentreOfEveryFamilyIsDecidedExactly) {
  for (const Family family : kFamilies) {
    if (family == Family::even_odd) continue;
    for (std::uint64_t item = 0; item < 60; ++item) {
      const RegionCase region = make_region(family, 13, item);
      const Steps steps = steps_of(region.path, kFrame, Coverage::centre);
      for (int y = 0; y < kFrame.height; ++y)
        for (int x = 0; x < kFrame.width; ++x) {
          const Vec2 centre(x + 0.5, y + 0.5);
          const bool inside = std::any_of(region.pieces.begin(), region.pieces.end(),
                                          [&](const auto& piece) { return holds(piece, centre); });
          ASSERT_EQ(steps[static_cast<std::size_t>(y * kFrame.width + x)],
                    inside ? kFullCoverage : 0U)
              << coverage_check::name(family) << ' ' << item << " (" << x << ", " << y << ')';
        }
    }
  }
}

TEST(CentreCoverage, ACircleThroughCentresGivesThemToTheSideOnTheirRight) {
  // 3-4-5: the circle of radius 5 about (5.5, 5.5) passes through twelve centres.
  const PixelBox box{0, 0, 11, 11};
  const std::size_t disc = centres(FillRing{{5.5, 5.5}, 5}, box);
  const std::size_t rest = centres(FillRing{{5.5, 5.5}, 20, 5}, box);
  EXPECT_EQ(disc + rest, 121U);
  EXPECT_EQ(disc,
            69U + 5U);  // 69 strictly inside; of the twelve, the left half and no top or bottom
}

// Positive outside the ellipse, zero on it.
Sign power(const EllipseArc& ellipse, const Vec2& p) {
  using Exact = Rational;
  const auto cross = [](const Exact& ax, const Exact& ay, const Exact& bx, const Exact& by) {
    return ax * by - ay * bx;
  };
  const Exact ux(ellipse.u.x()), uy(ellipse.u.y()), vx(ellipse.v.x()), vy(ellipse.v.y());
  const Exact wx = Exact(p.x()) - Exact(ellipse.centre.x());
  const Exact wy = Exact(p.y()) - Exact(ellipse.centre.y());
  const Exact a = cross(wx, wy, vx, vy), b = cross(ux, uy, wx, wy), size = cross(ux, uy, vx, vy);
  return (a * a + b * b - size * size).sign();
}

// Ellipses whose upper or lower end lies near a pixel's centre, as far as rounding lets it.
EllipseArc with_an_end_near(const Vec2& centre, bool round, Draw& draw) {
  const double size = std::ldexp(1 + draw.unit(), draw.whole(-2, 60));
  const double reach = draw.sign() > 0 ? 3 : 0x1p-10;
  const double aside = reach * (2 * draw.unit() - 1), over = draw.sign();
  const double slant = round ? 0 : draw.unit() - 0.5, flat = round ? 1 : 0.1 + draw.unit();
  EllipseArc ellipse{{0, 0}, {size, slant * size}, {0, flat * size}};
  const double height = round ? size : std::hypot(ellipse.u.y(), ellipse.v.y());
  const double end = ellipse.u.x() * ellipse.u.y() / height;
  const double sag = 0.5 * aside * aside * flat * flat / size;
  ellipse.centre = centre + Vec2(aside - over * end, -over * (height - sag));
  return ellipse;
}

// A long thin ellipse, from anywhere of its middle line.
EllipseArc needle_through(const Vec2& centre, Draw& draw) {
  const double length = std::ldexp(1 + draw.unit(), draw.whole(5, 60)), from = draw.unit() - 0.5;
  const double slope = 2 * (draw.unit() - 0.5), width = 1 + 3 * draw.unit();
  const Vec2 u(length, slope * length);
  return {centre - from * u, u, {0, width}};
}

void expect_exact(const EllipseArc& ellipse, bool round) {
  const PixelBox box{100, 100, 8, 8};
  const Steps steps = round
                          ? steps_of(FillRing{ellipse.centre, ellipse.u.x()}, box, Coverage::centre)
                          : steps_of(FillArcs{{{ellipse}, true}}, box, Coverage::centre);
  for (int row = box.y; row < box.bottom(); ++row)
    for (int column = box.x; column < box.right(); ++column) {
      const Sign outside = power(ellipse, Vec2(column + 0.5, row + 0.5));
      if (outside == Sign::zero) continue;
      const auto at = static_cast<std::size_t>((row - box.y) * box.width + column - box.x);
      ASSERT_EQ(steps[at], outside == Sign::negative ? kFullCoverage : 0U)
          << '(' << column << ", " << row << ')';
    }
}

TEST(CentreCoverage, EndsOfEllipsesOfAnySizeAreExact) {
  for (std::uint64_t item = 0; item < 3000; ++item) {
    SCOPED_TRACE(item);
    Draw draw(17, 3, item);
    const Vec2 centre = Vec2(0.5, 0.5) + draw.whole_point(103, 106);
    const bool round = item % 2 == 0;
    ASSERT_NO_FATAL_FAILURE(expect_exact(with_an_end_near(centre, round, draw), round));
  }
}

TEST(CentreCoverage, NeedlesOfAnyLengthAreExact) {
  for (std::uint64_t item = 0; item < 1000; ++item) {
    SCOPED_TRACE(item);
    Draw draw(17, 4, item);
    const Vec2 centre = Vec2(0.5, 0.5) + draw.whole_point(101, 107);
    ASSERT_NO_FATAL_FAILURE(expect_exact(needle_through(centre, draw), false));
  }
}

}  // namespace
}  // namespace flatray
