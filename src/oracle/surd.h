#pragma once
#include <cmath>
#include <compare>
#include <limits>

#include "base/check.h"
#include "geom/exact.h"
#include "geom/ray.h"

namespace flatray::oracle {

/// p + s sqrt(q): a root of a quadratic equation, without rounding. Needs s = -1, 0 or 1, q >= 0.
struct Surd {
  Rational p = 0;
  int s = 0;
  Rational q = 0;

  /// offset + slope * (*this)
  Surd mapped(const Rational& offset, const Rational& slope) const;
  Sign sign() const;
  /// By squaring what is left of their difference once the parts without roots are on one side.
  std::strong_ordering operator<=>(const Surd& b) const;
  bool operator==(const Surd& b) const { return (*this <=> b) == 0; }
  /// Nearest double, halves to even; infinite beyond the doubles. check_nearest() has it, whatever
  /// arithmetic proposed it.
  double nearest() const;
};

/// The middle between a double and the next one down or up; that beyond the largest as if the
/// exponents went on.
Rational middle_to(double x, double way);

/// Checks that `t` is the double nearest to a number, or infinite where that is beyond the doubles.
/// `order(x)` compares the number with x.
template <class Order>
void check_nearest(double t, const Order& order) {
  if (std::isfinite(t)) {
    FLATRAY_CHECK(order(middle_to(t, -kInfinity)) >= 0 && order(middle_to(t, kInfinity)) <= 0,
                  "a double is not the nearest to a root");
    return;
  }
  const double most = std::copysign(std::numeric_limits<double>::max(), t);
  const auto beyond = order(middle_to(most, t));
  FLATRAY_CHECK(beyond == 0 || (beyond < 0) == (t < 0), "a root is not beyond the doubles");
}

}  // namespace flatray::oracle
