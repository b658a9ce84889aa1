#pragma once
#include <algorithm>
#include <limits>
#include <optional>

#include "geom/arithmetics.h"
#include "geom/sign.h"

namespace flatray {

/// A real number known to lie within error() of a middle, in one of the arithmetics.
///
/// Gives   the same operators as Rational, so that a formula is written once, as a template. How
///         errors go from operands to results is the same in all arithmetics. Overflow makes the error
///         infinite or NaN, underflow is in the error: a sign or a rounding that is given is right,
///         whatever happens.
/// Error   of each operation: what the arithmetic loses, and what the operands are off by. The error
///         is itself rounded, for which kSlack stands in up to 2^30 operations.
template <class Arithmetic>
class Enclosure {
 public:
  using Value = typename Arithmetic::Value;

  Enclosure(double exact) : Enclosure(Arithmetic::of(exact), 0) {}
  Enclosure(const Value& value, double error) : value_(value), error_(error) {}
  /// A number known to be no farther than `error` from `about`.
  static Enclosure within(double about, double error) { return {Arithmetic::of(about), error}; }

  Enclosure operator-() const { return {Arithmetic::negative(value_), error_}; }
  friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    const auto sum = Arithmetic::sum(a.value_, b.value_);
    return {sum.value, a.error_ + b.error_ + sum.lost};
  }
  friend Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + -b; }
  friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    if constexpr (Arithmetic::kKnowsExact)
      if ((a.is_exact_zero() && b.is_finite()) || (b.is_exact_zero() && a.is_finite())) return 0.0;
    const auto product = Arithmetic::product(a.value_, b.value_);
    const double from_operands = times(a.size() + a.error_, b.error_) + times(b.size(), a.error_);
    return {product.value, from_operands + product.lost + underflow(a, b)};
  }
  /// |a / b - q| <= (|a - b q| + da + |q| db) / (|b| - db)
  friend Enclosure operator/(const Enclosure& a, const Enclosure& b) {
    const auto quotient = Arithmetic::quotient(a.value_, b.value_);
    const double least = b.size() * (1 - kNear) - b.error();
    if constexpr (Arithmetic::kKnowsExact)
      if (least > 0 && a.is_exact_zero()) return a;
    const double from_operands =
        a.error_ + std::fabs(Arithmetic::high(quotient.value)) * (1 + kNear) * b.error_;
    return {quotient.value, bound(from_operands + quotient.lost + underflow(a, b), least)};
  }
  /// Root of a number that is certain to be positive or exactly 0; else an unknown.
  /// |sqrt(a) - r| <= (|a - r^2| + da) / r
  friend Enclosure square_root(const Enclosure& a) {
    if constexpr (Arithmetic::kKnowsExact)
      if (a.is_exact_zero()) return a;
    const auto root = Arithmetic::root(a.value_);
    const double least = a.is_sign_known() && Arithmetic::high(a.value_) > 0
                             ? Arithmetic::high(root.value) * (1 - kNear)
                             : 0;
    return {root.value, bound(a.error_ + root.lost, least)};
  }
  /// A number about 0 that is either root of what may not be negative of a.
  friend Enclosure either_root(const Enclosure& a) {
    return within(0, std::sqrt(a.size() * (1 + kNear) + a.error() + kUnderflowError) * kSlack);
  }

  /// The sign, where the error leaves no doubt.
  std::optional<Sign> sign() const {
    const bool known = is_sign_known() || (Arithmetic::kKnowsExact && error_ == 0);
    return known ? std::optional(sign_of(Arithmetic::high(value_))) : std::nullopt;
  }
  /// The nearest double, where the error leaves no doubt and it is normal or 0. Needs   double-doubles.
  std::optional<double> nearest() const {
    return is_rounded() ? std::optional(hi() + 0.0) : std::nullopt;  // never -0
  }
  bool is_rounded() const {
    // All that the number may be rounds to `hi`; the second term is for rounding lo +- reach.
    const double reach = error() + 0x1p-52 * std::fabs(lo());
    return hi() + (lo() + reach) == hi() && hi() + (lo() - reach) == hi() && size() < kUnknown;
  }
  /// Bounds of it. Needs   Doubles.
  double low() const { return value_ - (error() + 0x1p-52 * size()); }
  double high() const { return -(-*this).low(); }

  /// It is known to be the sum of these: one without error, and one about 0.
  Enclosure middle() const { return {value_, 0}; }
  Enclosure rest() const { return within(0, error_); }

  const Value& value() const { return value_; }
  double hi() const { return value_.hi; }
  double lo() const { return value_.lo; }
  double error() const { return error_ * kSlack; }
  double size() const { return std::fabs(Arithmetic::high(value_)); }

 private:
  static constexpr double kSlack = 1 + 0x1p-20, kNear = 0x1p-50;
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  bool is_exact_zero() const { return hi() == 0 && lo() == 0 && error_ == 0; }
  bool is_finite() const { return size() + error_ < kUnknown; }
  bool is_sign_known() const { return size() * (1 - kNear) > error(); }
  static double times(double size, double error) {
    return is_surely_zero(error) ? 0 : size * error;
  }
  // Of products of errors; where operations know when they lose nothing it is not in what they lost.
  static double underflow(const Enclosure& a, const Enclosure& b) {
    if constexpr (!Arithmetic::kKnowsExact) return 0;
    return a.error_ + b.error_ > 0 ? kUnderflowError : 0;
  }
  static double bound(double miss, double least) {
    if (!(least > 0)) return kUnknown;
    if (Arithmetic::kKnowsExact && miss == 0) return 0;
    return miss / least + kUnderflowError;
  }

  Value value_;
  double error_;
};

using Near = Enclosure<Doubles>;                ///< some 4 ns an operation
using Quick = Enclosure<DoubleDoubles>;         ///< of which a sign of 0 is always in doubt
using Bounded = Enclosure<SharpDoubleDoubles>;  ///< between doubles and Rational

/// A product of doubles and of their differences, each rounded once: off by `kRoundings` factors
/// 1 + e, |e| <= u, and by what underflowed.
template <int kRoundings>
struct Term {
  double value;
};

/// A sum of terms, off by at most kRoundings u of `size`, the sum of their sizes, but for its last
/// rounding, products of roundings, and underflow.
///
/// Error   of a bound: one u more pays for products of roundings, and for those of the bound itself.
///         No rounding changes the sign of a sum. Up to eight products underflow by kUnderflowError.
template <int kRoundings>
struct Terms {
  double value, size;

  /// Zero where it is in doubt; `underflow` is what that may have taken away.
  Sign sure_sign(double underflow = kUnderflowError) const {
    constexpr double kBound = (kRoundings + 1) * kDoubleError;
    return std::fabs(value) > kBound * size + underflow ? sign_of(value) : Sign::zero;
  }
  operator Near() const {
    constexpr double kBound = (kRoundings + 2) * kDoubleError;
    return Near::within(value, kBound * size + kUnderflowError);
  }
};

inline Term<1> operator-(const Term<0>& a, const Term<0>& b) { return {a.value - b.value}; }
template <int kA, int kB>
Term<kA + kB + 1> operator*(const Term<kA>& a, const Term<kB>& b) {
  return {a.value * b.value};
}
template <int kA, int kB>
Terms<std::max(kA, kB)> operator+(const Term<kA>& a, const Term<kB>& b) {
  return {a.value + b.value, std::fabs(a.value) + std::fabs(b.value)};
}
template <int kA, int kB>
Terms<std::max(kA, kB)> operator-(const Term<kA>& a, const Term<kB>& b) {
  return {a.value - b.value, std::fabs(a.value) + std::fabs(b.value)};
}
template <int kA, int kB>
Terms<std::max(kA, kB) + 1> operator-(const Terms<kA>& a, const Terms<kB>& b) {
  return {a.value - b.value, a.size + b.size};
}

}  // namespace flatray
