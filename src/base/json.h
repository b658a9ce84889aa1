#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace flatray {

/// What is told as JSON, or as a cell of a table (base/table.h).
struct JsonValue;
struct Table;
using Values = std::vector<JsonValue>;
using Fields = std::vector<std::pair<std::string, JsonValue>>;  ///< in the order shown

struct JsonValue {
  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Values,
               Fields, std::shared_ptr<const Table>>
      data = nullptr;

  JsonValue() = default;
  /// By assignment: the variant of GCC 12 destroys what it has not made yet where memory ends while it
  /// is copied to begin with.
  JsonValue(const JsonValue& other) { data = other.data; }
  JsonValue(JsonValue&& other) noexcept = default;
  JsonValue& operator=(const JsonValue& other) = default;
  JsonValue& operator=(JsonValue&& other) noexcept = default;
  ~JsonValue() = default;
  JsonValue(bool value) : data(value) {}
  JsonValue(int value) : data(std::int64_t{value}) {}
  JsonValue(unsigned value) : data(std::uint64_t{value}) {}
  JsonValue(std::uint64_t value) : data(value) {}
  JsonValue(std::int64_t value) : data(value) {}
  JsonValue(double value) : data(value) {}
  JsonValue(std::string value) : data(std::move(value)) {}
  JsonValue(const char* value) : data(std::string(value)) {}
  JsonValue(Values value) : data(std::move(value)) {}
  JsonValue(Fields value) : data(std::move(value)) {}
  /// One object a row.
  JsonValue(Table table);
  /// Null for nothing.
  template <class Value>
  JsonValue(const std::optional<Value>& value) {
    if (value) *this = JsonValue(*value);
  }

  /// The field of that name, or nullptr where there is none or this is no object.
  const JsonValue* find(std::string_view name) const;
  std::optional<std::string> as_text() const;
  /// A whole number that is not negative, however it is written: 1e6 is one, up to 2^53.
  std::optional<std::uint64_t> as_whole() const;
  /// Any number, rounded where it is a large whole one.
  std::optional<double> as_number() const;

  /// The field of that name as such: "" or nothing where there is none of that kind.
  std::string text_of(std::string_view name) const;
  std::optional<std::uint64_t> whole_of(std::string_view name) const;
  std::optional<double> number_of(std::string_view name) const;
};

/// How JSON is written.
struct JsonStyle {
  int indent = 0;  ///< blanks a level of many lines; 0: all in one line, without its end
  bool null_for_infinity = false;  ///< what JSON lacks is else "inf", "-inf" or "nan"
};

/// Numbers are shortest round-trip; bytes that are not UTF-8 become "\xff", as in shown_text.
std::string json_text(const JsonValue& value, const JsonStyle& style = {});

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

}  // namespace flatray
