#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "render/coverage/pixel_area.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::add_ring;

// Area of a path in [0, size]^2 by its pixels.
double area_of(const FillPath& path, int size) {
  return covered_area(steps_of(path, {0, 0, size, size}));
}

FillPath triangles(double scale, FillRule rule) {
  FillPath path;
  path.rule = rule;
  std::uint64_t draw = 0;
  const auto next = [&] {
    return static_cast<double>(random_bits(7, Stream::markov, draw++, 0) >> 11) * 0x1p-53;
  };
  const auto point = [&] {
    const double x = next(), y = next();
    return Vec2(x, y);
  };
  for (int i = 0; i < 60; ++i) {
    const Vec2 at = 0.8 * point();
    std::vector<Vec2> ring;
    for (int k = 0; k < 3; ++k) ring.emplace_back(scale * (at + 0.2 * point()));
    add_ring(ring, false, path);
  }
  return path;
}

TEST(CrowdedCoverage, UprightBarsInOnePixelHaveTheirExactArea) {
  FillPath path;
  for (int i = 0; i < 50; ++i) {
    const double x = 3 + i / 64.0;
    add_ring({{x, 4}, {x + 1 / 128.0, 4}, {x + 1 / 128.0, 6}, {x, 6}}, false, path);
  }
  Steps seen = steps_of(path, {0, 0, 8, 8});
  std::erase(seen, 0U);
  const auto expected = static_cast<std::uint32_t>(50 / 128.0 * kFullCoverage + 0.5);
  EXPECT_EQ(seen, (Steps{expected, expected}));
}

TEST(CrowdedCoverage, ACrowdIsWithinItsBoundOfItselfSixtyFourTimesLarger) {
  for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
    const FillPath small = triangles(1, rule), large = triangles(64, rule);
    double sideways = 0;
    for (const Segment& edge : small.edges) sideways += std::abs(edge.b.x() - edge.a.x());
    const double exact = area_of(large, 64) / (64 * 64);
    EXPECT_NEAR(area_of(small, 1), exact, sideways / (2 * kCrowd) + 2.0 / kFullCoverage);
    EXPECT_NEAR(area_of(small, 1), exact, 0.01) << "which strips miss by chance only";
  }
}

// However often a face is repeated, it is the face: also where its edges cross in one pixel.
TEST(CrowdedCoverage, FacesThatLieOnOneAnotherCoverWhatOneDoes) {
  const std::vector<Vec2> face = {{0.1, 0.1}, {3.3, 0.4}, {2.9, 3.1}, {0.3, 2.7}};
  for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
    FillPath once{{}, rule}, often{{}, rule};
    add_ring(face, false, once);
    for (int i = 0; i < 101; ++i) add_ring(face, false, often);
    EXPECT_EQ(steps_of(often, {0, 0, 4, 4}), steps_of(once, {0, 0, 4, 4}));
  }
}

TEST(CrowdedCoverage, ACoveredPixelIsFullAndOneBesideTheCrowdIsEmpty) {
  FillPath path = triangles(1, FillRule::nonzero);
  add_ring({{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}, false, path);  // the way most triangles do not go
  add_ring({{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}, false, path);
  for (int i = 0; i < 60; ++i) add_ring({{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}, false, path);
  EXPECT_EQ(area_of(path, 2), 4);
  EXPECT_NEAR(area_of(triangles(1, FillRule::nonzero), 2),
              area_of(triangles(1, FillRule::nonzero), 1), 1e-4);
}

}  // namespace
}  // namespace flatray
