#pragma once
#include <cmath>
#include <compare>
#include <cstdint>

#include "geom/error_bounds.h"
#include "geom/ray.h"

namespace flatray {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

inline Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
inline Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
inline Sign sign_of(std::strong_ordering order) {
  return order > 0 ? Sign::positive : order < 0 ? Sign::negative : Sign::zero;
}
inline std::strong_ordering order(Sign s) { return static_cast<int>(s) <=> 0; }
inline Sign sign_of(double x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

/// What cross_sign gives where its filter could not tell.
Sign uncertain_cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Sign of (b - a) x (d - c), which the others are made of. Exact for all finite doubles.
inline Sign cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double left = (b.x() - a.x()) * (d.y() - c.y());
  const double right = (b.y() - a.y()) * (d.x() - c.x());
  const double size = std::fabs(left) + std::fabs(right), difference = left - right;
  // An overflow makes `size` infinite or NaN, and no comparison holds.
  if (size >= kDetFilterLeast && std::fabs(difference) > kDetFilter * size)
    return sign_of(difference);
  return uncertain_cross_sign(a, b, c, d);
}

/// Side of `c` seen from a to b: positive to the left, zero on the line. Exact for all finite
/// doubles.
Sign orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of a x b for given vectors. Exact for all finite doubles.
Sign cross_sign(const Vec2& a, const Vec2& b);

/// Sign of cross(d, p - o): the side of `p` seen from `o` along `d`. Exact.
Sign side_of_ray(const Ray& ray, const Vec2& p);

/// Sign of cross(b - a, d): whether direction d turns left of the edge a -> b. Exact.
Sign turn_from_edge(const Vec2& a, const Vec2& b, const Vec2& d);

}  // namespace flatray
