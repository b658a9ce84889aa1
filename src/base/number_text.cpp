#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatray {
namespace {

// The number after the 'e', as far as an int reaches: beyond that every number is out of range
// alike.
std::int64_t exponent_of(std::string_view digits) {
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  int exponent = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (read.ec == std::errc{}) return exponent;
  return digits.front() == '-' ? std::numeric_limits<int>::min() : std::numeric_limits<int>::max();
}

// from_chars reports under- and overflow alike; below 1 every out-of-range number has underflowed.
// Needs a number as from_chars reads it, not 0.
bool is_below_one(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::int64_t exponent = e < text.size() ? exponent_of(text.substr(e + 1)) : 0;
  const std::string_view mantissa = text.substr(0, e);
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), e));
  const auto first = static_cast<std::int64_t>(mantissa.find_first_of("123456789"));
  return (first < point ? point - first : point - first + 1) + exponent <= 0;
}

}  // namespace

std::string number_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    return is_below_one(text) ? std::optional(text.front() == '-' ? -0.0 : 0.0) : std::nullopt;
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace flatray
