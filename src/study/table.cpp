#include "study/table.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {
namespace {

using Json = nlohmann::ordered_json;

std::string csv_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return csv_field(*text);
  if (const auto* count = std::get_if<std::uint64_t>(&cell)) return fmt::format("{}", *count);
  return number_text(std::get<double>(cell));
}

std::string shown(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return shown_text(*text);
  const auto* measure = std::get_if<double>(&cell);
  return measure != nullptr ? fmt::format("{:.6g}", *measure) : csv_cell(cell);
}

bool is_number(const Cell& cell) { return !std::holds_alternative<std::string>(cell); }

Json json_cell(const Cell& cell) {
  return std::visit([](const auto& value) { return Json(value); }, cell);
}

Json json_rows(const Table& table) {
  Json rows = Json::array();
  for (const std::vector<Cell>& row : table.rows()) {
    Json object = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns()[i]] = json_cell(row[i]);
    rows.push_back(std::move(object));
  }
  return rows;
}

std::string padded(const std::string& text, std::size_t to, bool right) {
  const std::string space(to - std::min(to, shown_width(text)), ' ');
  return right ? space + text : text + space;
}

}  // namespace

void Table::add(std::vector<Cell> row) {
  FLATRAY_CHECK(row.size() == columns_.size());
  rows_.push_back(std::move(row));
}

std::string Table::csv() const {
  std::string lines;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    lines += (i > 0 ? "," : "") + csv_field(columns_[i]);
  lines += '\n';
  for (const std::vector<Cell>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) lines += (i > 0 ? "," : "") + csv_cell(row[i]);
    lines += '\n';
  }
  return lines;
}

std::string Table::text() const {
  std::vector<std::string> lines(rows_.size() + 1);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (std::all_of(rows_.begin(), rows_.end(),
                    [i](const std::vector<Cell>& row) { return row[i] == Cell(std::string()); }) &&
        !rows_.empty())
      continue;
    std::size_t widest = shown_width(columns_[i]);
    for (const std::vector<Cell>& row : rows_)
      widest = std::max(widest, shown_width(shown(row[i])));
    const bool right = std::any_of(rows_.begin(), rows_.end(),
                                   [i](const std::vector<Cell>& row) { return is_number(row[i]); });
    const std::string gap = i > 0 ? "  " : "";
    lines[0] += gap + padded(columns_[i], widest, right);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      lines[k + 1] += gap + padded(shown(rows_[k][i]), widest, right);
  }
  std::string all;
  for (std::string& line : lines) all += line.erase(line.find_last_not_of(' ') + 1) + '\n';
  return all;
}

std::string json_document(const std::vector<std::pair<std::string, Cell>>& values,
                          const std::vector<std::pair<std::string, const Table*>>& tables) {
  Json document = Json::object();
  for (const auto& [key, value] : values) document[key] = json_cell(value);
  for (const auto& [key, table] : tables) document[key] = json_rows(*table);
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace flatray
