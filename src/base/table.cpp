#include "base/table.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/check.h"
#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {
namespace {

bool is_number(const JsonValue& value) { return value.as_number().has_value(); }

// Texts bare, nothing for null.
std::string cell_text(const JsonValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  if (const auto* number = std::get_if<double>(&value.data)) return number_text(*number);
  if (std::holds_alternative<std::nullptr_t>(value.data)) return "";
  return json_text(value);
}

std::string csv_cell(const JsonValue& value) {
  return is_number(value) ? cell_text(value) : csv_field(cell_text(value));
}

// As people see it.
std::string shown_cell(const JsonValue& value, bool brief) {
  if (const auto* measure = std::get_if<double>(&value.data); measure != nullptr && brief)
    return fmt::format("{:.6g}", *measure);
  return is_number(value) ? cell_text(value) : shown_text(cell_text(value));
}

Values names(const Table& table) { return {table.columns.begin(), table.columns.end()}; }

struct Column {
  std::size_t width = 0;
  bool numbers = false, stands = false;  // something stands in it
};

std::vector<Column> columns_of(const Table& table, bool brief) {
  std::vector<Column> columns(table.columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    columns[i].width = shown_width(shown_text(table.columns[i]));
  bool any = false;
  table.each_row([&](const Values& row) {
    any = true;
    columns.resize(std::max(columns.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t width = shown_width(shown_cell(row[i], brief));
      columns[i].width = std::max(columns[i].width, width);
      columns[i].numbers = columns[i].numbers || is_number(row[i]);
      columns[i].stands = columns[i].stands || width > 0;
    }
  });
  for (Column& column : columns) column.stands = column.stands || !brief || !any;
  return columns;
}

}  // namespace

void Table::add(Values row) {
  FLATRAY_CHECK(row.size() == columns.size());
  rows.push_back(std::move(row));
}

void Table::each_row(const EachRow& each) const {
  for (const Values& row : rows) each(row);
  if (made) made(each);
}

std::string aligned_text(const Table& table, const TextStyle& style) {
  const std::vector<Column> columns = columns_of(table, style.brief);
  std::string text;
  const auto add_line = [&](const Values& cells) {
    std::string line = style.indent;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!columns[i].stands) continue;
      const std::string cell = shown_cell(cells[i], style.brief);
      const std::string pad(columns[i].width - shown_width(cell), ' ');
      line += (i == 0 ? "" : "  ") + (columns[i].numbers ? pad + cell : cell + pad);
    }
    text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
  };
  if (!table.columns.empty()) add_line(names(table));
  table.each_row(add_line);
  return text;
}

std::string csv_text(const Table& table) {
  std::string text;
  const auto add_line = [&](const Values& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : ",") + csv_cell(cells[i]);
    text += '\n';
  };
  add_line(names(table));
  table.each_row(add_line);
  return text;
}

}  // namespace flatray
