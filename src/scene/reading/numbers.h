#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geom/exact.h"

namespace flatray {

/// A decimal exactly as written: +-digits * 10^exponent, `digits` without zeros at its ends; zero
/// has none.
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;

  bool operator==(const Decimal&) const = default;
};

/// Reads "12", "-0.50", "1_000.5e-3", "0x1f". nullopt for anything else and for exponents beyond +-100000.
std::optional<Decimal> parse_decimal(std::string_view text);
Rational to_rational(const Decimal& decimal);

/// A rational that is a finite decimal, written out; others, and very long ones, as the nearest
/// double.
std::string decimal_text(const Rational& value);

/// A number read from its source text, and what reading lost.
struct Number {
  enum class Loss {
    none,
    integer,    ///< written out as an integer that no double holds
    underflow,  ///< not 0 as written, 0 as a double
  };
  double value = 0;
  Loss loss = Loss::none;
};

/// Nearest double of a TOML number (underscores, 0x, 0o, 0b). nullopt: not finite, or no number.
std::optional<Number> parse_literal(std::string_view text);

/// A whole number of TOML, exact also beyond 2^53; "1e3" and "5.0" are whole too. nullopt: no such
/// 64-bit integer.
std::optional<std::int64_t> parse_integer(std::string_view text);

}  // namespace flatray
