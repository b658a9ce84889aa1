#pragma once
#include <Eigen/Core>

namespace flatray {

using Vec2 = Eigen::Vector2d;

/// z component of a x b: twice the signed area of the triangle 0, a, b. Rounded; for signs see
/// predicates.h.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether a has the lower x, or the same and the lower y. Exact.
inline bool is_before(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

inline bool is_zero(const Vec2& v) { return v.x() == 0 && v.y() == 0; }

}  // namespace flatray
