#pragma once
#include <compare>
#include <memory>
#include <vector>

#include "oracle/surd.h"

namespace flatray::oracle {

/// c[0] + c[1] x + c[2] x^2 + ...; of the number 0 no coefficient.
using Polynomial = std::vector<Rational>;
Polynomial derivative(const Polynomial& p);
Polynomial common_divisor(Polynomial p, Polynomial q);

/// A real root of a polynomial, by an interval that holds no other root of it.
///
/// Source  Bisection parts roots and tells numbers apart; where that comes to no end, Sturm's chains
///         count roots, and common divisors tell equal numbers.
/// Cost    some 10 us for a comparison, 100 of equal numbers.
class Algebraic {
 public:
  /// The roots in [low, high], ascending, each once. Needs a polynomial other than 0.
  static std::vector<Algebraic> roots(const Polynomial& p, const Rational& low,
                                      const Rational& high);
  explicit Algebraic(const Surd& surd);

  /// Sign of a polynomial at this number.
  Sign sign_of(const Polynomial& q) const;
  /// The value of a polynomial at this number.
  Algebraic value_of(const Polynomial& q) const;
  std::strong_ordering operator<=>(const Algebraic& b) const;
  bool operator==(const Algebraic& b) const { return (*this <=> b) == 0; }
  Sign sign() const { return sign_of({0, 1}); }
  /// As Surd::nearest().
  double nearest() const;

 private:
  struct Value;
  Algebraic(Polynomial p, Rational low, Rational high);
  Algebraic(std::shared_ptr<const Value> value);
  void take_range() const;
  void settle() const;
  void halve() const;
  const Polynomial& polynomial() const;

  mutable Polynomial p_;  // of which it is a simple root; of a value none until one is asked for
  mutable Rational low_, high_;         // equal, or of other signs of p_
  mutable Sign at_low_ = Sign::zero;    // of p_
  std::shared_ptr<const Value> value_;  // of a polynomial at another number
};

}  // namespace flatray::oracle
