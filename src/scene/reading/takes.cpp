#include "scene/reading/takes.h"

#include <algorithm>

namespace flatray {
namespace {

using Kind = Takes::Kind;

struct Unit {
  std::string_view words;
  Kind kind;
};
// The longer of two that begin alike stands first.
constexpr Unit kUnits[] = {
    {"number from 0 to 1", Kind::number},
    {"number", Kind::number},
    {"whole number", Kind::whole},
    {"degrees a second", Kind::number},
    {"degrees", Kind::number},
    {"frames a second", Kind::number},
    {"frames", Kind::whole},
    {"world units", Kind::number},
    {"pixels", Kind::number},
    {"true or false", Kind::truth},
    {"seconds", Kind::number},
};

bool is_name_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == '-';
}

class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }

  // `nested`: inside brackets, where commas part items and bare names are numbers.
  std::optional<std::vector<Takes>> alternatives(bool nested) {
    std::vector<Takes> all;
    do {
      std::optional<Takes> one = part(nested);
      if (!one) return std::nullopt;
      all.push_back(std::move(*one));
    } while (skip(" or ") || (!nested && skip(", ")));
    return all;
  }

 private:
  bool skip(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  std::string_view name() {
    const auto end = std::ranges::find_if_not(rest_, is_name_byte);
    const std::string_view found = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(found.size());
    return found;
  }

  std::optional<Takes> part(bool nested) {
    if (skip("\"")) return quoted();
    const std::string_view before = rest_;
    if (skip("[[")) {
      const std::string_view table = name();
      if (!table.empty() && skip("]]")) return Takes{Kind::tables, std::string(table)};
      rest_ = before;  // a list of lists
    }
    if (skip("[")) return list();
    if (skip("{ ")) return table();
    for (const auto& [words, kind] : kUnits)
      if (skip(words)) return Takes{kind};
    if (skip("a ")) return Takes{Kind::table, std::string(name())};
    const std::string_view word = name();
    if (word.empty()) return std::nullopt;
    if (std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; }))
      return Takes{Kind::literal, std::string(word)};
    return nested ? std::optional(Takes{}) : std::nullopt;
  }

  std::optional<Takes> quoted() {
    const std::size_t end = rest_.find('"');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string word(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    if (word.starts_with("#rrggbb")) return Takes{Kind::colour};
    const bool is_text = is_placeholder(word) || word.find_first_of(". ") != std::string::npos;
    return is_text ? Takes{Kind::text} : Takes{Kind::word, word};
  }

  // After "[".
  std::optional<Takes> list() {
    const std::string_view before = rest_;
    const std::string_view word = name();
    if (const std::size_t dot = word.rfind('.'); dot != std::string_view::npos && skip("]"))
      return is_placeholder(word.substr(dot + 1))
                 ? std::optional(Takes{Kind::named, std::string(word)})
                 : std::nullopt;
    rest_ = before;
    Takes list{Kind::list};
    do {
      if (skip("...]")) {
        list.more = true;
        return list.items.empty() ? std::nullopt : std::optional(std::move(list));
      }
      std::optional<std::vector<Takes>> item = alternatives(true);
      if (!item) return std::nullopt;
      list.items.push_back(std::move(*item));
    } while (skip(", "));
    return skip("]") ? std::optional(std::move(list)) : std::nullopt;
  }

  // After "{ ".
  std::optional<Takes> table() {
    Takes table{Kind::table};
    do {
      if (skip("...")) break;
      const std::string_view key = name();
      if (key.empty() || !skip(" = ")) return std::nullopt;
      if (skip("...")) {
        table.keys.emplace_back(std::string(key), std::vector<Takes>{});
        continue;
      }
      std::optional<std::vector<Takes>> value = alternatives(true);
      if (!value) return std::nullopt;
      table.keys.emplace_back(std::string(key), std::move(*value));
    } while (skip(", "));
    return skip(" }") ? std::optional(std::move(table)) : std::nullopt;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<std::vector<Takes>> parse_takes(std::string_view takes) {
  Parser parser(takes);
  std::optional<std::vector<Takes>> all = parser.alternatives(false);
  return parser.at_end() ? all : std::nullopt;
}

bool is_placeholder(std::string_view name) {
  return !name.empty() &&
         std::ranges::all_of(name, [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
}

}  // namespace flatray
