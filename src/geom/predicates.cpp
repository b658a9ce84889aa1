#include "geom/predicates.h"

#include "geom/decide.h"

namespace flatray {
namespace {

// Brings all doubles below 2^464, where no product of differences overflows. What underflows by it
// is off by 2^-1075 and multiplied by at most 2^465, eight times.
constexpr double kShrink = 0x1p-560, kShrunkUnderflow = 0x1p-606;

// What the filter says of coordinates so large that their products overflow.
Sign sign_of_huge(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto shrunk = [](double x) { return Term<0>{kShrink * x}; };
  return determinant(shrunk, a, b, c, d).sure_sign(kShrunkUnderflow);
}

}  // namespace

Sign uncertain_cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  // Signs of differences are always right, so products of opposite signs need no arithmetic:
  // axis-parallel input, and a product that under- or overflowed.
  const Sign left = sign_of(b.x() - a.x()) * sign_of(d.y() - c.y());
  const Sign right = sign_of(b.y() - a.y()) * sign_of(d.x() - c.x());
  if (left != right || left == Sign::zero) return sign_of(left <=> right);
  const auto formula = [&](const auto& number) { return determinant(number, a, b, c, d); };
  if (const auto sign = formula(kBounded).sign()) return *sign;
  if (const Sign sign = sign_of_huge(a, b, c, d); sign != Sign::zero) return sign;
  if (a == c) {  // of a triangle, seen from its other corners: two may be near, the third far
    if (const Sign sign = sign_of_huge(b, d, b, a); sign != Sign::zero) return sign;
    if (const Sign sign = sign_of_huge(d, a, d, b); sign != Sign::zero) return sign;
  }
  return formula(kRational).sign();
}

Sign orientation(const Vec2& a, const Vec2& b, const Vec2& c) { return cross_sign(a, b, a, c); }

Sign cross_sign(const Vec2& a, const Vec2& b) {
  const Vec2 zero(0, 0);
  return cross_sign(zero, a, zero, b);
}

bool lie_in_one_direction(const Vec2& centre, const Vec2& a, const Vec2& b) {
  if (cross_sign(centre, a, centre, b) != Sign::zero) return false;
  const auto opposite = [&](int axis) {
    return (a[axis] > centre[axis] && b[axis] < centre[axis]) ||
           (a[axis] < centre[axis] && b[axis] > centre[axis]);
  };
  return !opposite(0) && !opposite(1);
}

Sign side_of_ray(const Ray& ray, const Vec2& p) {
  return cross_sign(Vec2(0, 0), ray.direction, ray.origin, p);
}

Sign turn_from_edge(const Vec2& a, const Vec2& b, const Vec2& d) {
  return cross_sign(a, b, Vec2(0, 0), d);
}

}  // namespace flatray
