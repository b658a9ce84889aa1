#include "scene/reader.h"

#include <fmt/core.h>

#include <charconv>
#include <numbers>

#include "base/number_text.h"
#include "scene/numbers.h"

namespace flatray {
namespace {

constexpr std::size_t kMaxStringBytes = 4096;

// The key alone, of "film.size" or "film.world[0]".
std::string last_name(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string key = dot == std::string::npos ? name : name.substr(dot + 1);
  return key.substr(0, key.find('['));
}

// "write size = [w, h]", or "write [[entity]]" for what is a table of its own.
std::string how_to_write(const Field& field) {
  const std::string key = last_name(field.name);
  const std::string_view takes = field.takes;
  if (takes.starts_with("[" + key) || takes.starts_with("[[" + key))
    return fmt::format("write {}", takes);
  return fmt::format("write {} = {}", key, takes);
}

std::optional<std::uint8_t> hex_byte(std::string_view text) {
  std::uint8_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Colour> parse_colour(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 7 && text.size() != 9)) return std::nullopt;
  const auto r = hex_byte(text.substr(1, 2)), g = hex_byte(text.substr(3, 2)),
             b = hex_byte(text.substr(5, 2));
  const auto a = text.size() == 9 ? hex_byte(text.substr(7, 2)) : std::optional<std::uint8_t>(255);
  if (!r || !g || !b || !a) return std::nullopt;
  return Colour{*r, *g, *b, *a};
}

}  // namespace

Field Field::item(std::size_t index) const {
  return {fmt::format("{}[{}]", name, index), value.items[index], takes};
}

void Reader::problem(const Place& where, std::string message, std::string hint) {
  problems.push_back({where, std::move(message), std::move(hint)});
}

void Reader::warning(const Place& where, std::string message, std::string hint) {
  warnings.push_back({where, std::move(message), std::move(hint)});
}

void Reader::mismatch(const Field& field, const char* expected) {
  problem(field.value.where,
          fmt::format("{} is {}, not {}", field.name, kind_name(field.value.kind), expected),
          how_to_write(field));
}

bool Reader::is(const Field& field, Value::Kind kind, const char* expected) {
  if (field.value.kind == kind) return true;
  mismatch(field, expected);
  return false;
}

std::optional<double> Reader::number(const Field& field) {
  if (!is(field, Value::Kind::number, "a number")) return std::nullopt;
  const std::string_view text = source_text(field.value);
  const std::optional<Number> number = parse_literal(text);
  if (!number) {
    problem(field.value.where, fmt::format("{} is not finite", field.name),
            "write a number between -1.7e308 and 1.7e308");
    return std::nullopt;
  }
  if (number->loss == Number::Loss::integer)
    warning(field.value.where,
            fmt::format("{} reads as {}", text.substr(0, 40), decimal_text(number->value)),
            "no double holds this integer");
  if (number->loss == Number::Loss::underflow)
    warning(field.value.where, fmt::format("{} reads as 0", text.substr(0, 40)),
            "it is nearer to 0 than to any other double");
  return number->value;
}

std::optional<std::int64_t> Reader::integer(const Field& field, std::int64_t low,
                                            std::int64_t high) {
  if (!is(field, Value::Kind::number, "a whole number")) return std::nullopt;
  const std::optional<std::int64_t> value = parse_integer(source_text(field.value));
  if (value && *value >= low && *value <= high) return value;
  problem(field.value.where,
          fmt::format("{} is {}", field.name, source_text(field.value).substr(0, 40)),
          fmt::format("it must be a whole number from {} to {}", low, high));
  return std::nullopt;
}

std::optional<Vec2> Reader::point(const Field& field) {
  if (!is(field, Value::Kind::array, "two numbers")) return std::nullopt;
  if (field.value.items.size() != 2) {
    problem(field.value.where,
            fmt::format("{} has {} numbers, not two", field.name, field.value.items.size()),
            how_to_write(field));
    return std::nullopt;
  }
  const std::optional<double> x = number(field.item(0)), y = number(field.item(1));
  if (!x || !y) return std::nullopt;
  const Vec2 point(*x, *y);
  if (point.cwiseAbs().maxCoeff() > kFarthest) {
    problem(field.value.where, fmt::format("{} lies beyond 1e300", field.name),
            "write numbers between -1e300 and 1e300");
    return std::nullopt;
  }
  return point;
}

std::optional<std::string> Reader::string(const Field& field) {
  if (!is(field, Value::Kind::string, "a string")) return std::nullopt;
  if (field.value.text.size() <= kMaxStringBytes) return field.value.text;
  problem(field.value.where,
          fmt::format("{} is {} bytes long", field.name, field.value.text.size()),
          fmt::format("strings end at {} bytes", kMaxStringBytes));
  return std::nullopt;
}

std::optional<bool> Reader::flag(const Field& field) {
  if (!is(field, Value::Kind::boolean, "true or false")) return std::nullopt;
  return field.value.text == "true";
}

std::optional<Colour> Reader::colour(const Field& field) {
  const std::optional<std::string> text = string(field);
  if (!text) return std::nullopt;
  const std::optional<Colour> parsed = parse_colour(*text);
  if (!parsed)
    problem(field.value.where, fmt::format("{} '{}' is no colour", field.name, text->substr(0, 40)),
            R"(write "#rrggbb" or "#rrggbbaa")");
  return parsed;
}

double radians(double degrees) { return degrees / 180 * std::numbers::pi; }

}  // namespace flatray
