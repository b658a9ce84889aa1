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

/// By what power of two a vector with this largest coordinate is multiplied, so that its square is a double.
inline double taming(double most) {
  return most < 0x1p-400 ? 0x1p600 : most > 0x1p400 ? 0x1p-600 : 1;
}

/// The length of a vector of any size; rounded.
inline double size_of(const Vec2& v) {
  const double most = v.cwiseAbs().maxCoeff(), scale = taming(most);
  if (!(most > 0 && most < std::numeric_limits<double>::infinity())) return most;
  return Vec2(scale * v).norm() / scale;
}

/// A vector of any size brought to length 1, that of 0 as it is; rounded.
inline Vec2 unit(const Vec2& v) {
  const double most = v.cwiseAbs().maxCoeff();
  const Vec2 tame = taming(most) * v;
  return most > 0 ? Vec2(tame / tame.norm()) : v;
}

}  // namespace flatray
