#pragma once
#include "geom/enclosure.h"
#include "geom/pair.h"
#include "geom/ray.h"

namespace flatray {

/// What cross_sign gives where its filter could not tell.
Sign uncertain_cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Sign of (b - a) x (d - c), of which the other predicates are made. Exact for all finite doubles.
inline Sign cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Sign sign = determinant([](double x) { return Term<0>{x}; }, a, b, c, d).sure_sign();
  if (sign != Sign::zero) return sign;
  return uncertain_cross_sign(a, b, c, d);
}

/// Side of `c` seen from a to b: positive to the left, zero on the line. Exact for all finite
/// doubles.
Sign orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of a x b for given vectors. Exact for all finite doubles.
Sign cross_sign(const Vec2& a, const Vec2& b);

/// Whether a and b lie in one direction from a centre, or one is it. Exact.
bool lie_in_one_direction(const Vec2& centre, const Vec2& a, const Vec2& b);

/// Sign of cross(d, p - o): the side of `p` seen from `o` along `d`, positive to the left. Exact.
/// It decides whether a ray meets a straight wall or a convex polygon.
Sign side_of_ray(const Ray& ray, const Vec2& p);

/// Sign of cross(b - a, d): whether direction d turns left of the edge a -> b. Exact.
Sign turn_from_edge(const Vec2& a, const Vec2& b, const Vec2& d);

}  // namespace flatray
