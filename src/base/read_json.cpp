#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/json.h"

namespace flatray {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostNested = 64;
constexpr int kOutOfRange = 4;  // the hundreds of the library's numbers for such mistakes

// The library's own words after its position: "syntax error while parsing value - ...".
std::string reason(std::string_view what) {
  const std::size_t column = what.find("column ");
  const std::size_t at = what.find(": ", column == std::string_view::npos ? 0 : column);
  return at == std::string_view::npos ? "" : std::string(what.substr(at));
}

// Where the first bracket opens that is nested too deep; `text` holds one, and is JSON before it.
std::size_t too_deep(std::string_view text) {
  std::size_t depth = 0, at = 0;
  for (bool quoted = false; depth <= kMostNested; ++at) {
    const char c = text[at];
    if (quoted && c == '\\') ++at;
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '{')) ++depth;
    if (!quoted && (c == ']' || c == '}')) --depth;
  }
  return at;
}

// Builds a value from what the library's lexer finds, one call a token.
class JsonBuilder {
 public:
  explicit JsonBuilder(std::string_view text) : text_(text) {}
  bool null() { return put({}); }
  bool boolean(bool truth) { return put(truth); }
  bool number_unsigned(std::uint64_t number) { return put(number); }
  bool number_integer(std::int64_t number) { return number == 0 ? put(-0.0) : put(number); }
  bool number_float(double number, const std::string&) { return put(number); }
  bool string(std::string& text) { return put(std::move(text)); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Fields()); }
  bool start_array(std::size_t) { return open(Values()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    std::get<Fields>(open_.back().data).emplace_back(std::move(name), JsonValue());
    return true;
  }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& error) {
    const bool range = error.id / 100 == kOutOfRange;
    mistake_ = {byte,
                range ? "a number beyond the range of doubles" : "no JSON" + reason(error.what())};
    return false;
  }

  tl::expected<JsonValue, JsonMistake> result(bool whole) {
    if (whole) return std::move(root_);
    return tl::unexpected(mistake_);
  }

 private:
  bool open(JsonValue value) {
    open_.push_back(std::move(value));
    if (open_.size() <= kMostNested) return true;
    mistake_ = {too_deep(text_), fmt::format("brackets nested more than {} deep", kMostNested)};
    return false;
  }
  bool close() {
    JsonValue value = std::move(open_.back());
    open_.pop_back();
    return put(std::move(value));
  }
  bool put(JsonValue value) {
    if (open_.empty())
      root_ = std::move(value);
    else if (auto* values = std::get_if<Values>(&open_.back().data))
      values->push_back(std::move(value));
    else
      std::get<Fields>(open_.back().data).back().second = std::move(value);
    return true;
  }

  std::string_view text_;
  std::vector<JsonValue> open_;  // the objects and arrays not yet closed
  JsonValue root_;
  JsonMistake mistake_{1, ""};
};

}  // namespace

tl::expected<JsonValue, JsonMistake> read_json(std::string_view text) {
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    return tl::unexpected(JsonMistake{nul + 1, "no JSON: a NUL byte"});
  JsonBuilder builder(text);
  const bool whole = Json::sax_parse(text, &builder);
  return builder.result(whole);
}

std::optional<JsonValue> parse_json(std::string_view text) {
  auto json = read_json(text);
  return json ? std::optional(std::move(*json)) : std::nullopt;
}

}  // namespace flatray
