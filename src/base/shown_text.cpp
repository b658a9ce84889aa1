#include "base/shown_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "base/number_text.h"
#include "base/utf8.h"

namespace flatray {
namespace {

unsigned byte(char c) { return static_cast<unsigned char>(c); }

bool is_plain_ascii(char c) { return c >= ' ' && c <= '~'; }

bool stays_in_lines(char c) { return c == '\n' || c == '\t'; }

// The code point of a character of two or three bytes; 0 for one of four, of which none is hidden.
unsigned code_point(std::string_view character) {
  if (character.size() == 2) return (byte(character[0]) & 0x1f) << 6 | (byte(character[1]) & 0x3f);
  if (character.size() != 3) return 0;
  return (byte(character[0]) & 0x0f) << 12 | (byte(character[1]) & 0x3f) << 6 |
         (byte(character[2]) & 0x3f);
}

bool is_hidden(unsigned code) {
  return (code >= 0x80 && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string escaped_ascii(char c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  return fmt::format("\\u{:04x}", byte(c));
}

std::string shown_character(std::string_view character, bool lines) {
  if (character.size() == 1) {
    const char c = character.front();
    return is_plain_ascii(c) || (lines && stays_in_lines(c)) ? std::string(1, c) : escaped_ascii(c);
  }
  const unsigned code = code_point(character);
  return is_hidden(code) ? fmt::format("\\u{:04x}", code) : std::string(character);
}

std::string stray_byte(char c) { return fmt::format("\\x{:02x}", byte(c)); }

std::string shown(std::string_view text, bool lines) {
  std::string all;
  all.reserve(text.size());
  while (!text.empty()) {
    const auto odd = std::find_if_not(text.begin(), text.end(), is_plain_ascii);
    all.append(text.begin(), odd);
    text.remove_prefix(static_cast<std::size_t>(odd - text.begin()));
    if (text.empty()) break;
    const std::size_t length = utf8_length(text);
    all += length == 0 ? stray_byte(text.front()) : shown_character(text.substr(0, length), lines);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return all;
}

bool is_formula(std::string_view text) {
  if (text.empty() || std::string_view("=+-@").find(text.front()) == std::string_view::npos)
    return false;
  const bool is_signed = text.front() == '-' || text.front() == '+';
  const std::string_view rest = text.substr(1);
  const bool fraction = rest.find_first_not_of("0123456789./") == std::string_view::npos;
  return !is_signed || !(fraction || rest == "inf" || parse_number(text));
}

}  // namespace

std::string shown_text(std::string_view text) { return shown(text, false); }

std::string shown_lines(std::string text) {
  const bool plain =
      std::ranges::all_of(text, [](char c) { return is_plain_ascii(c) || stays_in_lines(c); });
  return plain ? std::move(text) : shown(text, true);  // most are, and may be long
}

std::string shortened(std::string_view message) {
  constexpr std::size_t kMost = 4000;
  if (message.size() <= kMost) return std::string(message);
  std::size_t end = kMost;
  while (end > kMost - 3 && (byte(message[end]) & 0xc0) == 0x80) --end;  // within a character
  return std::string(message.substr(0, end)) + "...";
}

std::string with_stray_bytes_shown(std::string_view text) {
  std::string all;
  for (;;) {
    const std::size_t stray = utf8_prefix(text);
    all += text.substr(0, stray);
    if (stray == text.size()) return all;
    all += stray_byte(text[stray]);
    text.remove_prefix(stray + 1);
  }
}

std::size_t shown_width(std::string_view shown) {
  return static_cast<std::size_t>(
      std::ranges::count_if(shown, [](char c) { return (byte(c) & 0xc0) != 0x80; }));
}

std::string shell_word(std::string_view text) {
  const bool plain = std::ranges::all_of(text, [](char c) {
    return ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') ||
           byte(c) >= 0x80 || std::string_view("_-./:,+@%").find(c) != std::string_view::npos;
  });
  std::string word;
  if (shown_text(text) != text) {  // by bytes, as what is shown of them is no part of a text
    for (const char c : text)
      if (!is_plain_ascii(c))
        word += fmt::format("\\{:03o}", byte(c));
      else
        word += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
    return "$'" + word + "'";
  }
  if (plain && !text.empty()) return std::string(text);
  word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string csv_field(std::string_view text) {
  const std::string shown = (is_formula(text) ? "'" : "") + shown_text(text);
  if (shown.find_first_of(",\"") == std::string::npos) return shown;
  std::string quoted = "\"";
  for (const char c : shown) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace flatray
