#pragma once
#include <optional>

#include "geom/error_free.h"
#include "geom/predicates.h"

namespace flatray {

/// A real number known to lie within `error` of hi + lo: the middle step between doubles and
/// Rational.
///
/// Gives   the same operators as Rational, so that a formula is written once, as a template, and
/// evaluated in both.
///         Where nothing is rounded the error stays 0. Overflow makes the error infinite or NaN,
///         underflow is in the error: whatever happens, a sign or a rounding that is given is
///         right.
/// Cost    10 to 40 ns an operation.
class Bounded {
 public:
  Bounded(double exact) : value_{exact, 0}, error_(0) {}

  friend Bounded operator+(const Bounded& a, const Bounded& b);
  friend Bounded operator*(const Bounded& a, const Bounded& b);
  friend Bounded operator/(const Bounded& a, const Bounded& b);
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  Bounded operator-() const { return {{-value_.hi, -value_.lo}, error_}; }
  /// Root of a number that is certain to be positive or exactly 0; else an unknown.
  friend Bounded square_root(const Bounded& a);

  /// The sign, where the error leaves no doubt.
  std::optional<Sign> sign() const;
  /// The nearest double, where the error leaves no doubt and the result is normal or 0.
  std::optional<double> nearest() const;

  double hi() const { return value_.hi; }
  double lo() const { return value_.lo; }
  double error() const { return error_; }

 private:
  Bounded(DoubleDouble value, double error) : value_(value), error_(error) {}
  static Bounded rounded(DoubleDouble value, double from_operands, double size);

  DoubleDouble value_;
  double error_;
};

}  // namespace flatray
