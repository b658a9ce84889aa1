#pragma once
#include <type_traits>

#include "geom/vec.h"

namespace flatray {

/// Two numbers of any arithmetic.
template <class Number>
struct Pair {
  Number x, y;
};

/// A number as numer / denom, in any arithmetic.
template <class Number>
struct Quotient {
  Number numer, denom;
};

/// What comes of two numbers: one of their own type where it can be, as numbers of GMP give
/// expressions that are still to be computed.
template <class A, class B, class Result>
using NumberOf =
    std::conditional_t<std::is_same_v<A, B> && std::is_convertible_v<Result, A>, A, Result>;

template <class A, class B>
auto operator+(const Pair<A>& a, const Pair<B>& b) -> Pair<NumberOf<A, B, decltype(a.x + b.x)>> {
  return {a.x + b.x, a.y + b.y};
}
template <class A, class B>
auto operator-(const Pair<A>& a, const Pair<B>& b) -> Pair<NumberOf<A, B, decltype(a.x - b.x)>> {
  return {a.x - b.x, a.y - b.y};
}
template <class Number>
Pair<Number> operator*(const std::type_identity_t<Number>& a, const Pair<Number>& b) {
  return {a * b.x, a * b.y};
}

template <class A, class B>
auto dot(const Pair<A>& a, const Pair<B>& b) -> NumberOf<A, B, decltype(a.x * b.x + a.y * b.y)> {
  return a.x * b.x + a.y * b.y;
}

template <class A, class B>
auto cross(const Pair<A>& a, const Pair<B>& b) -> NumberOf<A, B, decltype(a.x * b.y - a.y * b.x)> {
  return a.x * b.y - a.y * b.x;
}

/// A vector of doubles in the arithmetic of `number`.
template <class Make>
auto pair_of(const Make& number, const Vec2& v) {
  return Pair<decltype(number(0.0))>{number(v.x()), number(v.y())};
}

/// (b - a) x (d - c) in the arithmetic of `number`.
template <class Make>
auto determinant(const Make& number, const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(pair_of(number, b) - pair_of(number, a), pair_of(number, d) - pair_of(number, c));
}

}  // namespace flatray
