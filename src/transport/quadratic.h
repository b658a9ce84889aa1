#pragma once
#include "geom/exact.h"

namespace flatray {

/// a + b sqrt(q), without rounding; all numbers of one formula that have a root have the same.
class Quadratic {
 public:
  Quadratic(double finite) : a_(finite) {}
  Quadratic(Rational a, Rational b, Rational q)
      : a_(std::move(a)), b_(std::move(b)), q_(std::move(q)) {}

  friend Quadratic operator+(const Quadratic& x, const Quadratic& y) {
    return {x.a_ + y.a_, x.b_ + y.b_, x.root_of(y)};
  }
  friend Quadratic operator-(const Quadratic& x, const Quadratic& y) { return x + -y; }
  friend Quadratic operator*(const Quadratic& x, const Quadratic& y) {
    const Rational& q = x.root_of(y);
    return {x.a_ * y.a_ + x.b_ * y.b_ * q, x.a_ * y.b_ + x.b_ * y.a_, q};
  }
  /// Needs   y rational and not 0.
  friend Quadratic operator/(const Quadratic& x, const Quadratic& y) {
    return {x.a_ / y.a_, x.b_ / y.a_, x.q_};
  }
  Quadratic operator-() const { return {-a_, -b_, q_}; }

  /// Nearest double, halves to even; beyond the doubles +-infinity.
  double nearest() const {
    return Rational::root_sum(a_, static_cast<int>(b_.sign()), b_ * b_ * q_);
  }

 private:
  const Rational& root_of(const Quadratic& other) const {
    return b_.sign() == Sign::zero ? other.q_ : q_;
  }

  Rational a_, b_, q_;
};

}  // namespace flatray
