#include "render/coverage_monotone.h"

#include <gtest/gtest.h>

#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::convex;
using coverage_check::Draws;
using coverage_check::Family;
using Steps = std::vector<std::uint32_t>;

constexpr std::array kBoxes{PixelBox{0, 0, 9, 9}, PixelBox{3, 2, 4, 5}, PixelBox{-4, -3, 19, 21},
                            PixelBox{0, 4, 64, 1}};

Steps expanded(const RunList& list, const PixelBox& box) {
  Steps steps(static_cast<std::size_t>(box.width * box.height));
  for (const Run& run : list.runs())
    for (int x = run.x_begin; x < run.x_end; ++x)
      steps.at(static_cast<std::size_t>((run.y - box.y) * box.width + x - box.x)) = run.steps;
  return steps;
}

Steps general(const FillPath& path, Coverage mode, const PixelBox& box) {
  RunList list;
  const kernels::SpanKernels& kernels = span_kernels(Isa::portable);
  if (mode == Coverage::area)
    AreaScan(kernels).scan(path, nullptr, box, list);
  else
    CentreScan(kernels).scan(path, nullptr, box, list);
  return expanded(list, box);
}

struct Decided {
  int yes = 0, all = 0;
};

// Every tier, mode and box: what is decided is what the general scan gives.
void compare(const FillPath& path, const std::string& label, Decided& decided) {
  std::vector<Corner> ring;
  ASSERT_TRUE(append_monotone_ring(path, path.edges.size(), ring)) << label;
  for (const Coverage mode : {Coverage::area, Coverage::centre})
    for (const PixelBox& box : kBoxes) {
      const Steps expected = general(path, mode, box);
      for (const Isa isa : available_isas()) {
        RunList list;
        ++decided.all;
        if (!MonotoneScan(span_kernels(isa)).scan(ring, mode, box, list)) {
          EXPECT_TRUE(list.runs().empty());
          continue;
        }
        ++decided.yes;
        EXPECT_EQ(expanded(list, box), expected) << label << ' ' << isa_name(isa) << ' ' << box.x;
      }
    }
}

FillPath ring_path(const std::vector<Vec2>& ring, bool reversed = false) {
  FillPath path;
  path.simple = true;
  coverage_check::add_ring(ring, reversed, path);
  return path;
}

// Of a convex ring: as it is, moved, enlarged, made tiny, put on a grid.
std::vector<Vec2> reshaped(std::vector<Vec2> ring, Draws& draws) {
  const Vec2 at(draws.unit() * 9, draws.unit() * 9);
  const double scale = std::ldexp(1.0, draws.below(22) - 10);
  const double flat = std::ldexp(1.0, -draws.below(12));
  const int kind = draws.below(3);
  for (Vec2& p : ring) {
    p = at + scale * (p - at);
    if (kind == 1) p.y() = at.y() + flat * (p.y() - at.y());
    if (kind == 2) p.x() = at.x() + flat * (p.x() - at.x());
  }
  return ring;
}

class MonotoneFamilies : public testing::TestWithParam<Family> {};

TEST_P(MonotoneFamilies, TheRunsAreThoseOfTheGeneralScan) {
  Decided decided;
  for (std::uint64_t item = 0; item < 150; ++item) {
    Draws draws(71, 8 * item + static_cast<std::uint64_t>(GetParam()));
    const std::vector<Vec2> ring = convex(GetParam(), draws);
    const std::string label = fmt::format("{} {}", coverage_check::name(GetParam()), item);
    const bool reversed = item % 2 == 1, near_film = GetParam() != Family::far;
    if (near_film) compare(ring_path(ring, reversed), label, decided);
    // Rounding may take a ring's convexity: only where it does not is it the path it says it is.
    const std::vector<Vec2> other = reshaped(ring, draws);
    const bool still = coverage_check::hull(other).size() == ring.size();
    std::vector<Corner> corners;
    const FillPath path = ring_path(other, reversed);
    if (still && append_monotone_ring(path, other.size(), corners))
      compare(path, label + " reshaped", decided);
  }
  EXPECT_GT(decided.all, 500);
  EXPECT_GT(decided.yes, GetParam() == Family::random ? 0.99 * decided.all : 0);
}
INSTANTIATE_TEST_SUITE_P(Families, MonotoneFamilies,
                         testing::Values(Family::random, Family::sliver, Family::decimal,
                                         Family::corner, Family::far));

TEST(MonotoneScan, DegenerateRingsCoverNothing) {
  for (const std::vector<Vec2>& ring : {std::vector<Vec2>{{1.25, 2.5}, {1.25, 2.5}, {1.25, 2.5}},
                                        std::vector<Vec2>{{1, 2.5}, {7, 2.5}, {3, 2.5}},
                                        std::vector<Vec2>{{1.3, 0.1}, {4.7, 8.9}, {1.3, 0.1}},
                                        std::vector<Vec2>{{3, -7}, {4, -1}, {2, -2}}}) {
    Decided decided;
    compare(ring_path(ring), "degenerate", decided);
    EXPECT_EQ(general(ring_path(ring), Coverage::area, kBoxes[0]), Steps(81));
  }
}

TEST(MonotoneScan, LevelEdgesAnywhereAreOfNeitherSide) {
  Decided decided;
  for (const double y : {1.0, 1.3, 2.0 - 0x1p-40}) {
    const std::vector<Vec2> steps{{1.1, y},   {4.3, y},       {6.2, y},       {6.9, y + 2.2},
                                  {7.7, 5.1}, {2.6, y + 5.3}, {0.4, y + 5.3}, {0.7, y + 1}};
    for (std::size_t turn = 0; turn < steps.size(); ++turn) {
      std::vector<Vec2> ring = steps;
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(turn), ring.end());
      compare(ring_path(ring, turn % 2 == 1), fmt::format("level {}", turn), decided);
    }
  }
  EXPECT_GT(decided.yes, decided.all / 2);
}

TEST(MonotoneRing, StartsAtATopmostCorner) {
  std::vector<Corner> corners;
  ASSERT_TRUE(append_monotone_ring(ring_path({{3, 5}, {1, 2}, {4, 1}}), 3, corners));
  ASSERT_EQ(corners.size(), 3U);
  EXPECT_EQ(corners[0].y, 1);
  EXPECT_EQ(corners[1].y, 5);
}

TEST(MonotoneRing, OtherPathsAreNone) {
  std::vector<Corner> corners;
  const FillPath twice_down = ring_path({{0, 0}, {2, 4}, {4, 1}, {6, 5}, {1, 9}});
  FillPath broken = ring_path({{0, 0}, {4, 1}, {2, 5}}), crossing = broken;
  broken.edges.pop_back();
  crossing.simple = false;
  const FillPath far = ring_path({{0, 0}, {1e6, 1}, {2, 5}});
  for (const FillPath& path : {twice_down, broken, crossing, far, FillPath{}})
    EXPECT_FALSE(append_monotone_ring(path, 99, corners));
  EXPECT_FALSE(append_monotone_ring(ring_path({{0, 0}, {4, 1}, {2, 5}}), 2, corners));
  EXPECT_TRUE(corners.empty());
}

}  // namespace
}  // namespace flatray
