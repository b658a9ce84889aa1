#include "geom/predicates.h"

#include "geom/decide.h"

namespace flatray {
Sign uncertain_cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  // Signs of differences are always right, so products of opposite signs need no arithmetic:
  // axis-parallel input, and a product that under- or overflowed.
  const Sign left = sign_of(b.x() - a.x()) * sign_of(d.y() - c.y());
  const Sign right = sign_of(b.y() - a.y()) * sign_of(d.x() - c.x());
  if (left != right || left == Sign::zero) return sign_of(left <=> right);
  return decide([&](const auto& number) { return determinant(number, a, b, c, d); });
}

Sign orientation(const Vec2& a, const Vec2& b, const Vec2& c) { return cross_sign(a, b, a, c); }

Sign cross_sign(const Vec2& a, const Vec2& b) {
  const Vec2 zero(0, 0);
  return cross_sign(zero, a, zero, b);
}

Sign side_of_ray(const Ray& ray, const Vec2& p) {
  return cross_sign(Vec2(0, 0), ray.direction, ray.origin, p);
}

Sign turn_from_edge(const Vec2& a, const Vec2& b, const Vec2& d) {
  return cross_sign(a, b, Vec2(0, 0), d);
}

}  // namespace flatray
