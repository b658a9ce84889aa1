#pragma once
#include <Eigen/Core>
#include <limits>

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

/// The length of a vector of any size; rounded.
inline double size_of(const Vec2& v) {
  const double most = v.cwiseAbs().maxCoeff();
  if (most > 0x1p-500 && most < 0x1p500) return v.norm();
  return most > 0 && most < std::numeric_limits<double>::infinity() ? most * (v / most).norm()
                                                                    : most;
}

/// A vector of any size brought to length 1, that of 0 as it is; rounded.
inline Vec2 unit(const Vec2& v) {
  const double most = v.cwiseAbs().maxCoeff();
  const double scale = most < 0x1p-400 ? 0x1p600 : most > 0x1p400 ? 0x1p-600 : 1;
  const Vec2 tame = scale * v;
  return most > 0 ? Vec2(tame / tame.norm()) : v;
}

}  // namespace flatray
