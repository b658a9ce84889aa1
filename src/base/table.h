#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"

namespace flatray {

/// Rows of equal length under column names, the same in every form they are written in; as JSON one
/// object a row.
struct Table {
  using EachRow = std::function<void(const Values& row)>;

  std::vector<std::string> columns;  ///< none: rows without a head
  std::vector<Values> rows;
  /// Makes the rows that are too many to be kept, which follow `rows`: in order, the same each
  /// time.
  std::function<void(const EachRow&)> made{};

  Table() = default;
  explicit Table(std::vector<std::string> names, std::vector<Values> all = {})
      : columns(std::move(names)), rows(std::move(all)) {}

  /// Needs   as many cells as columns.
  void add(Values row);
  void each_row(const EachRow& each) const;
};

/// How a table looks on a terminal.
struct TextStyle {
  std::string indent{};  ///< before each line
  bool brief = false;    ///< measures to six digits, and no column in which nothing stands
};

/// Columns lined up with blanks, those with numbers to the right.
std::string aligned_text(const Table& table, const TextStyle& style = {});
/// A line of names, then rows; fields of base/shown_text.h, lines that end in '\n', numbers shortest
/// round-trip.
std::string csv_text(const Table& table);

}  // namespace flatray
