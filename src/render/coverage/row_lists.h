#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatray {

/// Numbers that each stand in a stretch of neighbouring rows: which stand in a row? A stretch is
/// kept as the few blocks of 2^k rows that make it up.
///
/// Cost    4 bytes for each number and block: one where it stands in one row or in all, never more
///         than 2 log2(rows).
class RowLists {
 public:
  explicit RowLists(std::size_t rows = 0);

  /// In rows [first, last].
  /// Needs   numbers that rise from call to call.
  void add(std::uint32_t number, std::size_t first, std::size_t last);
  /// Those in a row, rising. Cost O(numbers there * log(rows)) at most.
  void list(std::size_t row, std::vector<std::uint32_t>& out) const;

 private:
  std::size_t rows_ = 0, leaves_ = 0;
  std::vector<std::vector<std::uint32_t>> blocks_;  ///< block b is made of blocks 2 b and 2 b + 1
};

}  // namespace flatray
