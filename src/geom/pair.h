#pragma once
#include "geom/vec.h"

namespace flatray {

/// Two numbers of any arithmetic.
template <class Number>
struct Pair {
  Number x, y;

  friend Pair operator+(const Pair& a, const Pair& b) { return {a.x + b.x, a.y + b.y}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
  friend Pair operator*(const Number& a, const Pair& b) { return {a * b.x, a * b.y}; }
};

template <class Number>
Number dot(const Pair<Number>& a, const Pair<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class Number>
Number cross(const Pair<Number>& a, const Pair<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

/// A vector of doubles in the arithmetic of `number`.
template <class Make>
auto pair_of(const Make& number, const Vec2& v) {
  return Pair<decltype(number(0.0))>{number(v.x()), number(v.y())};
}

}  // namespace flatray
