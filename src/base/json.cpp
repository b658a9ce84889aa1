#include "base/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "base/shown_text.h"
#include "base/table.h"

namespace flatray {
namespace {

class JsonWriter {
 public:
  explicit JsonWriter(const JsonStyle& style) : style_(style) {}

  void add(const JsonValue& value) {
    std::visit([this](const auto& one) { add(one); }, value.data);
  }
  std::string text() && { return std::move(out_); }

 private:
  void add(std::nullptr_t) { out_ += "null"; }
  void add(bool truth) { out_ += truth ? "true" : "false"; }
  void add(std::int64_t number) { out_ += std::to_string(number); }
  void add(std::uint64_t number) { out_ += std::to_string(number); }
  void add(double number) {
    if (std::isfinite(number))
      out_ += number_text(number);
    else if (style_.null_for_infinity)
      add(nullptr);
    else
      add(number_text(number));
  }

  // Most texts are names in plain letters, which stand for themselves.
  void add(const std::string& text) {
    const bool plain = std::ranges::all_of(
        text, [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
    if (plain)
      out_.append("\"").append(text).append("\"");
    else
      out_ += nlohmann::json(with_stray_bytes_shown(text)).dump();
  }

  void add(const Values& values) {
    nest('[', ']', [&](const auto& next) {
      for (const JsonValue& value : values) next(), add(value);
    });
  }
  void add(const Fields& fields) {
    nest('{', '}', [&](const auto& next) {
      for (const auto& [name, value] : fields) next(), add_field(name, value);
    });
  }
  void add(const std::shared_ptr<const Table>& table) {
    nest('[', ']', [&](const auto& next_row) {
      table->each_row([&](const Values& row) {
        next_row();
        nest('{', '}', [&](const auto& next) {
          for (std::size_t i = 0; i < row.size(); ++i) next(), add_field(table->columns[i], row[i]);
        });
      });
    });
  }
  void add_field(const std::string& name, const JsonValue& value) {
    add(name);
    out_ += style_.indent > 0 ? ": " : ":";
    add(value);
  }

  // `each(next)` adds what lies between brackets, and calls `next` before each item.
  template <class Each>
  void nest(char open, char close, const Each& each) {
    out_ += open;
    ++depth_;
    bool any = false;
    each([&] {
      if (any) out_ += ',';
      any = true;
      begin_line();
    });
    --depth_;
    if (any) begin_line();
    out_ += close;
  }
  void begin_line() {
    if (style_.indent > 0)
      out_.append(1, '\n').append(static_cast<std::size_t>(style_.indent * depth_), ' ');
  }

  const JsonStyle style_;
  std::string out_;
  int depth_ = 0;
};

// What `get` gives of a field.
template <class Value>
std::optional<Value> field_of(const JsonValue& object, std::string_view name,
                              std::optional<Value> (JsonValue::*get)() const) {
  const JsonValue* field = object.find(name);
  return field == nullptr ? std::nullopt : (field->*get)();
}

}  // namespace

JsonValue::JsonValue(Table table) : data(std::make_shared<const Table>(std::move(table))) {}

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

std::optional<std::uint64_t> JsonValue::as_whole() const {
  if (const auto* number = std::get_if<std::uint64_t>(&data)) return *number;
  constexpr double kExact = 9007199254740992;  // up to which doubles hold all whole numbers
  const auto* number = std::get_if<double>(&data);
  if (number == nullptr || !(*number >= 0 && *number <= kExact) || std::floor(*number) != *number)
    return std::nullopt;
  return static_cast<std::uint64_t>(*number);
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

std::string JsonValue::text_of(std::string_view name) const {
  return field_of(*this, name, &JsonValue::as_text).value_or("");
}

std::optional<std::uint64_t> JsonValue::whole_of(std::string_view name) const {
  return field_of(*this, name, &JsonValue::as_whole);
}

std::optional<double> JsonValue::number_of(std::string_view name) const {
  return field_of(*this, name, &JsonValue::as_number);
}

std::string json_text(const JsonValue& value, const JsonStyle& style) {
  JsonWriter writer(style);
  writer.add(value);
  return std::move(writer).text();
}

}  // namespace flatray
