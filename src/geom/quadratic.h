#pragma once
#include <algorithm>
#include <compare>
#include <optional>
#include <utility>

#include "geom/exact.h"

namespace flatray {

/// a + b sqrt(q), without rounding: the last arithmetic for what meets a circle or ellipse. All numbers of one
/// formula that have a root have the same.
class Quadratic {
 public:
  Quadratic(double finite) : a_(finite) {}
  Quadratic(Rational rational) : a_(std::move(rational)) {}
  Quadratic(Rational a, Rational b, Rational q)
      : a_(std::move(a)),
        b_(q.sign() == Sign::zero ? Rational(0) : std::move(b)),
        q_(std::move(q)) {}
  /// The root of a number >= 0, rational where that is.
  static Quadratic root_of(const Rational& q) {
    if (auto root = Rational::exact_root(q)) return *std::move(root);
    return {0, 1, q};
  }

  bool is_rational() const { return b_.sign() == Sign::zero; }
  /// The number where it is rational; else the middle between it and the one with the other root.
  const Rational& rational() const { return a_; }
  /// Whether there is a formula of both.
  bool shares_root(const Quadratic& other) const {
    return is_rational() || other.is_rational() || q_ == other.q_;
  }
  /// The same number by the root of another one, where that is a rational multiple.
  std::optional<Quadratic> by_root_of(const Quadratic& other) const {
    const auto share = Rational::exact_root(q_ / other.q_);
    return share ? std::optional(Quadratic(a_, b_ * *share, other.q_)) : std::nullopt;
  }

  friend Quadratic operator+(const Quadratic& x, const Quadratic& y) {
    if (x.is_rational() && y.is_rational()) return x.a_ + y.a_;
    return {x.a_ + y.a_, x.b_ + y.b_, x.under_root(y)};
  }
  friend Quadratic operator-(const Quadratic& x, const Quadratic& y) { return x + -y; }
  friend Quadratic operator*(const Quadratic& x, const Quadratic& y) {
    if (x.is_rational() && y.is_rational()) return x.a_ * y.a_;
    const Rational& q = x.under_root(y);
    return {x.a_ * y.a_ + x.b_ * y.b_ * q, x.a_ * y.b_ + x.b_ * y.a_, q};
  }
  /// Needs   y not 0; where it has a root, that of no square.
  friend Quadratic operator/(const Quadratic& x, const Quadratic& y) {
    if (!y.is_rational())
      return x * Quadratic(y.a_, -y.b_, y.q_) / Quadratic(y.a_ * y.a_ - y.b_ * y.b_ * y.q_);
    if (x.is_rational()) return x.a_ / y.a_;
    return {x.a_ / y.a_, x.b_ / y.a_, x.q_};
  }
  Quadratic operator-() const { return {-a_, -b_, q_}; }

  /// (x - a)^2 of the number x.
  Rational square_of_rest() const { return b_ * b_ * q_; }

  /// Of two numbers that may have different roots.
  friend std::strong_ordering compare(const Quadratic& x, const Quadratic& y) {
    return order(Rational::two_root_sign(x.a_ - y.a_, x.side(), x.square_of_rest(), -y.side(),
                                         y.square_of_rest()));
  }
  Sign sign() const { return Rational::root_sign(a_, side(), square_of_rest()); }
  /// Nearest double, halves to even; beyond the doubles +-infinity.
  double nearest() const { return Rational::root_sum(a_, side(), square_of_rest()); }
  /// Its value in the arithmetic of `number`, which takes a Rational.
  template <class Make>
  auto in(const Make& number) const {
    if (is_rational()) return number(a_);
    return number(a_) + number(b_) * square_root(number(q_));
  }
  /// 1 or -1 by what the root is multiplied with, 0 where it is rational.
  int side() const { return static_cast<int>(b_.sign()); }
  /// Of the longest of its numerators and denominators.
  std::size_t bits() const { return std::max({a_.bits(), b_.bits(), q_.bits()}); }

 private:
  const Rational& under_root(const Quadratic& other) const {
    return b_.sign() == Sign::zero ? other.q_ : q_;
  }

  Rational a_, b_, q_;
};

}  // namespace flatray
