#pragma once
#include <optional>

#include "geom/error_bounds.h"
#include "geom/error_free.h"
#include "geom/predicates.h"

namespace flatray {

/// A real number known to lie within `error` of hi + lo: the middle step between doubles and
/// Rational.
///
/// Gives   the same operators as Rational, so that a formula is written once, as a template, and
///         evaluated in both. Where nothing is rounded the error stays 0. Overflow makes the error
///         infinite or NaN, underflow is in the error: whatever happens, a sign or a rounding that
///         is given is right.
class Bounded {
 public:
  Bounded(double exact) : value_{exact, 0}, error_(0) {}
  /// A number known to be no farther than `error` from `about`.
  static Bounded within(double about, double error) { return {{about, 0}, error}; }

  friend Bounded operator+(const Bounded& a, const Bounded& b);
  friend Bounded operator*(const Bounded& a, const Bounded& b);
  friend Bounded operator/(const Bounded& a, const Bounded& b);
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  Bounded operator-() const { return {{-value_.hi, -value_.lo}, error_}; }
  /// Root of a number that is certain to be positive or exactly 0; else an unknown.
  friend Bounded square_root(const Bounded& a);
  /// A number about 0 that is either root of what may not be negative of a.
  friend Bounded either_root(const Bounded& a);

  /// It is known to be the sum of these: one without error, and one about 0.
  Bounded middle() const { return {value_, 0}; }
  Bounded rest() const { return {{0, 0}, error_}; }

  /// The sign, where the error leaves no doubt.
  std::optional<Sign> sign() const;
  /// The nearest double, where the error leaves no doubt and the result is normal or 0.
  std::optional<double> nearest() const;

  double hi() const { return value_.hi; }
  double lo() const { return value_.lo; }
  double error() const { return error_; }

 private:
  Bounded(DoubleDouble value, double error) : value_(value), error_(error) {}
  bool is_exact_zero() const { return value_.hi == 0 && value_.lo == 0 && error_ == 0; }
  bool is_finite() const { return std::fabs(value_.hi) + error_ < kInfinity; }
  static Bounded rounded(DoubleDouble value, double from_operands, double size);

  DoubleDouble value_;
  double error_;
};

// A product of doubles that two_product gives without error.
inline bool is_exact_product(double a, double b) {
  const double size = std::fabs(a * b);
  return a == 0 || b == 0 || (size >= kExactProductLeast && size <= kExactProductMost);
}

// A result that one operation rounded, in which `size` is the largest that went in or came out.
inline Bounded Bounded::rounded(DoubleDouble value, double from_operands, double size) {
  const double own = kDoubleDoubleError * size + kUnderflowError;
  return {value, (from_operands + own) * kRadiusInflation};
}

inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const DoubleDouble high = two_sum(a.value_.hi, b.value_.hi);
  const DoubleDouble low = two_sum(a.value_.lo, b.value_.lo);
  const DoubleDouble middle = two_sum(high.lo, low.hi);
  const DoubleDouble sum = two_sum(high.hi, middle.hi);
  const DoubleDouble tail = two_sum(sum.lo, low.lo);
  const DoubleDouble value = two_sum(sum.hi, tail.hi);
  const double error = a.error_ + b.error_;
  // What the two roundings left out is known, so a sum of few bits stays exact.
  if (middle.lo == 0 && tail.lo == 0) return {value, error * kRadiusInflation};
  return Bounded::rounded(value, error, std::fabs(a.value_.hi) + std::fabs(b.value_.hi));
}

inline Bounded operator*(const Bounded& a, const Bounded& b) {
  if ((a.is_exact_zero() && b.is_finite()) || (b.is_exact_zero() && a.is_finite())) return {0};
  const DoubleDouble high = two_product(a.value_.hi, b.value_.hi);
  const double middle = a.value_.hi * b.value_.lo + a.value_.lo * b.value_.hi;
  const DoubleDouble value = two_sum(high.hi, high.lo + middle);
  const bool short_factors = a.value_.lo == 0 && b.value_.lo == 0;
  if (short_factors && a.error_ == 0 && b.error_ == 0 && is_exact_product(a.value_.hi, b.value_.hi))
    return {value, 0};
  // (a + da)(b + db) - ab, with twice the high parts to stand for the whole values
  const double error = 2 * std::fabs(a.value_.hi) * b.error_ +
                       2 * std::fabs(b.value_.hi) * a.error_ + a.error_ * b.error_;
  return Bounded::rounded(value, error, std::fabs(high.hi));
}

}  // namespace flatray
