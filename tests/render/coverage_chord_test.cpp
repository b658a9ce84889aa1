#include "render/coverage_chord.h"

#include <gtest/gtest.h>

#include "render/coverage_exact.h"
#include "render/coverage_families.h"

namespace flatray {
namespace {

using coverage_check::Draws;

std::uint32_t rational_steps(const ScanEdge& edge, int winding, int column, int row) {
  const Rational area = exact_area({&edge, 1}, winding, column, row, FillRule::nonzero);
  return static_cast<std::uint32_t>((area * Rational(kFullCoverage)).floor().nearest());
}

// Ends on whole pixels: many of the areas lie on a step, which no rounding could decide.
TEST(CoverageChord, DecidesAreasThatLieOnAStep) {
  int on_a_step = 0;
  for (std::uint64_t round = 0; round < 3000; ++round) {
    Draws draws(51, round);
    const auto whole = [&](int n) { return static_cast<double>(draws.below(n)); };
    const Segment segment{{whole(40), whole(4)}, {whole(40), 12 + whole(4)}};
    const ScanEdge edge = scan_edge(segment, {0, 0, 40, 16});
    const int row = 4 + draws.below(8), winding = draws.below(3) - 1;
    const RowCut cut = row_cut(edge, row);
    for (int column = std::min(cut.low, cut.high); column <= std::max(cut.low, cut.high);
         ++column) {
      const auto steps = chord_steps(edge, winding, column, row, FillRule::nonzero);
      ASSERT_TRUE(steps) << round;
      ASSERT_EQ(*steps, rational_steps(edge, winding, column, row)) << round << ' ' << column;
      const Rational exact =
          exact_area({&edge, 1}, winding, column, row, FillRule::nonzero) * Rational(kFullCoverage);
      on_a_step += exact == exact.floor() && *steps > 0 && *steps < kFullCoverage;
    }
  }
  EXPECT_GT(on_a_step, 500);
}

TEST(CoverageChord, IsRightWhereverItAnswers) {
  int answers = 0;
  for (std::uint64_t round = 0; round < 3000; ++round) {
    Draws draws(52, round);
    const auto point = [&] { return Vec2(6 * draws.unit() - 2, 6 * draws.unit() - 2); };
    const ScanEdge edge = scan_edge({point(), point()}, {0, 0, 2, 2});
    for (const int column : {0, 1})
      for (const int row : {0, 1}) {
        const auto steps = chord_steps(edge, 1, column, row, FillRule::nonzero);
        if (!steps) continue;
        ++answers;
        ASSERT_EQ(*steps, rational_steps(edge, 1, column, row)) << round << column << row;
      }
  }
  EXPECT_GT(answers, 3000);
}

TEST(CoverageChord, LeavesAnEdgeThatEndsInsideThePixel) {
  const PixelBox box{0, 0, 1, 1};
  EXPECT_FALSE(chord_steps(scan_edge({{0.5, -1}, {0.5, 0.5}}, box), 0, 0, 0, FillRule::nonzero));
  EXPECT_FALSE(chord_steps(scan_edge({{-1, 0.5}, {2, 0.5}}, box), 0, 0, 0, FillRule::nonzero));
}

}  // namespace
}  // namespace flatray
