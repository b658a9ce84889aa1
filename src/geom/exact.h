#pragma once
#include <compare>
#include <cstddef>
#include <optional>
#include <string>

#include "geom/predicates.h"

namespace flatray {

/// From now on a Rational, or another number of GMP or MPFR, for which there is no memory throws
/// std::bad_alloc. As it comes, GMP ends the program.
void throw_where_numbers_lack_memory();

/// Exact rational number, the last resort behind the filters. Holds any finite double without
/// rounding.
///
/// Cost    some 50 ns for a sum or product of doubles, more where there was a division: only where
///         an error bound could not decide.
/// Source  GMP, which no other file includes but the oracle for long orbits.
class Rational {
 public:
  Rational(double finite = 0);
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator-=(const Rational& b) { return *this = *this - b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  Rational& operator/=(const Rational& b);  ///< Needs b != 0.
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  Rational operator-() const;

  Sign sign() const;
  std::strong_ordering operator<=>(const Rational& b) const;
  bool operator==(const Rational& b) const;

  /// Nearest double, halves to even; beyond the doubles +-infinity. Subnormals rounded once. Never -0.
  double nearest() const;
  /// Largest integer not above it, as a Rational.
  Rational floor() const;
  /// Bits of the longer of numerator and denominator, in lowest terms, without powers of two.
  std::size_t bits() const;
  /// "19/72" or "3".
  std::string text() const;

  /// Sign of p + s * sqrt(q), s = -1, 0 or 1. Exact. Needs q >= 0.
  static Sign root_sign(const Rational& p, int s, const Rational& q);

  /// Sign of a + s1 * sqrt(q1) + s2 * sqrt(q2). Exact. Needs q1, q2 >= 0.
  static Sign two_root_sign(const Rational& a, int s1, const Rational& q1, int s2,
                            const Rational& q2);

  /// Nearest double to p + s * sqrt(q), halves to even, also where the two cancel. Needs q >= 0.
  static double root_sum(const Rational& p, int s, const Rational& q);

  /// The root, where it is a rational number too. Needs q >= 0.
  static std::optional<Rational> exact_root(const Rational& q);

  static constexpr std::size_t kBytes = 40;

 private:
  alignas(std::max_align_t) std::byte storage_[kBytes];
};

}  // namespace flatray
