#pragma once
#include <mpfr.h>

#include <optional>

#include "geom/enclosure.h"
#include "geom/exact.h"

namespace flatray {

/// A real number known to lie within a radius of a midpoint of chosen precision: the arithmetic of
/// geom/enclosure.h for any number of bits.
///
/// Gives   where nothing is rounded the radius stays 0. Overflow makes it infinite or NaN: a sign or
///         a rounding that is given is right, whatever happens.
/// Source  MPFR, which no other file includes: part of the module flatray_certified.so.
class Ball {
 public:
  /// Needs   bits >= 53, so that every double is held.
  Ball(double exact, int bits);
  Ball(const Rational& exact, int bits);
  Ball(const Ball& other);
  Ball(Ball&& other) noexcept;
  Ball& operator=(const Ball& other);
  Ball& operator=(Ball&& other) noexcept;
  ~Ball();

  friend Ball operator+(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a, const Ball& b);
  friend Ball operator*(const Ball& a, const Ball& b);
  friend Ball operator/(const Ball& a, const Ball& b);
  Ball operator-() const;
  /// Root of a number that is certain to be positive; else an unknown.
  friend Ball square_root(const Ball& a);
  /// A number about 0 that is either root of what may not be negative of a.
  friend Ball either_root(const Ball& a);

  /// The sign, where the radius leaves no doubt.
  std::optional<Sign> sign() const;
  /// The nearest double, where the radius leaves no doubt and it is finite.
  std::optional<double> nearest() const;
  /// Its double, and what that is off by.
  friend Near near_of(const Ball& x);

  /// It is known to be the sum of these: one without error, and one about 0.
  Ball middle() const;
  Ball rest() const;

 private:
  explicit Ball(mpfr_prec_t bits);
  void add_rounding(int inexact);
  void make_unknown();
  mpfr_prec_t bits() const { return mpfr_get_prec(middle_); }

  mpfr_t middle_, radius_;
};

}  // namespace flatray
