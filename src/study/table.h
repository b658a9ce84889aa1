#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace flatray {

/// One value of a table: text, a count or a measure. Measures may be infinite.
using Cell = std::variant<std::string, std::uint64_t, double>;

/// Rows of results, the same in every form it is written in.
class Table {
 public:
  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

  /// Needs   as many cells as columns.
  void add(std::vector<Cell> row);

  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }

  /// Fields of base/shown_text.h, lines that end in '\n', numbers shortest round-trip.
  std::string csv() const;
  /// Columns side by side for a terminal, measures to six digits, counts and measures to the right; none
  /// of a column in which nothing stands.
  std::string text() const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<Cell>> rows_;
};

/// One JSON object of the given values, then a list of objects for each table. Infinity and NaN are
/// null.
std::string json_document(const std::vector<std::pair<std::string, Cell>>& values,
                          const std::vector<std::pair<std::string, const Table*>>& tables);

}  // namespace flatray
