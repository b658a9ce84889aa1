#pragma once
#include <compare>
#include <vector>

#include "oracle/surd.h"

namespace flatray::oracle {

/// c[0] + c[1] x + c[2] x^2 + ...; of the number 0 no coefficient.
using Polynomial = std::vector<Rational>;
Polynomial derivative(const Polynomial& p);
Polynomial common_divisor(Polynomial p, Polynomial q);

/// A real root of a polynomial, by an interval that holds no other root of it.
///
/// Source  Sturm's chains count roots; bisection parts them; common divisors tell equal numbers.
/// Cost    some 100 us for a comparison.
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
  Algebraic(Polynomial p, Rational low, Rational high);
  void halve() const;
  bool is_root_of(const Polynomial& divisor) const;

  Polynomial p_;                 // without double roots
  mutable Rational low_, high_;  // equal, or of other signs of p_
};

}  // namespace flatray::oracle
