#include <fmt/core.h>
#include <toml++/toml.h>

#include <algorithm>
#include <new>

#include "base/number_text.h"
#include "base/utf8.h"
#include "scene/reading/format.h"

namespace flatray::toml_format {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 26;
constexpr std::size_t kMaxValues = 4'000'000;

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// What a TOML text would cost its parser, found without parsing it.
struct TomlLoad {
  std::size_t values = 0;                 // at least as many as it holds
  std::optional<std::size_t> deep_key{};  // byte at which a key has more than kMaxKeyParts parts
};
constexpr std::size_t kMaxKeyParts = 64;

// One past the string that begins at `begin`, of any of the four kinds; unclosed ones end with
// their line or text.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool basic = quote == '"';
  const bool long_form = text.substr(begin, 3) == std::string_view(basic ? "\"\"\"" : "'''");
  std::size_t i = begin + (long_form ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (basic && text[i] == '\\')
      ++i;
    else if (!long_form && (text[i] == quote || text[i] == '\n'))
      return i + 1;
    else if (long_form && text.substr(i, 3) == std::string_view(basic ? "\"\"\"" : "'''"))
      break;
  }
  // Up to two quotes may stand before the three that close.
  i = std::min(i + 3, text.size());
  while (long_form && i < text.size() && text[i] == quote) ++i;
  return i;
}

// Right for every text up to its first mistake of syntax, and a parser stops there. Strings and
// comments are passed over.
TomlLoad scan_toml(std::string_view text) {
  TomlLoad load;
  std::size_t parts = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.' && ++parts > kMaxKeyParts && !load.deep_key) load.deep_key = i;
    if (c == '=' || c == ',' || c == '[' || c == '{') ++load.values;
    if (c == '=' || c == ',' || c == '[' || c == '{' || c == '\n') parts = 1;
    ++i;
  }
  return load;
}

// Bytes of toml++'s positions, which count code points. The last line asked for is kept, so that a
// file of one long line costs no more than one of many.
class Positions {
 public:
  explicit Positions(SourcePtr source) : source_(std::move(source)) {}

  std::size_t offset(::toml::source_position at) {
    const int line = static_cast<int>(at.line);
    if (line != line_) read_line(line);
    const std::size_t column = std::max<std::size_t>(at.column, 1) - 1;
    if (code_points_.empty()) return begin_ + std::min(column, length_);
    return begin_ + code_points_[std::min(column, code_points_.size() - 1)];
  }
  Place place(const ::toml::source_region& region) {
    const std::size_t begin = offset(region.begin), end = offset(region.end);
    return {source_, begin, end > begin ? end - begin : 1};
  }
  const SourcePtr& source() const { return source_; }

 private:
  void read_line(int line) {
    line_ = line;
    begin_ = source_->offset(line, 1);
    const std::string_view text = source_->line(line);
    length_ = text.size();
    code_points_.clear();
    if (std::ranges::none_of(text, is_continuation)) return;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (!is_continuation(text[i])) code_points_.push_back(i);
    code_points_.push_back(text.size());
  }

  SourcePtr source_;
  int line_ = 0;
  std::size_t begin_ = 0, length_ = 0;
  std::vector<std::size_t> code_points_;  // empty for a line of ASCII
};

Value convert(const ::toml::node& node, Positions& positions);

Value convert_table(const ::toml::table& table, Positions& positions, Place where) {
  Value value = table_value(std::move(where), {});
  for (const auto& [key, node] : table)
    value.members.push_back(
        {std::string(key.str()), positions.place(key.source()), convert(node, positions)});
  // toml++ sorts by name.
  std::ranges::sort(value.members, [](const Member& a, const Member& b) {
    return a.where.offset < b.where.offset;
  });
  return value;
}

Value convert_array(const ::toml::array& array, Positions& positions, Place where) {
  Value value = array_value(std::move(where), {});
  value.items.reserve(array.size());
  for (const ::toml::node& item : array) value.items.push_back(convert(item, positions));
  return value;
}

// As deep as the text nests: toml++ stops at 256 brackets, scan_toml at 64 parts of a key.
Value convert(const ::toml::node& node, Positions& positions) {
  Place where = positions.place(node.source());
  switch (node.type()) {
    case ::toml::node_type::table:
      return convert_table(*node.as_table(), positions, std::move(where));
    case ::toml::node_type::array:
      return convert_array(*node.as_array(), positions, std::move(where));
    case ::toml::node_type::string:
      return string_value(std::move(where), node.as_string()->get());
    case ::toml::node_type::boolean:
      return {Value::Kind::boolean,
              std::move(where),
              node.as_boolean()->get() ? "true" : "false",
              {},
              {}};
    case ::toml::node_type::integer:
    case ::toml::node_type::floating_point:
      return {Value::Kind::number, std::move(where), {}, {}, {}};
    default:
      return {Value::Kind::date, std::move(where), {}, {}, {}};
  }
}

// Bytes that a number or bare word may hold.
bool is_token_byte(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' ||
         c == '-' || c == '.' || c == '_';
}

// The word around the byte where toml++ gave up.
Place token_at(const SourcePtr& source, std::size_t offset) {
  const std::string_view text = source->text();
  std::size_t begin = std::min(offset, text.size()), end = begin;
  while (begin > 0 && is_token_byte(text[begin - 1])) --begin;
  while (end < text.size() && is_token_byte(text[end])) ++end;
  return {source, begin, end - begin};
}

bool is_number_like(std::string_view token) {
  return !token.empty() && token.find_first_of("0123456789") != std::string_view::npos &&
         std::string_view("0123456789+-.").find(token.front()) != std::string_view::npos;
}

// "Error while parsing floating-point: x" -> "floating-point: x", and no names of macros.
std::string own_words(std::string_view description) {
  constexpr std::string_view kPrefix = "Error while parsing ";
  if (description.starts_with(kPrefix)) description.remove_prefix(kPrefix.size());
  description = description.substr(0, description.find(" (TOML_"));
  return std::string(description);
}

constexpr const char* kNumberRemedy = "numbers are written like 12, -0.5 or 1e-3";

// What to write instead, by the first of these that toml++'s words hold.
constexpr std::pair<std::string_view, const char*> kRemedies[] = {
    {"nested value depth", "leave out brackets: no key takes values as deep as this"},
    {"value, saw '#'", R"(colours are written in quotes: "#rrggbb")"},
    {"escape sequence", R"(write \\ for a backslash, or the text in single quotes: 'a\b')"},
    {"string: ", "close the text with the quotes that open it"},
    {"could not determine value type", R"(words are written in quotes: "word")"},
    {"saw ';'", "nothing but a comment follows a value in its line"},
    {"value-terminator", "nothing but a comment follows a value in its line"},
    {"boolean: ", R"(write true or false; words are written in quotes: "word")"},
    {"array: ", "part values by commas, and close the array with ]: [1, 2]"},
    {"(dangling comma)", "leave out the comma before }"},
    {"inline table: ",
     "what stands in braces is parted by commas and stands in one line: { a = 1, b = 2 }"},
    {"expected '='", "write key = value; a table is [table]"},
    {"expected value, saw", R"(write a value after =, such as 12, true, "word" or [1, 2])"},
    {"expected ']'", "close the brackets in the same line: [table], or [[entry]] of several"},
    {"as array-of-tables", "write double brackets for each of several: [[entry]]"},
    {"cannot redefine", "a key or table stands once: leave one of them out"},
    {"comment or whitespace", "write one key = value a line, and decimals with a point"},
    {"leading zeroes", "leave out the zeros it begins with"},
    {"integer", kNumberRemedy},
    {"floating-point", kNumberRemedy},
    {"", "a line is key = value, [table], [[entry]] or # a comment"}};

const char* remedy(std::string_view message) {
  return std::ranges::find_if(
             kRemedies, [&](const auto& one) { return message.find(one.first) != message.npos; })
      ->second;
}

tl::unexpected<Diagnostics> syntax_error(const ::toml::parse_error& error, Positions& positions) {
  const SourcePtr& source = positions.source();
  const std::size_t offset = positions.offset(error.source().begin);
  const Place token = token_at(source, offset);
  const std::string_view text = source->text().substr(token.offset, token.length);
  const std::string message = own_words(error.description());
  if (message.ends_with("expected value, saw '#'"))
    return fail({source, offset, 1}, "a value is missing: # begins a comment", remedy(message));
  const std::string_view rest = source->text().substr(std::min(offset, source->text().size()));
  if (message.find("string: ") != message.npos && message.find("control char") != message.npos &&
      !rest.empty() && rest.front() != '\n' && rest.front() != '\r')
    return fail({source, offset, 1}, message,
                R"(in double quotes, write a control character by its number, as \u001b)");
  if (!is_number_like(text)) return fail({source, offset, 1}, message, remedy(message));
  // What toml++ says of a number names its grammar, not the mistake.
  for (const char* grammar : {"floating-point: e", "decimal integer: expected"})
    if (message.starts_with(grammar) && message.find("length") == std::string::npos &&
        !message.ends_with("';'"))
      return fail(token, fmt::format("'{}' is not a number", text.substr(0, 40)), kNumberRemedy);
  if (message.find("could not be interpreted") != std::string::npos) {
    if (parse_number(text)) throw std::bad_alloc();  // which the stream toml++ reads from hides
    return fail(token, fmt::format("{} is beyond the doubles", text.substr(0, 40)),
                "write a number between -1e300 and 1e300");
  }
  return fail(token, message, remedy(message));
}

Result<void> check_load(const SourcePtr& source) {
  const std::string_view text = source->text();
  if (text.size() > kMaxBytes)
    return fail(named_place(source->name()), fmt::format("the scene is {} bytes long", text.size()),
                fmt::format("TOML scenes end at {} bytes; import outlines instead", kMaxBytes));
  if (const std::size_t stray = utf8_prefix(text); stray < text.size())
    return fail({source, stray, 1}, "this byte is not UTF-8", "save the file as UTF-8");
  const TomlLoad load = scan_toml(text);
  if (load.deep_key)
    return fail({source, *load.deep_key, 1},
                fmt::format("a key of more than {} parts", kMaxKeyParts), "");
  if (load.values > kMaxValues)
    return fail(named_place(source->name()), fmt::format("the scene holds {} values", load.values),
                fmt::format("at most {}; import outlines instead", kMaxValues));
  return {};
}

Result<SceneDesc> read(const SourcePtr& source, const LoadLimits&) {
  if (Result<void> checked = check_load(source); !checked) return fail(std::move(checked));
  Positions positions(source);
  try {
    const ::toml::table root = ::toml::parse(source->text());
    return SceneDesc{convert_table(root, positions, {source, 0, 1}), {}};
  } catch (const ::toml::parse_error& error) {
    return syntax_error(error, positions);
  }
}

bool recognises(std::string_view) { return false; }  // what nothing else recognises is TOML

constexpr std::string_view kExtensions[] = {"toml"};

}  // namespace

extern const Format entry = {
    "toml", "flatray's own scenes: docs/SCENE_FORMAT.md", kExtensions, &recognises, &read, nullptr};

}  // namespace flatray::toml_format
