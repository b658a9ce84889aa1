#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace flatray::oracle {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

/// Doubles as whole numbers of one unit: x = whole * 2^exponent, without rounding.
struct Whole {
  std::vector<std::int64_t> numbers;  ///< below 2^60 in size
  int exponent = 0;
};

/// nullopt where the smallest unit in `doubles` leaves the largest beyond 60 bits.
/// Needs   finite doubles.
std::optional<Whole> whole_numbers(std::span<const double> doubles);

/// A fraction of whole numbers, denominator positive.
struct Fraction {
  Int128 numerator = 0, denominator = 1;

  std::strong_ordering operator<=>(const Fraction& b) const;
  bool operator==(const Fraction& b) const { return (*this <=> b) == 0; }
  /// Nearest double, halves to even. Needs both below 2^126 in size.
  double nearest() const;
};

}  // namespace flatray::oracle
