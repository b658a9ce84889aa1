#pragma once
#include <cmath>

#include "geom/vec.h"

namespace flatray {

/// By Lambert's law in two dimensions, for which the sine of the angle to the normal is uniform.
///
/// Needs   a normal and a direction along the wall of length 1; `u` in [0, 1).
inline Vec2 lambert_direction(const Vec2& normal, const Vec2& along, double u) {
  const double sine = 2 * u - 1, cosine = std::sqrt((1 - sine) * (1 + sine));
  return cosine * normal + sine * along;
}
inline Vec2 lambert_direction(const Vec2& normal, double u) {
  return lambert_direction(normal, {-normal.y(), normal.x()}, u);
}

}  // namespace flatray
