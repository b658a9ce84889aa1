#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "geom/vec.h"

namespace flatray {

inline double size_of(double x) { return std::fabs(x); }
inline bool is_zero(double x) { return x == 0; }

/// A number or a place over time: c[0] + c[1] t + c[2] t^2 + c[3] t^3.
///
/// Gives   bounds of the size for t in [0, length], but for rounding: `sum` of its terms; `most`,
///         `most_slope` and `most_bend` of it and its derivatives, by their Bezier points.
template <class Value>
struct Cubic {
  std::array<Value, 4> c;

  Value operator()(double t) const { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
  Value slope(double t) const { return c[1] + t * (2 * c[2] + t * (3 * c[3])); }

  bool is_linear() const { return is_zero(c[2]) && is_zero(c[3]); }
  bool is_constant() const { return is_linear() && is_zero(c[1]); }

  std::array<Value, 4> bezier_points(double length) const {
    const double third = length / 3, squared = length * third;
    return {c[0], c[0] + third * c[1], c[0] + 2 * third * c[1] + squared * c[2], (*this)(length)};
  }
  double sum(double length) const {
    return size_of(c[0]) +
           length * (size_of(c[1]) + length * (size_of(c[2]) + length * size_of(c[3])));
  }
  double sum_of_slope(double length) const {
    return size_of(c[1]) + length * (2 * size_of(c[2]) + length * 3 * size_of(c[3]));
  }
  double most(double length) const {
    double most = 0;
    for (const Value& point : bezier_points(length)) most = std::max(most, size_of(point));
    return most;
  }
  double most_slope(double length) const {
    const Value middle = c[1] + length * c[2];
    return std::max({size_of(c[1]), size_of(middle), size_of(slope(length))});
  }
  double most_bend(double length) const {
    const Value first = 2 * c[2], last = first + 6 * length * c[3];
    return std::max(size_of(first), size_of(last));
  }
};

inline Cubic<double> linear(double from, double way) { return {{from, way, 0, 0}}; }
inline Cubic<Vec2> linear(const Vec2& from, const Vec2& way) {
  const Vec2 none(0, 0);
  return {{from, way, none, none}};
}

template <class Value>
Cubic<Value> operator+(Cubic<Value> p, const Cubic<Value>& q) {
  for (std::size_t i = 0; i < 4; ++i) p.c[i] += q.c[i];
  return p;
}
template <class Value>
Cubic<Value> operator-(Cubic<Value> p, const Cubic<Value>& q) {
  for (std::size_t i = 0; i < 4; ++i) p.c[i] -= q.c[i];
  return p;
}
template <class Value>
Cubic<Value> operator*(double factor, Cubic<Value> p) {
  for (Value& term : p.c) term *= factor;
  return p;
}

}  // namespace flatray
