#include <gtest/gtest.h>

#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::add_ring;
using coverage_check::Family;
using coverage_check::kFamilies;
using coverage_check::kFrame;
using coverage_check::make_region;
using coverage_check::RegionCase;
using coverage_check::steps_of;
using Steps = std::vector<std::uint32_t>;

std::size_t count_full(const Steps& steps) {
  return static_cast<std::size_t>(std::count(steps.begin(), steps.end(), kFullCoverage));
}

template <class Shape>
std::size_t centres(const Shape& shape, const PixelBox& box) {
  std::size_t count = 0;
  scan(shape, Coverage::centre, box,
       [&](int, int from, int to, std::uint32_t) { count += static_cast<std::size_t>(to - from); });
  return count;
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
  FillPath triangle, complement;
  add_ring({{0, 0}, {100, 0}, {0, 100}}, false, triangle);
  add_ring({{100, 0}, {100, 100}, {0, 100}}, false, complement);
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

}  // namespace
}  // namespace flatray
