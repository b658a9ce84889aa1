#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "render/coverage/pixel_area.h"
#include "render/scan_region.h"

namespace flatray {
namespace {

void add_ring(FillPath& path, const std::vector<Vec2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    path.edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

// Area of a path in [0, size]^2 by its pixels, one after another.
double area_of(const FillPath& path, int size) {
  double area = 0;
  scan(path, Coverage::area, {0, 0, size, size}, [&](int, int begin, int end, std::uint32_t steps) {
    area += (end - begin) * (static_cast<double>(steps) / kFullCoverage);
  });
  return area;
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
    add_ring(path, ring);
  }
  return path;
}

TEST(CrowdedCoverage, UprightBarsInOnePixelHaveTheirExactArea) {
  FillPath path;
  for (int i = 0; i < 50; ++i) {
    const double x = 3 + i / 64.0;
    add_ring(path, {{x, 4}, {x + 1 / 128.0, 4}, {x + 1 / 128.0, 6}, {x, 6}});
  }
  std::vector<std::uint32_t> seen;
  scan(path, Coverage::area, {0, 0, 8, 8},
       [&](int, int, int, std::uint32_t steps) { seen.push_back(steps); });
  const auto expected = static_cast<std::uint32_t>(50 / 128.0 * kFullCoverage + 0.5);
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{expected, expected}));
}

TEST(CrowdedCoverage, ACrowdIsWithinItsBoundOfItselfSixtyFourTimesLarger) {
  for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
    const FillPath small = triangles(1, rule), large = triangles(64, rule);
    double sideways = 0;
    for (const Segment& edge : small.edges) sideways += std::abs(edge.b.x() - edge.a.x());
    const double exact = area_of(large, 64) / (64 * 64);
    EXPECT_NEAR(area_of(small, 1), exact, sideways / (2 * kLeastStrips) + 2.0 / kFullCoverage);
    EXPECT_NEAR(area_of(small, 1), exact, 0.01) << "which strips miss by chance only";
  }
}

// However often a face is repeated, it is the face: also where its edges cross in one pixel.
TEST(CrowdedCoverage, FacesThatLieOnOneAnotherCoverWhatOneDoes) {
  const std::vector<Vec2> face = {{0.1, 0.1}, {3.3, 0.4}, {2.9, 3.1}, {0.3, 2.7}};
  for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
    FillPath once{{}, rule}, often{{}, rule};
    add_ring(once, face);
    for (int i = 0; i < 101; ++i) add_ring(often, face);
    const auto steps_of = [](const FillPath& path) {
      std::vector<std::uint32_t> all;
      scan(path, Coverage::area, {0, 0, 4, 4}, [&](int y, int begin, int end, std::uint32_t steps) {
        for (int x = begin; x < end; ++x)
          all.push_back(static_cast<std::uint32_t>(4 * y + x) << 20 | steps);
      });
      return all;
    };
    EXPECT_EQ(steps_of(often), steps_of(once));
  }
}

TEST(CrowdedCoverage, ACoveredPixelIsFullAndOneBesideTheCrowdIsEmpty) {
  FillPath path = triangles(1, FillRule::nonzero);
  add_ring(path, {{-1, -1}, {3, -1}, {3, 3}, {-1, 3}});  // the way most triangles do not go
  add_ring(path, {{-1, -1}, {3, -1}, {3, 3}, {-1, 3}});
  for (int i = 0; i < 60; ++i) add_ring(path, {{-1, -1}, {3, -1}, {3, 3}, {-1, 3}});
  EXPECT_EQ(area_of(path, 2), 4);
  EXPECT_NEAR(area_of(triangles(1, FillRule::nonzero), 2),
              area_of(triangles(1, FillRule::nonzero), 1), 1e-4);
}

}  // namespace
}  // namespace flatray
