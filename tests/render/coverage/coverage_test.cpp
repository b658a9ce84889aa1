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
using coverage_check::ring_path;
using coverage_check::Tally;

class ExactCoverage : public testing::TestWithParam<Family> {};

TEST_P(ExactCoverage, EveryPixelOfEveryFamilyEqualsTheOracle) {
  const std::uint64_t count = coverage_check::share_of(GetParam(), 200);
  const Tally tally = coverage_check::run_family(GetParam(), 7, count);
  fmt::print("{}\n", coverage_check::line(GetParam(), tally));
  EXPECT_EQ(tally.mismatches, 0U) << tally.first_mismatch;
  EXPECT_EQ(tally.pixels, count * 81);
}

INSTANTIATE_TEST_SUITE_P(Families, ExactCoverage, testing::ValuesIn(kFamilies),
                         [](const auto& family) { return coverage_check::name(family.param); });

TEST(Coverage, ABoxOfWhichNothingIsSaidHasNoPixels) {
  const PixelBox box;
  EXPECT_EQ(box.right(), 0);
  EXPECT_EQ(box.bottom(), 0);
}

TEST(Coverage, HalfPixelsAndDiagonalsAreExact) {
  const Steps box =
      steps_of(ring_path({{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {0.5, 2.5}}), {0, 0, 3, 3});
  const std::uint32_t half = kFullCoverage / 2, quarter = (kFullCoverage + 2) / 4;
  EXPECT_EQ(box,
            (Steps{quarter, half, quarter, half, kFullCoverage, half, quarter, half, quarter}));
  const Steps triangle = steps_of(ring_path({{0, 0}, {3, 0}, {0, 3}}), {0, 0, 3, 3});
  EXPECT_EQ(triangle,
            (Steps{kFullCoverage, kFullCoverage, half, kFullCoverage, half, 0, half, 0, 0}));
}

TEST(Coverage, AThirdOfAPixelIsThat) {
  // Slope 1/3 cuts off 1/6, 1/2 and 5/6 of three pixels: 64770 / 6 = 10795.
  const Steps steps = steps_of(ring_path({{0, 0}, {3, 1}, {0, 1}}), {0, 0, 3, 1});
  EXPECT_EQ(steps, (Steps{53975, 32385, 10795}));
}

TEST(Coverage, AnyCropGivesTheSamePixels) {
  for (const Family family : kFamilies)
    for (std::uint64_t item = 0; item < 20; ++item) {
      const RegionCase region = make_region(family, 3, item);
      const Steps whole = steps_of(region.path, kFrame);
      const PixelBox crop{2, 3, 4, 5};
      const Steps part = steps_of(region.path, crop);
      for (int y = 0; y < crop.height; ++y)
        for (int x = 0; x < crop.width; ++x)
          ASSERT_EQ(part[static_cast<std::size_t>(y * crop.width + x)],
                    whole[static_cast<std::size_t>((y + crop.y) * kFrame.width + x + crop.x)])
              << coverage_check::name(family) << ' ' << item;
    }
}

FillPath moved(const FillPath& path, const auto& move) {
  FillPath out = path;
  for (Segment& edge : out.edges) edge = {move(edge.a), move(edge.b)};
  return out;
}

Steps mirrored(const Steps& steps, int width) {
  Steps out = steps;
  for (auto row = out.begin(); row != out.end(); row += width) std::reverse(row, row + width);
  return out;
}

// Coordinates on a grid of 1/64, so that the mirrored, shifted and doubled ones are exact.
FillPath grid_path(std::uint64_t item) {
  return moved(make_region(Family::overlap, 11, item).path, [](const Vec2& p) {
    return Vec2(std::floor(p.x() * 64) / 64, std::floor(p.y() * 64) / 64);
  });
}

TEST(Coverage, MirrorAndIntegerShiftMoveThePixels) {
  for (std::uint64_t item = 0; item < 30; ++item) {
    const FillPath path = grid_path(item);
    const Steps steps = steps_of(path, kFrame);
    const auto mirror = [](const Vec2& p) { return Vec2(9 - p.x(), p.y()); };
    ASSERT_EQ(steps_of(moved(path, mirror), kFrame), mirrored(steps, 9)) << item;
    const auto shift = [](const Vec2& p) { return Vec2(p.x() + 1000, p.y() + 517); };
    ASSERT_EQ(steps_of(moved(path, shift), {1000, 517, 9, 9}), steps) << item;
  }
}

TEST(Coverage, OrderAndDirectionOfTheEdgesDoNotMatter) {
  for (const Family family : kFamilies)
    for (std::uint64_t item = 0; item < 10; ++item) {
      FillPath path = make_region(family, 5, item).path;
      const Steps steps = steps_of(path, kFrame);
      std::reverse(path.edges.begin(), path.edges.end());
      ASSERT_EQ(steps_of(path, kFrame), steps);
      for (Segment& edge : path.edges) std::swap(edge.a, edge.b);
      ASSERT_EQ(steps_of(path, kFrame), steps);
    }
}

TEST(Coverage, FourPixelsOfTwiceTheScaleMakeOne) {
  for (std::uint64_t item = 0; item < 30; ++item) {
    const FillPath path = grid_path(item);
    const Steps one = steps_of(path, kFrame);
    const Steps four =
        steps_of(moved(path, [](const Vec2& p) { return Vec2(2 * p); }), {0, 0, 18, 18});
    for (std::size_t y = 0; y < 9; ++y)
      for (std::size_t x = 0; x < 9; ++x) {
        const std::size_t at = 2 * y * 18 + 2 * x;
        const double sum = four[at] + four[at + 1] + four[at + 18] + four[at + 19];
        ASSERT_NEAR(sum / 4, one[y * 9 + x], 1.01) << item;
      }
  }
}

TEST(Coverage, ThePixelsSumToThePolygonsArea) {
  const Steps steps = steps_of(ring_path({{0.3, 0.2}, {8.7, 1.1}, {6.1, 8.9}, {1.9, 7.3}}), kFrame);
  const double area = 0.5 * std::abs(0.3 * 1.1 - 8.7 * 0.2 + 8.7 * 8.9 - 6.1 * 1.1 + 6.1 * 7.3 -
                                     1.9 * 8.9 + 1.9 * 0.2 - 0.3 * 7.3);
  EXPECT_NEAR(covered_area(steps), area, 81.0 / kFullCoverage);
}

TEST(Coverage, AnEdgeOfHugeCoordinatesIsStillExact) {
  // The line y = x / 2 through the pixel, from ends no double can interpolate between.
  const Steps steps =
      steps_of(ring_path({{-1e300, -5e299}, {1e300, 5e299}, {-1e300, 1e300}}), {0, 0, 2, 1});
  EXPECT_EQ(steps, (Steps{48578, 16193}));
}

TEST(StiffCases, B10BowTieByEvenOddCoversHalf) {
  const std::vector<Vec2> bow_tie{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  FillPath path = ring_path(bow_tie, false);
  path.rule = FillRule::even_odd;
  EXPECT_EQ(steps_of(path, {0, 0, 1, 1}), Steps{kFullCoverage / 2});
  path.rule = FillRule::nonzero;
  EXPECT_EQ(steps_of(path, {0, 0, 1, 1}), Steps{kFullCoverage / 2});
}

TEST(StiffCases, B2TrianglesOnOneEdgeTileTheSquare) {
  for (const double size : {7.0, 7.3, 8.999}) {
    const FillPath one = ring_path({{0, 0}, {size, 0}, {0, size}});
    const FillPath two = ring_path({{size, 0}, {size, size}, {0, size}});
    FillPath both = one;
    both.simple = false;
    both.edges.insert(both.edges.end(), two.edges.begin(), two.edges.end());
    const Steps square = steps_of(ring_path({{0, 0}, {size, 0}, {size, size}, {0, size}}), kFrame);
    const Steps a = steps_of(one, kFrame), b = steps_of(two, kFrame);
    EXPECT_EQ(steps_of(both, kFrame), square) << "a seam inside";
    for (std::size_t i = 0; i < square.size(); ++i) {
      EXPECT_NEAR(a[i] + b[i], square[i], 1.01);
    }
    const Steps centre_square =
        steps_of(ring_path({{0, 0}, {size, 0}, {size, size}, {0, size}}), kFrame, Coverage::centre);
    const Steps ca = steps_of(one, kFrame, Coverage::centre);
    const Steps cb = steps_of(two, kFrame, Coverage::centre);
    for (std::size_t i = 0; i < square.size(); ++i) EXPECT_EQ(ca[i] + cb[i], centre_square[i]);
  }
}

TEST(Coverage, AVertexInsideACoveredPixelLeavesItFull) {
  // A pentagon's corner within a box: winding 1 and 2, never 0.
  FillPath path = ring_path({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, false);
  add_ring({{2.3, 3.1}, {5.7, 2.2}, {7.1, 5.6}, {4.4, 7.9}, {1.7, 6.3}}, false, path);
  const Steps steps = steps_of(path, kFrame);
  EXPECT_EQ(steps, Steps(81, kFullCoverage));
}

}  // namespace
}  // namespace flatray
