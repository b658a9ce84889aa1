#pragma once
#include "geom/pair.h"
#include "geom/ray.h"

namespace flatray {

/// A motion of the plane, or a reflection: p -> x p.x + y p.y + shift, in any arithmetic.
template <class Number>
struct Isometry {
  Pair<Number> x{1.0, 0.0}, y{0.0, 1.0}, shift{0.0, 0.0};

  Pair<Number> turned(const Pair<Number>& v) const {
    return {x.x * v.x + y.x * v.y, x.y * v.x + y.y * v.y};
  }
  Pair<Number> operator()(const Pair<Number>& p) const { return turned(p) + shift; }
  Pair<Number> back(const Pair<Number>& p) const {
    const Pair<Number> from = p - shift;
    return {dot(x, from), dot(y, from)};
  }
  /// First `first`, then this.
  Isometry operator*(const Isometry& first) const {
    return {turned(first.x), turned(first.y), (*this)(first.shift)};
  }
};

/// The reflection of a vector by a wall that runs along `along`.
template <class Number>
Pair<Number> mirrored(const Pair<Number>& along, const Pair<Number>& v) {
  const Number share = Number(2) * dot(along, v) / dot(along, along);
  return share * along - v;
}

/// The reflection in the whole line of a wall.
template <class Number>
Isometry<Number> reflection_in(const Segment& wall) {
  const Pair<Number> a{wall.a.x(), wall.a.y()}, b{wall.b.x(), wall.b.y()};
  const Pair<Number> along = b - a, one{1.0, 0.0}, other{0.0, 1.0};
  Isometry<Number> made{mirrored(along, one), mirrored(along, other), {0.0, 0.0}};
  made.shift = a - made(a);
  return made;
}

}  // namespace flatray
