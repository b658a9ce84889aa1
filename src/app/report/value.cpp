#include "app/report/value.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {
namespace {

using OrderedJson = nlohmann::ordered_json;

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Most texts are names in plain letters, which stand for themselves.
void add_quoted(std::string& out, const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return c >= ' ' && c <= '~' && c != '"' && c != '\\';
  });
  if (plain)
    out.append("\"").append(text).append("\"");
  else
    out += OrderedJson(text).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

void add_json(std::string& out, const JsonValue& value);

template <class Items, class Add>
void add_joined(std::string& out, char open, const Items& items, char close, const Add& add) {
  out += open;
  for (const auto& item : items) {
    if (&item != &items.front()) out += ',';
    add(item);
  }
  out += close;
}

void add_json(std::string& out, const JsonValue& value) {
  std::visit(Overloaded{[&](std::nullptr_t) { out += "null"; },
                        [&](bool truth) { out += truth ? "true" : "false"; },
                        [&](std::int64_t number) { out += std::to_string(number); },
                        [&](std::uint64_t number) { out += std::to_string(number); },
                        [&](double number) {
                          if (std::isfinite(number))
                            out += number_text(number);
                          else
                            add_quoted(out, number_text(number));
                        },
                        [&](const std::string& text) { add_quoted(out, text); },
                        [&](const WrittenJson& json) { out += json.text; },
                        [&](const Values& values) {
                          add_joined(out, '[', values, ']',
                                     [&](const JsonValue& item) { add_json(out, item); });
                        },
                        [&](const Fields& fields) {
                          add_joined(out, '{', fields, '}', [&](const auto& field) {
                            add_quoted(out, field.first);
                            out += ':';
                            add_json(out, field.second);
                          });
                        }},
             value.data);
}

bool is_number(const JsonValue& value) {
  return std::holds_alternative<double>(value.data) ||
         std::holds_alternative<std::int64_t>(value.data) ||
         std::holds_alternative<std::uint64_t>(value.data);
}

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
std::string shown_cell(const JsonValue& value) {
  return is_number(value) ? cell_text(value) : shown_text(cell_text(value));
}

struct Column {
  std::size_t width = 0;
  bool numbers = false;
};

std::vector<Column> columns_of(const ReportTable& table) {
  std::vector<Column> columns(table.rows.empty() ? table.columns.size()
                                                 : table.rows.front().size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) columns[i].width = table.columns[i].size();
  for (const Values& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      columns[i].width = std::max(columns[i].width, shown_width(shown_cell(row[i])));
      columns[i].numbers = columns[i].numbers || is_number(row[i]);
    }
  return columns;
}

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  const auto* fields = std::get_if<Fields>(&data);
  if (fields == nullptr) return nullptr;
  const auto found = std::find_if(fields->begin(), fields->end(),
                                  [&](const auto& field) { return field.first == name; });
  return found == fields->end() ? nullptr : &found->second;
}

std::optional<std::string> JsonValue::as_text() const {
  const auto* text = std::get_if<std::string>(&data);
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::string JsonValue::text_of(std::string_view name) const {
  const JsonValue* value = find(name);
  return value == nullptr ? "" : value->as_text().value_or("");
}

std::optional<std::uint64_t> JsonValue::as_whole() const {
  const auto* number = std::get_if<std::uint64_t>(&data);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

std::optional<double> JsonValue::as_number() const {
  return std::visit(
      [](const auto& value) -> std::optional<double> {
        using Type = std::decay_t<decltype(value)>;
        if constexpr (std::is_arithmetic_v<Type> && !std::is_same_v<Type, bool>)
          return static_cast<double>(value);
        else
          return std::nullopt;
      },
      data);
}

std::string json_text(const JsonValue& value) {
  std::string text;
  add_json(text, value);
  return text;
}

std::string indented_json(const JsonValue& value) {
  return OrderedJson::parse(json_text(value)).dump(2) + "\n";
}

std::string aligned_text(const ReportTable& table, const std::string& indent) {
  const std::vector<Column> columns = columns_of(table);
  std::string text;
  const auto add_line = [&](const Values& cells) {
    std::string line = indent;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string cell = shown_cell(cells[i]);
      const std::string pad(columns[i].width - shown_width(cell), ' ');
      line += (i == 0 ? "" : "  ") + (columns[i].numbers ? pad + cell : cell + pad);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  if (!table.columns.empty()) add_line(Values(table.columns.begin(), table.columns.end()));
  for (const Values& row : table.rows) add_line(row);
  return text;
}

std::string csv_line(const Values& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : ",") + csv_cell(cells[i]);
  return line + "\n";
}

std::string object_text(const std::vector<std::string>& columns, const Values& cells) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += i == 0 ? '{' : ',';
    add_quoted(text, columns[i]);
    text += ':';
    add_json(text, cells[i]);
  }
  return text + '}';
}

std::string csv_text(const ReportTable& table) {
  std::string text = csv_line(Values(table.columns.begin(), table.columns.end()));
  for (const Values& row : table.rows) text += csv_line(row);
  return text;
}

JsonValue as_objects(const ReportTable& table) {
  Values objects;
  for (const Values& row : table.rows) {
    Fields fields;
    for (std::size_t i = 0; i < row.size(); ++i) fields.emplace_back(table.columns[i], row[i]);
    objects.emplace_back(std::move(fields));
  }
  return objects;
}

}  // namespace flatray
