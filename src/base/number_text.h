#pragma once
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace flatray {

/// Shortest decimal that reads back as the same double, without regard to the locale: "0.1",
/// "1e+300", "-0".
std::string number_text(double value);

/// A decimal number read whole and rounded correctly; nullopt if `text` is anything else or beyond
/// the doubles. Underflow gives the nearest double, 0 included. Accepts a leading '+', as TOML and
/// OBJ do.
std::optional<double> parse_number(std::string_view text);

/// A whole number read whole; nullopt if `text` is anything else or beyond Int.
template <class Int>
std::optional<Int> parse_digits(std::string_view text, int base = 10) {
  Int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace flatray
