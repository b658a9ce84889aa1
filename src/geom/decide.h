#pragma once
#include <algorithm>
#include <limits>

#include "geom/bounded.h"
#include "geom/exact.h"
#include "geom/quick.h"

namespace flatray {

/// What makes a double a number of each arithmetic.
inline constexpr auto kPlain = [](double x) { return x; };
inline constexpr auto kQuick = [](double x) { return Quick(x); };
inline constexpr auto kBounded = [](double x) { return Bounded(x); };
inline constexpr auto kRational = [](double x) { return Rational(x); };

/// Sign of formula(number), where number turns a double into the arithmetic to use:
/// double-doubles with simple bounds, with sharp bounds, the exact rationals, each where those
/// before leave a doubt. Exact for all finite doubles.
///
///   decide([&](auto number) { return number(a) * number(b) - number(c); })
template <class Formula>
Sign decide(const Formula& formula) {
  std::optional<Sign> quick;
  with_fused([&] { quick = formula(kQuick).sign(); });
  if (quick) return *quick;
  if (const auto sign = formula(kBounded).sign()) return *sign;
  return formula(kRational).sign();
}

/// Nearest double to formula(number), rounded once, halves to even; the largest of its sign beyond
/// the doubles. Never -0.
template <class Formula>
double round_once(const Formula& formula) {
  std::optional<double> quick;
  with_fused([&] { quick = formula(kQuick).nearest(); });
  if (quick) return *quick;
  if (const auto value = formula(kBounded).nearest()) return *value;
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(formula(kRational).nearest(), -largest, largest);
}

/// (b - a) x (d - c) in the arithmetic of `number`.
template <class Number>
auto determinant(const Number& number, const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return (number(b.x()) - number(a.x())) * (number(d.y()) - number(c.y())) -
         (number(b.y()) - number(a.y())) * (number(d.x()) - number(c.x()));
}

}  // namespace flatray
