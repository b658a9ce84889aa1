#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace flatray {

/// A table of numbers as a file that numpy.load reads as one structured array, a record a row: little
/// end first, every double with all its bits.
/// Source  numpy's NEP 1, version 1.0 of the format.
class NpyTable {
 public:
  enum class Kind : std::uint8_t { whole, real };  ///< <u8, <f8
  struct Column {
    std::string name;  ///< letters, digits and _
    Kind kind;
  };
  NpyTable(const std::vector<Column>& columns, std::uint64_t rows);

  /// The next cell, row by row. Needs   the kind of its column.
  void add(std::uint64_t cell);
  void add(double cell);
  /// Needs   as many cells as the rows have.
  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Counts in rows as a file of the same format: an array of two dimensions, <u8.
/// Needs   as many counts as rows times columns.
std::string npy_grid(std::span<const std::uint64_t> counts, std::uint64_t rows,
                     std::uint64_t columns);

/// What a file made by these has before its numbers.
struct NpyHead {
  std::vector<NpyTable::Column> columns;  ///< none of a grid
  std::vector<std::uint64_t> shape;
  std::size_t size;  ///< bytes before the numbers
};
/// Needs   a file of an NpyTable or of npy_grid.
NpyHead head_of_npy(const std::string& file);

}  // namespace flatray
