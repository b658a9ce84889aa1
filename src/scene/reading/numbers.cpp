#include "scene/reading/numbers.h"

#include <algorithm>

#include "base/number_text.h"

namespace flatray {
namespace {

// Beyond this no double is meant, and the powers of ten would no longer be small.
constexpr long kMaxExponent = 100000;
// Every integer of so many digits is a double.
constexpr std::size_t kChunkDigits = 15;
// Longer decimals than this are not read by people.
constexpr std::size_t kMaxShownDigits = 40;

std::string without_underscores(std::string_view text) {
  std::string plain(text);
  std::erase(plain, '_');
  return plain;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Moves the digits at the front of `text` to `digits`; gives how many there were.
std::size_t take_digits(std::string_view& text, std::string& digits) {
  const auto end = std::ranges::find_if_not(text, is_digit);
  const auto count = static_cast<std::size_t>(end - text.begin());
  digits.append(text.substr(0, count));
  text.remove_prefix(count);
  return count;
}

// "e-12" at the front of `text`, or nothing.
std::optional<long> take_exponent(std::string_view text) {
  if (text.empty()) return 0;
  if (text.front() != 'e' && text.front() != 'E') return std::nullopt;
  text.remove_prefix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::optional<long> exponent = parse_digits<long>(text);
  return exponent && std::abs(*exponent) <= kMaxExponent ? exponent : std::nullopt;
}

void strip_zeros(Decimal& decimal) {
  const std::size_t last = decimal.digits.find_last_not_of('0');
  if (last == std::string::npos) {
    decimal = {};
    return;
  }
  decimal.exponent += static_cast<long>(decimal.digits.size() - last - 1);
  decimal.digits.resize(last + 1);
  decimal.digits.erase(0, decimal.digits.find_first_not_of('0'));
}

Rational power_of_ten(long exponent) {
  Rational power = 1;
  for (; exponent >= 15; exponent -= 15) power *= 1e15;
  for (; exponent > 0; --exponent) power *= 10;
  return power;
}

// 0x1f, 0o17, 0b11.
std::optional<std::uint64_t> parse_prefixed(std::string_view text) {
  if (text.size() < 3 || text[0] != '0') return std::nullopt;
  const int base = text[1] == 'x' ? 16 : text[1] == 'o' ? 8 : text[1] == 'b' ? 2 : 0;
  return base == 0 ? std::nullopt : parse_digits<std::uint64_t>(text.substr(2), base);
}

Number nearest_double(std::uint64_t whole) {
  const auto nearest = static_cast<double>(whole);
  const bool exact = nearest < 0x1p64 && static_cast<std::uint64_t>(nearest) == whole;
  return {nearest, exact ? Number::Loss::none : Number::Loss::integer};
}

Number::Loss loss_of(std::string_view text, double value) {
  const std::optional<Decimal> decimal = parse_decimal(text);
  const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
  if (value == 0 && mantissa.find_first_of("123456789") != std::string_view::npos)
    return Number::Loss::underflow;
  const bool written_out = text.find_first_of("eE") == std::string_view::npos;
  if (!decimal || !written_out || decimal->exponent < 0) return Number::Loss::none;
  if (decimal->digits.size() <= kChunkDigits) return Number::Loss::none;
  return to_rational(*decimal) == Rational(value) ? Number::Loss::none : Number::Loss::integer;
}

}  // namespace

std::optional<Decimal> parse_decimal(std::string_view text) {
  const std::string plain = without_underscores(text);
  std::string_view rest = plain;
  Decimal decimal;
  if (const auto whole = parse_prefixed(plain)) {
    decimal.digits = std::to_string(*whole);
    strip_zeros(decimal);
    return decimal;
  }
  decimal.negative = rest.starts_with('-');
  if (decimal.negative || rest.starts_with('+')) rest.remove_prefix(1);
  std::size_t digits = take_digits(rest, decimal.digits);
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    const std::size_t decimals = take_digits(rest, decimal.digits);
    decimal.exponent = -static_cast<long>(decimals);
    digits += decimals;
  }
  const std::optional<long> exponent = take_exponent(rest);
  if (digits == 0 || !exponent) return std::nullopt;
  decimal.exponent += *exponent;
  strip_zeros(decimal);
  return decimal;
}

Rational to_rational(const Decimal& decimal) {
  Rational value = 0;
  for (std::size_t i = 0; i < decimal.digits.size(); i += kChunkDigits) {
    const std::string chunk = decimal.digits.substr(i, kChunkDigits);
    value *= power_of_ten(static_cast<long>(chunk.size()));
    value += static_cast<double>(std::stoll(chunk));
  }
  if (decimal.exponent >= 0)
    value *= power_of_ten(decimal.exponent);
  else
    value /= power_of_ten(-decimal.exponent);
  return decimal.negative ? -value : value;
}

std::string decimal_text(const Rational& value) {
  Rational scaled = value;
  std::size_t decimals = 0;
  for (; decimals <= kMaxShownDigits && scaled != scaled.floor(); ++decimals) scaled *= 10;
  std::string digits = scaled.text();
  if (scaled != scaled.floor() || digits.size() > kMaxShownDigits)
    return number_text(value.nearest());
  if (decimals == 0) return digits;
  const std::string sign = digits.front() == '-' ? "-" : "";
  digits.erase(0, sign.size());
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  return sign + digits.insert(digits.size() - decimals, ".");
}

std::optional<Number> parse_literal(std::string_view text) {
  const std::string plain = without_underscores(text);
  if (const auto whole = parse_prefixed(plain)) return nearest_double(*whole);
  const std::optional<double> value = parse_number(plain);
  if (!value) return std::nullopt;
  return Number{*value, loss_of(plain, *value)};
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  constexpr long kMostZeros = 18;
  const std::optional<Decimal> decimal = parse_decimal(text);
  if (!decimal || decimal->exponent < 0 || decimal->exponent > kMostZeros) return std::nullopt;
  if (decimal->digits.empty()) return 0;
  const std::string zeros(static_cast<std::size_t>(decimal->exponent), '0');
  return parse_digits<std::int64_t>((decimal->negative ? "-" : "") + decimal->digits + zeros);
}

}  // namespace flatray
