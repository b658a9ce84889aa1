#include "scene/reading/json_value.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "base/utf8.h"

namespace flatray {
namespace {

constexpr std::size_t kMostNested = 64, kMostValues = 4'000'000;
constexpr std::string_view kBlanks = " \t\r\n", kDigits = "0123456789";

// As deep as the text nests, which `open` bounds.
class JsonReader {
 public:
  JsonReader(const SourcePtr& source, std::size_t begin, std::size_t end)
      : source_(source), text_(source->text().substr(0, end)), at_(begin) {}

  Result<Value> read() {
    if (const std::size_t stray = at_ + utf8_prefix(text_.substr(at_)); stray < text_.size())
      return fail(Place{source_, stray, 1}, "this byte is not UTF-8", "save the file as UTF-8");
    Value value;
    if (read_value(value) && (skip_blanks(), at_ < text_.size())) mistake("more than one value");
    if (problem_) return tl::unexpected(Diagnostics{std::move(*problem_)});
    return value;
  }

 private:
  bool mistake(std::string message, std::string hint = {}) {
    const std::size_t length = at_ < text_.size() ? 1 : 0;
    problem_ = Diagnostic{{source_, at_, length}, std::move(message), std::move(hint)};
    return false;
  }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }
  bool take(char wanted) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  Place since(std::size_t begin) const { return {source_, begin, at_ - begin}; }

  bool read_value(Value& value) {
    skip_blanks();
    if (++values_ > kMostValues)
      return mistake(fmt::format("more than {} values", kMostValues), "split the file");
    const std::size_t begin = at_;
    const char first = next();
    if (first == '{' || first == '[') {
      if (++nested_ > kMostNested)
        return mistake(fmt::format("brackets nested more than {} deep", kMostNested));
      if (!(first == '{' ? read_object(value) : read_array(value))) return false;
      --nested_;
    } else if (first == '"') {
      value.kind = Value::Kind::string;
      if (!read_string(value.text)) return false;
    } else if (first == '-' || is_digit(first)) {
      value.kind = Value::Kind::number;
      if (!read_number()) return false;
    } else if (!read_word(value)) {
      return false;
    }
    value.where = since(begin);
    return true;
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  bool read_word(Value& value) {
    for (const std::string_view word : {"true", "false", "null"}) {
      if (text_.substr(at_, word.size()) != word) continue;
      at_ += word.size();
      value.kind = word == "null" ? Value::Kind::number : Value::Kind::boolean;
      value.text = word;
      return true;
    }
    return mistake(at_ < text_.size() ? "no JSON value begins like this" : "a value is missing",
                   R"(values are numbers, "text", true, false, null, [ ... ] and { ... })");
  }

  bool read_digits() {
    const std::size_t end = std::min(text_.find_first_not_of(kDigits, at_), text_.size());
    if (end == at_) return mistake("a digit is missing", "numbers are written like 12, -0.5, 1e-3");
    at_ = end;
    return true;
  }

  bool read_number() {
    if (next() == '-') ++at_;
    const bool zero = next() == '0';
    if (zero)
      ++at_;
    else if (!read_digits())
      return false;
    if (zero && is_digit(next())) return mistake("a number begins with 0", "leave the 0 out");
    if (next() == '.') {
      ++at_;
      if (!read_digits()) return false;
    }
    if (next() != 'e' && next() != 'E') return true;
    ++at_;
    if (next() == '+' || next() == '-') ++at_;
    return read_digits();
  }

  bool read_string(std::string& out) {
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') return ++at_, true;
      if (static_cast<unsigned char>(c) < 0x20)
        return mistake("a control character in a text", "write it as \\n or \\u001f");
      if (c != '\\')
        out += c;
      else if (!read_escape(out))
        return false;
    }
    return mistake("the text ends inside of quotes");
  }

  // From the backslash to its last byte.
  bool read_escape(std::string& out) {
    constexpr std::string_view kLetters = "\"\\/bfnrt", kMeant = "\"\\/\b\f\n\r\t";
    ++at_;
    if (const std::size_t known = kLetters.find(next());
        known != std::string_view::npos && at_ < text_.size())
      return out += kMeant[known], true;
    std::uint32_t code = 0;
    if (!read_hex(code)) return false;
    const bool low = code >= 0xdc00 && code < 0xe000;
    if (code >= 0xd800 && code < 0xdc00) {
      std::uint32_t second = 0;
      if (++at_; next() != '\\') return mistake("half of a surrogate pair");
      if (++at_; !read_hex(second)) return false;
      if (second < 0xdc00 || second >= 0xe000) return mistake("half of a surrogate pair");
      code = 0x10000 + ((code - 0xd800) << 10) + (second - 0xdc00);
    }
    if (low) return mistake("half of a surrogate pair");
    append_utf8(out, code);
    return true;
  }

  // At the u of four hexadecimal digits, then at the last of them.
  bool read_hex(std::uint32_t& code) {
    if (next() != 'u') return mistake("no such escape", R"(they are \" \\ \/ \b \f \n \r \t \u)");
    for (int i = 0; i < 4; ++i) {
      ++at_;
      const char c = next();
      const char lower = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
      if (!is_digit(c) && !(lower >= 'a' && lower <= 'f'))
        return mistake("four hexadecimal digits are wanted");
      code = code * 16 + static_cast<std::uint32_t>(is_digit(c) ? c - '0' : lower - 'a' + 10);
    }
    return true;
  }

  static void append_utf8(std::string& out, std::uint32_t code) {
    const auto byte = [&](std::uint32_t bits) { out += static_cast<char>(bits); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
      byte(0xc0 | code >> 6);
    } else {
      if (code < 0x10000) byte(0xe0 | code >> 12);
      if (code >= 0x10000) byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 0x3f));
      byte(0x80 | (code >> 6 & 0x3f));
    }
    byte(0x80 | (code & 0x3f));
  }

  bool read_array(Value& value) {
    value.kind = Value::Kind::array;
    ++at_;
    if (take(']')) return true;
    do
      if (!read_value(value.items.emplace_back())) return false;
    while (take(','));
    return take(']') || mistake("',' or ']' is missing");
  }

  bool read_object(Value& value) {
    value.kind = Value::Kind::table;
    ++at_;
    if (take('}')) return true;
    do {
      skip_blanks();
      const std::size_t begin = at_;
      if (next() != '"') return mistake("a name in quotes is missing");
      Member& member = value.members.emplace_back();
      if (!read_string(member.key)) return false;
      member.where = since(begin);
      if (!take(':')) return mistake("':' is missing");
      if (!read_value(member.value)) return false;
    } while (take(','));
    if (!take('}')) return mistake("',' or '}' is missing");
    return !given_twice(value.members);
  }

  bool given_twice(const std::vector<Member>& members) {
    std::vector<const Member*> sorted;
    for (const Member& member : members) sorted.push_back(&member);
    std::ranges::stable_sort(sorted, {}, &Member::key);
    const auto twice = std::ranges::adjacent_find(sorted, {}, &Member::key);
    if (twice == sorted.end()) return false;
    problem_ = Diagnostic{(*(twice + 1))->where, "this name is given twice", "leave one out"};
    return true;
  }

  const SourcePtr& source_;
  const std::string_view text_;
  std::size_t at_, nested_ = 0, values_ = 0;
  std::optional<Diagnostic> problem_;
};

}  // namespace

Result<Value> json_value(const SourcePtr& source, std::size_t begin, std::size_t end) {
  return JsonReader(source, begin, end).read();
}

}  // namespace flatray
