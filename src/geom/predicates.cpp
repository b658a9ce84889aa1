#include "geom/predicates.h"

#include <optional>

#include "geom/decide.h"

namespace flatray {
namespace {

// Brings all doubles below 2^464, where no product of differences overflows. What underflows by it
// is off by 2^-1075 and multiplied by at most 2^465, eight times: under u^2 of kShrunkLeast.
constexpr double kShrink = 0x1p-560, kShrunkLeast = 0x1p-500;

// What the filter says of coordinates so large that their products overflow.
std::optional<Sign> sign_of_huge(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto step = [](double from, double to) { return kShrink * to - kShrink * from; };
  const double left = step(a.x(), b.x()) * step(c.y(), d.y());
  const double right = step(a.y(), b.y()) * step(c.x(), d.x());
  const double size = std::fabs(left) + std::fabs(right), difference = left - right;
  if (!(size >= kShrunkLeast && std::fabs(difference) > kDetFilter * size)) return std::nullopt;
  return sign_of(difference);
}

// Where no difference is rounded and no product loses its tail: that of points of few digits, and
// the one way to tell a zero without more of them. Rounding keeps order, so that tails are asked only
// where the products round to one double.
std::optional<Sign> sign_of_few_digits(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const DoubleDouble x = two_sum(b.x(), -a.x()), y = two_sum(b.y(), -a.y());
  const DoubleDouble u = two_sum(d.x(), -c.x()), v = two_sum(d.y(), -c.y());
  const bool given = x.lo == 0 && y.lo == 0 && u.lo == 0 && v.lo == 0;
  if (!given || !is_exact_product(x.hi, v.hi) || !is_exact_product(y.hi, u.hi)) return std::nullopt;
  const DoubleDouble left = two_product(x.hi, v.hi), right = two_product(y.hi, u.hi);
  return sign_of(left.hi != right.hi ? left.hi - right.hi : left.lo - right.lo);
}

}  // namespace

Sign uncertain_cross_sign(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  // Signs of differences are always right, so products of opposite signs need no arithmetic:
  // axis-parallel input, and a product that under- or overflowed.
  const Sign left = sign_of(b.x() - a.x()) * sign_of(d.y() - c.y());
  const Sign right = sign_of(b.y() - a.y()) * sign_of(d.x() - c.x());
  if (left != right || left == Sign::zero) return sign_of(left <=> right);
  if (const std::optional<Sign> sign = sign_of_few_digits(a, b, c, d)) return *sign;
  if (const std::optional<Sign> sign = sign_of_huge(a, b, c, d)) return *sign;
  if (a == c) {  // of a triangle, seen from its other corners: two may be near, the third far
    if (const std::optional<Sign> sign = sign_of_huge(b, d, b, a)) return *sign;
    if (const std::optional<Sign> sign = sign_of_huge(d, a, d, b)) return *sign;
  }
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
