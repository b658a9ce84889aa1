#include "scene/reading/write_toml.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <utility>

#include "base/number_text.h"
#include "base/utf8.h"
#include "scene/reading/numbers.h"

namespace flatray {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kWhole = 30;          // columns of what is never broken: points, short lists
constexpr std::size_t kMostOfNumber = 128;  // characters that toml++ reads of one, a sign aside

bool is_bare_key(std::string_view key) {
  return !key.empty() && std::ranges::all_of(key, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

std::string quoted(std::string_view text) {
  std::string all = "\"";
  for (; !text.empty(); text.remove_prefix(1)) {
    const char c = text.front();
    const std::size_t length = utf8_length(text);
    if (length > 1) {
      all += text.substr(0, length);
      text.remove_prefix(length - 1);
    } else if (length == 0) {  // as Latin-1 has it: names of lists may be in any encoding
      all += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    } else if (c == '"' || c == '\\')
      all += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      all += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      all += c;
  }
  return all + '"';
}

std::string key_text(std::string_view key) {
  return is_bare_key(key) ? std::string(key) : quoted(key);
}

std::string number_of(const Decimal& decimal) {
  const std::string sign = decimal.negative ? "-" : "", &digits = decimal.digits;
  const long point = static_cast<long>(digits.size()) + decimal.exponent;  // digits before it
  const std::string tail = digits.size() > 1 ? "." + digits.substr(1) : "";
  const std::string power = fmt::format("{}{}e{}", digits[0], tail, point - 1);
  // What stands beside the digits when they are written out: zeros, or the point, or "0." and zeros.
  const long more = decimal.exponent >= 0 ? decimal.exponent : point > 0 ? 1 : 2 - point;
  if (digits.size() + static_cast<std::size_t>(more) > power.size()) return sign + power;
  const auto before = static_cast<std::size_t>(std::max(point, 0L));
  if (decimal.exponent >= 0) {
    const std::string whole = sign + digits + std::string(static_cast<std::size_t>(more), '0');
    return whole + (parse_integer(whole) ? "" : ".0");  // TOML's integers have 64 bits
  }
  if (point > 0) return sign + digits.substr(0, before) + "." + digits.substr(before);
  return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
}

// Writes values; `flat` never breaks a line.
class Writer {
 public:
  std::string text;

  // Tables of several kinds by turns, as they are in the text: what is drawn covers what is before it.
  void document(const SceneDesc& desc) {
    std::vector<Section> sections;
    for (const Member& member : desc.root.members) {
      if (is_tables(member.value))
        sections.push_back({&member, member.value.items, true});
      else if (is_filled_table(member.value) && (!fits(member) || !sections.empty()))
        sections.push_back({&member, {&member.value, 1}, false});
      else
        line(member);
    }
    const TextOrder order(desc);
    const auto place = [&](const Section& section) {
      return order.at(section.waiting.front().where);
    };
    while (!sections.empty()) {
      const auto next = std::ranges::min_element(sections, {}, place);
      section(key_text(next->member->key), next->waiting.front(), next->is_item);
      next->waiting = next->waiting.subspan(1);
      if (next->waiting.empty()) sections.erase(next);
    }
  }

 private:
  struct Section {
    const Member* member;
    std::span<const Value> waiting;  ///< its tables that are not yet written
    bool is_item;                    ///< of a list
  };

  static bool is_filled_table(const Value& value) {
    return value.kind == Value::Kind::table && !value.members.empty();
  }
  static bool is_tables(const Value& value) {
    return value.kind == Value::Kind::array && !value.items.empty() &&
           std::ranges::all_of(value.items,
                               [](const Value& item) { return item.kind == Value::Kind::table; });
  }
  static bool fits(const Member& member) {
    return key_text(member.key).size() + 3 + flat(member.value).size() <= kColumns;
  }

  void line(const Member& member) {
    const std::string begin = key_text(member.key) + " = ";
    text += begin + broken(member.value, begin.size(), 0) + "\n";
  }

  void member_section(const std::string& path, const Value& value) {
    if (value.kind == Value::Kind::table) return section(path, value, false);
    for (const Value& item : value.items) section(path, item, true);
  }

  // Members keep their order: only those at the end may have headers of their own.
  void section(const std::string& path, const Value& table, bool is_item) {
    text += text.empty() ? "" : "\n";
    text += is_item ? "[[" + path + "]]\n" : "[" + path + "]\n";
    const auto needs_header = [&](const Member& member) {
      return (is_item && is_tables(member.value)) ||
             (is_filled_table(member.value) && !fits(member));
    };
    auto first = table.members.end();
    while (first != table.members.begin() &&
           (is_filled_table(std::prev(first)->value) || is_tables(std::prev(first)->value)))
      --first;
    first = std::find_if(first, table.members.end(), needs_header);
    for (auto member = table.members.begin(); member != first; ++member) line(*member);
    for (auto member = first; member != table.members.end(); ++member)
      member_section(path + "." + key_text(member->key), member->value);
  }

  static std::string flat(const Value& value) {
    switch (value.kind) {
      case Value::Kind::string:
        return quoted(value.text);
      case Value::Kind::number:
        return shortest_number(source_text(value));
      case Value::Kind::boolean:
        return value.text;
      case Value::Kind::date:
        return std::string(source_text(value));
      case Value::Kind::array: {
        std::string all;
        for (const Value& item : value.items) all += (all.empty() ? "" : ", ") + flat(item);
        return "[" + all + "]";
      }
      case Value::Kind::table: {
        std::string all;
        for (const Member& member : value.members)
          all += (all.empty() ? "" : ", ") + key_text(member.key) + " = " + flat(member.value);
        return all.empty() ? "{}" : "{ " + all + " }";
      }
    }
    return "";
  }

  // As `flat` where that ends within the line, else with arrays over many lines.
  static std::string broken(const Value& value, std::size_t column, std::size_t indent) {
    std::string one_line = flat(value);
    if (column + one_line.size() <= kColumns || one_line.size() <= kWhole) return one_line;
    if (value.kind == Value::Kind::array) return broken_array(value, indent);
    if (value.kind == Value::Kind::table) return broken_table(value, column, indent);
    return one_line;
  }

  static std::string broken_table(const Value& table, std::size_t column, std::size_t indent) {
    std::string all = "{ ";
    for (const Member& member : table.members) {
      if (&member != &table.members.front()) all += ", ";
      all += key_text(member.key) + " = ";
      const std::size_t line = all.rfind('\n');
      const std::size_t at =
          line == std::string::npos ? column + all.size() : all.size() - line - 1;
      all += broken(member.value, at, indent);
    }
    return all + " }";
  }

  static std::string broken_array(const Value& array, std::size_t indent) {
    const std::string begin = "\n" + std::string(indent + 2, ' ');
    std::string all = "[";
    std::size_t column = kColumns;
    for (const Value& item : array.items) {
      const std::string one = broken(item, indent + 2, indent + 2) + ",";
      const bool together = item.kind != Value::Kind::table && column + 1 + one.size() <= kColumns;
      all += (together ? " " : begin) + one;
      column = (together ? column + 1 : indent + 2) + one.size();
      if (one.find('\n') != std::string::npos) column = kColumns;
    }
    return all + "\n" + std::string(indent, ' ') + "]";
  }
};

}  // namespace

std::string shortest_number(std::string_view literal) {
  if (const std::optional<Decimal> decimal = parse_decimal(literal)) {
    const bool negative = literal.starts_with('-');
    if (decimal->digits.empty()) return negative ? "-0.0" : "0";
    std::string text = number_of(*decimal);
    if (text.size() <= kMostOfNumber + (negative ? 1 : 0)) return text;
  }
  const std::optional<Number> number = parse_literal(literal);
  return number ? shortest_number(number_text(number->value)) : std::string(literal);
}

std::string write_toml(const SceneDesc& desc) {
  Writer writer;
  writer.document(desc);
  return std::move(writer.text);
}

}  // namespace flatray
