#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace flatray {

/// What a verb reports, before it is JSON, CSV or a table for people.
struct JsonValue;
using Values = std::vector<JsonValue>;
using Fields = std::vector<std::pair<std::string, JsonValue>>;  ///< in the order shown

/// JSON that is written already: of rows too many to be kept as values.
struct WrittenJson {
  std::string text;
};

struct JsonValue {
  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Values,
               Fields, WrittenJson>
      data = nullptr;

  JsonValue() = default;
  JsonValue(bool value) : data(value) {}
  JsonValue(int value) : data(std::int64_t{value}) {}
  JsonValue(unsigned value) : data(std::uint64_t{value}) {}
  JsonValue(std::uint64_t value) : data(value) {}
  JsonValue(double value) : data(value) {}
  JsonValue(std::string value) : data(std::move(value)) {}
  JsonValue(const char* value) : data(std::string(value)) {}
  JsonValue(Values value) : data(std::move(value)) {}
  JsonValue(Fields value) : data(std::move(value)) {}
  JsonValue(WrittenJson value) : data(std::move(value)) {}

  /// The field of that name, or nullptr where there is none or this is no object.
  const JsonValue* find(std::string_view name) const;
  std::optional<std::string> as_text() const;
  /// The text of the field of that name, "" where there is none that is a text.
  std::string text_of(std::string_view name) const;
  /// A whole number that is not negative.
  std::optional<std::uint64_t> as_whole() const;
  /// Any number, rounded where it is a large whole one.
  std::optional<double> as_number() const;
};

/// One line of JSON. Numbers are shortest round-trip; infinities, which JSON lacks, are the texts
/// "inf" and "-inf"; bytes that are not UTF-8 become U+FFFD.
std::string json_text(const JsonValue& value);
/// The same over many lines, two blanks a level.
std::string indented_json(const JsonValue& value);
/// What keeps a text from being JSON, and the byte at which that shows, from 1.
struct JsonMistake {
  std::size_t byte;
  std::string what;
};
/// Numbers are rounded once; of a name given twice in an object the first counts. Nested at most
/// 64 deep.
tl::expected<JsonValue, JsonMistake> read_json(std::string_view text);
/// nullopt for what is not JSON.
std::optional<JsonValue> parse_json(std::string_view text);

/// Rows of equal length under column names.
struct ReportTable {
  std::vector<std::string> columns;
  std::vector<Values> rows;
};
/// Columns lined up with blanks, those with numbers to the right; without names the rows alone.
/// Each line begins with `indent`.
std::string aligned_text(const ReportTable& table, const std::string& indent = {});
/// A header line, then rows; fields of base/shown_text.h.
std::string csv_text(const ReportTable& table);
/// One object a row.
JsonValue as_objects(const ReportTable& table);
/// One row of csv_text, and one of as_objects as JSON: of tables too long to be kept.
std::string csv_line(const Values& cells);
std::string object_text(const std::vector<std::string>& columns, const Values& cells);

}  // namespace flatray
