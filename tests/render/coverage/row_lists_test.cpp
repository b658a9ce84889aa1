#include "render/coverage/row_lists.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(RowLists, ARowListsTheNumbersOfAllStretchesItIsInRising) {
  for (std::size_t rows = 1; rows <= 20; ++rows) {
    RowLists lists(rows);
    std::vector<Numbers> expected(rows);
    std::uint32_t number = 0;
    for (std::size_t first = 0; first < rows; ++first)
      for (std::size_t last = first; last < rows; ++last, ++number) {
        lists.add(number, first, last);
        for (std::size_t row = first; row <= last; ++row) expected[row].push_back(number);
      }
    Numbers found{7};
    for (std::size_t row = 0; row < rows; ++row) {
      lists.list(row, found);
      EXPECT_EQ(found, expected[row]) << rows << " rows, row " << row;
    }
  }
}

}  // namespace
}  // namespace flatray
