#include "base/utf8.h"

#include <cstdint>

namespace flatray {
namespace {

std::uint8_t byte(std::string_view text, std::size_t at) {
  return static_cast<std::uint8_t>(text[at]);
}

// What may follow a first byte: its length, and the range of the second, in which the longer forms,
// surrogates and what lies beyond the last character are told (Unicode 15, table 3-7).
struct Form {
  std::size_t length = 0;
  std::uint8_t low = 0x80, high = 0xbf;
};

Form form_of(std::uint8_t first) {
  if (first < 0x80) return {1};
  if (first < 0xc2 || first > 0xf4) return {0};
  if (first < 0xe0) return {2};
  if (first == 0xe0) return {3, 0xa0};
  if (first == 0xed) return {3, 0x80, 0x9f};
  if (first < 0xf0) return {3};
  if (first == 0xf0) return {4, 0x90};
  if (first == 0xf4) return {4, 0x80, 0x8f};
  return {4};
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const Form form = form_of(byte(text, 0));
  if (form.length > text.size()) return 0;
  if (form.length > 1 && (byte(text, 1) < form.low || byte(text, 1) > form.high)) return 0;
  for (std::size_t i = 2; i < form.length; ++i)
    if ((byte(text, i) & 0xc0) != 0x80) return 0;
  return form.length;
}

std::size_t utf8_prefix(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = byte(text, at) < 0x80 ? 1 : utf8_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return at;
}

}  // namespace flatray
