#include "scene/reading/reader.h"

#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "base/counted.h"
#include "base/number_text.h"
#include "scene/reading/numbers.h"

namespace flatray {
namespace {

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

std::optional<Colour> parse_colour(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 7 && text.size() != 9)) return std::nullopt;
  Colour colour;
  text.remove_prefix(1);
  for (std::uint8_t* channel : {&colour.r, &colour.g, &colour.b, &colour.a}) {
    if (text.empty()) break;  // no opacity is given
    const auto value = parse_digits<std::uint8_t>(text.substr(0, 2), 16);
    if (!value) return std::nullopt;
    *channel = *value;
    text.remove_prefix(2);
  }
  return colour;
}

}  // namespace

Field Field::item(std::size_t index) const {
  return {fmt::format("{}[{}]", name, index), value.items[index], takes};
}

void Reader::problem(const Place& where, std::string message, std::string hint) {
  problems.push_back({where, std::move(message), std::move(hint)});
}

void Reader::problem(const Field& field, const std::string& what, std::string hint) {
  problem(field.value.where, field.name + " " + what, std::move(hint));
}

void Reader::warning(const Place& where, std::string message, std::string hint) {
  warnings.push_back({where, std::move(message), std::move(hint)});
}

void Reader::add(Diagnostics more) { std::ranges::move(more, std::back_inserter(problems)); }

std::nullopt_t Reader::refuse(Diagnostic one) {
  problems.push_back(std::move(one));
  return std::nullopt;
}

std::nullopt_t Reader::refuse(const Field& field, const std::string& what, std::string hint) {
  problem(field, what, std::move(hint));
  return std::nullopt;
}

void Reader::mismatch(const Field& field, const char* expected) {
  problem(field, fmt::format("is {}, not {}", kind_name(field.value.kind), expected),
          how_to_write(field));
}

bool Reader::is(const Field& field, Value::Kind kind, const char* expected) {
  if (field.value.kind == kind) return true;
  mismatch(field, expected);
  return false;
}

bool Reader::is_pair(const Field& field, const char* expected) {
  if (field.value.kind == Value::Kind::array && field.value.items.size() == 2) return true;
  mismatch(field, expected);
  return false;
}

bool Reader::may_draw(const Field& field) {
  if (draws != nullptr) return true;
  problem(field, "cannot be drawn at random",
          "only entities, groups and their shapes are: " + how_to_write(field));
  return false;
}

std::optional<std::size_t> Reader::draw_choice(const Field& field) {
  const Field list{field.name + ".choice", field.value.members.front().value, "[one, another]"};
  if (!may_draw(field) || !is(list, Value::Kind::array, "a list")) return std::nullopt;
  const std::size_t count = list.value.items.size();
  if (count == 0) return refuse(list, "is empty", "write at least one value to choose");
  const double drawn = draws->unit(field.value) * static_cast<double>(count);
  return std::min(static_cast<std::size_t>(drawn), count - 1);
}

// One of two numbers: ends, or mean and spread.
std::optional<double> Reader::draw_number(const Field& field) {
  const Member& kind = field.value.members.front();
  const bool is_normal = kind.key == "normal";
  const Field pair{field.name + "." + kind.key, kind.value, is_normal ? "[mean, sd]" : "[a, b]"};
  if (!may_draw(field) || !is_pair(pair, "two numbers")) return std::nullopt;
  const std::optional<double> a = plain_number(pair.item(0)), b = plain_number(pair.item(1));
  if (!a || !b) return std::nullopt;
  const double reach = is_normal ? *b : *b - *a;
  if (!(reach >= 0))
    return refuse({pair.value.where,
                   pair.name + (is_normal ? " has a spread below 0" : " ends below its beginning"),
                   is_normal ? "the second number is the standard deviation"
                             : "write the smaller number first"});
  if (std::abs(*a) > kFarthest || std::abs(*b) > kFarthest)
    return refuse(pair, "reaches beyond 1e300", "write numbers between -1e300 and 1e300");
  return is_normal ? *a + reach * draws->normal(field.value)
                   : std::min(*a + reach * draws->unit(field.value), *b);
}

std::optional<double> Reader::number(const Field& field) {
  return chosen(field, [this](const Field& one) {
    return is_distribution(one.value) ? draw_number(one) : plain_number(one);
  });
}

bool Reader::refuse_curve(const Field& field) {
  if (!is_curve(field.value)) return false;
  const std::string key = last_name(field.name);
  const char* hint = key == "velocity" ? "write at = { keys = [[t, [x, y]], ...] }"
                     : key == "angular_velocity"
                         ? "write angle = { keys = [[t, degrees], ...] }"
                         : "write one value: of entities places, angles, sizes, colours, "
                           "widths and opacity can change, of groups at, angle and scale, "
                           "of the camera at, height and zoom";
  problem(field, "cannot change with time", hint);
  return true;
}

std::optional<double> Reader::plain_number(const Field& field) {
  if (refuse_curve(field)) return std::nullopt;
  if (!is(field, Value::Kind::number, "a number")) return std::nullopt;
  const std::string_view text = source_text(field.value);
  const std::optional<Number> number = parse_literal(text);
  if (!number) return refuse(field, "is not finite", "write a number between -1e300 and 1e300");
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
  if (refuse_curve(field)) return std::nullopt;
  if (!is(field, Value::Kind::number, "a whole number")) return std::nullopt;
  const std::optional<std::int64_t> value = parse_integer(source_text(field.value));
  if (value && *value >= low && *value <= high) return value;
  return refuse(field, fmt::format("is {}", source_text(field.value).substr(0, 40)),
                fmt::format("it must be a whole number from {} to {}", low, high));
}

std::optional<Vec2> Reader::point(const Field& field) {
  return chosen(field, [this](const Field& one) { return plain_point(one); });
}

std::optional<Vec2> Reader::plain_point(const Field& field) {
  if (refuse_curve(field)) return std::nullopt;
  if (!is(field, Value::Kind::array, "two numbers")) return std::nullopt;
  if (field.value.items.size() != 2)
    return refuse(field,
                  fmt::format("has {}, not two", counted(field.value.items.size(), "number")),
                  how_to_write(field));
  const std::optional<double> x = number(field.item(0)), y = number(field.item(1));
  if (!x || !y) return std::nullopt;
  const Vec2 point(*x, *y);
  if (point.cwiseAbs().maxCoeff() > kFarthest)
    return refuse(field, "lies beyond 1e300", "write numbers between -1e300 and 1e300");
  return point;
}

std::optional<Bounds> Reader::box(const Field& field) {
  if (!is_pair(field, "two points")) return std::nullopt;
  const std::optional<Vec2> low = point(field.item(0)), high = point(field.item(1));
  if (!low || !high) return std::nullopt;
  if (const Vec2 size = *high - *low; size.x() > 0 && size.y() > 0) return Bounds{*low, *high};
  return refuse(field, "has no area", "the first point must lie below and left of the second");
}

std::optional<std::string> Reader::string(const Field& field) {
  if (!is(field, Value::Kind::string, "a string")) return std::nullopt;
  if (field.value.text.size() <= kMostStringBytes) return field.value.text;
  return refuse(field, fmt::format("is {} bytes long", field.value.text.size()),
                fmt::format("strings end at {} bytes", kMostStringBytes));
}

std::optional<bool> Reader::flag(const Field& field) {
  if (!is(field, Value::Kind::boolean, "true or false")) return std::nullopt;
  return field.value.text == "true";
}

std::optional<Colour> Reader::colour(const Field& field) {
  return chosen(field, [this](const Field& one) { return plain_colour(one); });
}

std::optional<Colour> Reader::plain_colour(const Field& field) {
  if (refuse_curve(field)) return std::nullopt;
  const std::optional<std::string> text = string(field);
  if (!text) return std::nullopt;
  const std::optional<Colour> parsed = parse_colour(*text);
  if (!parsed)
    problem(field, fmt::format("'{}' is not a colour", text->substr(0, 40)),
            R"(write "#rrggbb" or "#rrggbbaa")");
  return parsed;
}

double radians(double degrees) { return degrees / 180 * std::numbers::pi; }

}  // namespace flatray
