#include "render/coverage/row_pieces.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

// What an edge has beyond the rows of its item would be taken with the next one's.
TEST(RowCutter, CutsEdgesInTheRowsThatAreAskedForAndInNoOther) {
  constexpr PixelBox kBox{0, 10, 16, 8}, kRows{0, 12, 16, 3};
  for (const auto& [coverage, rays] : {std::pair(Coverage::area, 0), std::pair(Coverage::rows, 4),
                                       std::pair(Coverage::centre, 1)}) {
    ScanEdges edges(16, 32);
    edges.add(Segment{{1, 0}, {14, 32}});
    RowCutter cutter;
    cutter.begin(kBox, coverage, rays);
    cutter.cut(edges.edges().front(), kRows);
    for (int row = kBox.y; row < kBox.bottom(); ++row)
      EXPECT_EQ(cutter.row(row).size(), row >= kRows.y && row < kRows.bottom() ? 1U : 0U) << row;
  }
}

}  // namespace
}  // namespace flatray
