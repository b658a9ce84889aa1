#pragma once
#include <vector>

#include "geom/exact.h"

namespace flatray {

/// c[0] + c[1] x + c[2] x^2 + ..., without error; the number 0 has no coefficients.
using Polynomial = std::vector<Rational>;
/// Value at a number without error.
template <class Number>
Number value_at(const Polynomial& p, const Number& x) {
  Number value = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) value = value * x + *c;
  return value;
}
Polynomial derivative(const Polynomial& p);

/// A real root of a polynomial, as an interval in which it is the only one.
///
/// Source  Sturm's chain counts the roots of an interval, halving parts them, and the greatest common
///         divisor tells roots that are equal; Abbott 2014 makes an interval smaller, by twice as many bits each
///         time.
/// Cost    some 100 us a question: for what bounds leave open.
class RealRoot {
 public:
  explicit RealRoot(const Rational& value) : p_{-value, 1}, low_(value), high_(value) {}
  /// The roots in [low, high], ascending, each once. Needs a polynomial that is not 0.
  static std::vector<RealRoot> all(const Polynomial& p, const Rational& low, const Rational& high);

  /// Sign of a polynomial at this number.
  Sign sign_of(const Polynomial& q) const;
  /// The value of a polynomial at this number, divided by that of another, which is not 0. Needs degrees up
  /// to 3.
  RealRoot value_of(const Polynomial& q, Polynomial over = {1}) const;
  Sign sign() const { return sign_of({0, 1}); }
  /// Nearest double, halves to even; beyond the doubles +-infinity. Never -0.
  double nearest() const;

  friend std::strong_ordering compare(const RealRoot& a, const RealRoot& b);

 private:
  RealRoot(Polynomial p, Rational low, Rational high);
  void narrow();
  void refine() const;

  Polynomial p_;                 // without double roots
  mutable Rational low_, high_;  // equal, or p_ differs in sign there
  mutable int bits_ = 4;         // see refine
};

/// Which of two is less. Exact.
std::strong_ordering compare(const RealRoot& a, const RealRoot& b);

}  // namespace flatray
