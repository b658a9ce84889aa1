#pragma once
#include <compare>

#include "geom/exact.h"

namespace flatray::oracle {

/// p + s sqrt(q): a root of a quadratic equation, without rounding. Needs s = -1, 0 or 1, q >= 0.
struct Surd {
  Rational p;
  int s = 0;
  Rational q;

  /// offset + slope * (*this)
  Surd mapped(const Rational& offset, const Rational& slope) const;
  Sign sign() const;
  /// By squaring what is left of their difference once the parts without roots are on one side.
  std::strong_ordering operator<=>(const Surd& b) const;
  bool operator==(const Surd& b) const { return (*this <=> b) == 0; }
  /// Nearest double, halves to even; infinite beyond the doubles. It is checked to lie between the
  /// middles to its neighbours, whatever arithmetic proposed it.
  double nearest() const;
};

}  // namespace flatray::oracle
