#include "transport/reflection.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "geom/decide.h"
#include "geom/reflect.h"
#include "transport/landing.h"
#include "transport/near_doubles.h"

namespace flatray {
namespace {

int exponent_of(const Vec2& v) { return std::ilogb(std::max(std::fabs(v.x()), std::fabs(v.y()))); }

Vec2 scaled(const Vec2& v, int exponent) {
  return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent)};
}

DoubleDouble add(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = two_sum(a.hi, b.hi);
  return two_sum(sum.hi, sum.lo + (a.lo + b.lo));
}

}  // namespace

Vec2 unit(const Vec2& v) {
  const Vec2 near_one = scaled(v, -exponent_of(v));
  return near_one / std::sqrt(near_one.x() * near_one.x() + near_one.y() * near_one.y());
}

Speed::Speed(const Vec2& start)
    : exponent_(exponent_of(start)),
      scale_{std::ldexp(1, -exponent_ / 2), std::ldexp(1, -exponent_ - -exponent_ / 2)},
      square_(square(start)) {}

DoubleDouble Speed::square(const Vec2& direction) const {
  const Vec2 v = near_one(direction);
  return add(two_product(v.x(), v.x()), two_product(v.y(), v.y()));
}

Vec2 Speed::restore(const Vec2& direction) const {
  const DoubleDouble excess = add(square(direction), {-square_.hi, -square_.lo});
  const double relative = excess.hi / square_.hi;  // twice that of the length
  if (std::fabs(relative) <= 0x1p-51) return direction;
  return direction - 0.5 * relative * direction;
}

double Speed::length() const { return std::ldexp(std::sqrt(square_.hi), exponent_); }

bool leads_away(const Surfaces& walls, std::uint32_t surface, Sign side, const Vec2& point,
                const Vec2& direction) {
  const std::uint32_t slot = walls.slot[surface];
  if (walls.is_straight(surface))
    return turn_from_edge(walls.segments[slot].a, walls.segments[slot].b, direction) != -side;
  const Ellipse curve = walls.curve(surface);
  return side == decide([&](const auto& number) {
           const auto from = pair_of(number, point) - pair_of(number, curve.centre);
           return dot(curve_form(number, curve, from),
                      curve_form(number, curve, pair_of(number, direction)));
         });
}

std::optional<Reflection> reflect_off(const Surfaces& walls, const Ray& ray, const NearestHit& hit,
                                      const Vec2& point, const Speed& speed) {
  const Sign side = inner_side(walls, ray, hit);
  const std::uint32_t slot = walls.slot[hit.surface];
  Vec2 left;  // normal to the wall, to the left of a segment and outward of a curve
  if (walls.is_straight(hit.surface)) {
    const Vec2 edge = walls.segments[slot].b - walls.segments[slot].a;
    left = {-edge.y(), edge.x()};
  } else {
    left = exact_hit(walls, ray, hit).normal();
  }
  const Vec2 rounded = speed.restore(reflect(ray.direction, {left.y(), -left.x()}));
  const auto direction = nearest_double(rounded, [&](const Vec2& candidate) {
    return leads_away(walls, hit.surface, side, point, candidate);
  });
  if (!direction) return std::nullopt;
  // Adding zero turns -0 into 0, which reads better.
  const Vec2 normal = static_cast<double>(side) * unit(left) + Vec2(0, 0);
  const Vec2 in = speed.near_one(ray.direction);
  const double across = std::fabs(cross(normal, in)), against = std::fabs(normal.dot(in));
  return Reflection{*direction, normal, portable::atan2(across, against)};
}

}  // namespace flatray
