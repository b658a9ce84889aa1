#pragma once
#include <algorithm>
#include <limits>

#include "geom/bounds.h"
#include "geom/enclosure.h"
#include "geom/exact.h"
#include "geom/pair.h"
#include "geom/quadratic.h"

namespace flatray {

/// For each arithmetic, the function that makes a number of it from a double.
inline constexpr auto kPlain = [](double x) { return x; };
inline constexpr auto kCounted = [](double x) { return Term<0>{x}; };
inline constexpr auto kNear = [](double x) { return Near(x); };
inline constexpr auto kQuick = [](double x) { return Quick(x); };
inline constexpr auto kBounded = [](double x) { return Bounded(x); };
inline constexpr auto kRational = [](double x) { return Rational(x); };
inline constexpr auto kQuadratic = [](double x) { return Quadratic(x); };

/// Its double, and what that is off by.
template <class Arithmetic>
Near near_of(const Enclosure<Arithmetic>& x) {
  return Near::within(x.hi(), x.error() + std::fabs(x.lo()));
}

#if defined(__x86_64__)
template <class Work>
[[gnu::target("fma"), gnu::flatten]] void work_fused(const Work& work) {
  work();
}
#endif
/// Runs `work`, all of it inlined, with fused multiplication where the machine has it; the bits are
/// the same.
template <class Work>
void with_fused(const Work& work) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("fma")) return work_fused(work);
#endif
  work();
}

/// Any point of the box of half sides `reach` about a point.
inline Pair<Near> within(const Vec2& point, const Vec2& reach) {
  return {Near::within(point.x(), reach.x()), Near::within(point.y(), reach.y())};
}

/// Any point of a box; any at all where it ends at the largest double, for which what lies beyond is taken.
inline Pair<Near> within(const Bounds& box) {
  constexpr double kMost = std::numeric_limits<double>::max();
  if (!(std::max(-box.low.minCoeff(), box.high.maxCoeff()) < kMost))
    return within(Vec2(0, 0), Vec2(kInfinity, kInfinity));
  const Vec2 centre = box.centre();
  return within(centre, (box.high - centre).cwiseMax(centre - box.low));
}

/// Sign of formula(number), where number turns a double into a number of the arithmetic to use.
/// Three are tried in turn, until one leaves no doubt: double-doubles with simple bounds,
/// double-doubles with sharp bounds, exact rationals. Filters in doubles come before, in
/// predicates.h and in trace. Exact for all finite doubles.
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

/// The same of a formula of two numbers.
template <class Formula>
Vec2 round_both(const Formula& formula) {
  std::optional<Vec2> quick;
  with_fused([&] {
    const auto both = formula(kQuick);
    if (both.x.is_rounded() && both.y.is_rounded()) quick = Vec2(both.x.hi(), both.y.hi());
  });
  if (quick) return *quick;
  return {round_once([&](const auto& number) { return formula(number).x; }),
          round_once([&](const auto& number) { return formula(number).y; })};
}

}  // namespace flatray
