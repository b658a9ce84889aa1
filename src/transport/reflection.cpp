#include "transport/reflection.h"

#include <algorithm>
#include <cmath>

#include "geom/reflect.h"
#include "transport/exact_origin.h"
#include "transport/near_doubles.h"

namespace flatray {
namespace {

int exponent_of(const Vec2& v) { return std::ilogb(std::max(std::fabs(v.x()), std::fabs(v.y()))); }

// A normal of a wall as it was met: to the left of a segment, or outward of a circle.
struct Met {
  std::uint32_t surface;
  Sign side;
  Vec2 normal;
  bool may_run_along = true;  // the ray that leaves it
};

// The nearest direction to `rounded` that leads away on the side of `met`.
std::optional<Reflection> leaving(const Surfaces& walls, const Met& met, const Vec2& rounded,
                                  const Vec2& point) {
  const auto out = nearest_double(rounded, [&](const Vec2& candidate) {
    return leads_away(walls, met.surface, met.side, point, candidate) &&
           (met.may_run_along || !runs_along(walls, {met.surface, Root::none}, candidate));
  });
  if (!out) return std::nullopt;
  // Adding zero turns -0 into 0, which reads better.
  return Reflection{*out, static_cast<double>(met.side) * unit(met.normal) + Vec2(0, 0)};
}

std::optional<Reflection> reflected(const Surfaces& walls, const Met& met, const Vec2& direction,
                                    const Vec2& point, const Speed& speed) {
  return leaving(walls, met, speed.restore(reflect(direction, {met.normal.y(), -met.normal.x()})),
                 point);
}

}  // namespace

Speed::Speed(const Vec2& start)
    : exponent_(exponent_of(start)),
      scale_{std::ldexp(1, -exponent_ / 2), std::ldexp(1, -exponent_ - -exponent_ / 2)},
      square_(square(start)) {}

DoubleDouble Speed::square(const Vec2& direction) const {
  const Vec2 v = near_one(direction);
  return DoubleDoubles::sum(two_product(v.x(), v.x()), two_product(v.y(), v.y())).value;
}

Vec2 Speed::restore(const Vec2& direction) const {
  const DoubleDouble excess =
      DoubleDoubles::sum(square(direction), DoubleDoubles::negative(square_)).value;
  const double relative = excess.hi / square_.hi;  // twice that of the length
  if (std::fabs(relative) <= 0x1p-51) return direction;
  return direction - 0.5 * relative * direction;
}

double Speed::length() const { return std::ldexp(std::sqrt(square_.hi), exponent_); }

DoubleDouble plus(const DoubleDouble& sum, double more) {
  const DoubleDouble next = two_sum(sum.hi, more);
  return std::isfinite(next.hi) ? two_sum(next.hi, next.lo + sum.lo) : DoubleDouble{next.hi, 0};
}

bool leads_away(const Surfaces& walls, std::uint32_t surface, Sign side, const Vec2& point,
                const Vec2& direction) {
  return walls.visit(surface, [&](const auto& wall) {
    return leads_away(wall, side, {point, direction});
  });
}

Root root_stood_on(const Surfaces& walls, std::uint32_t surface, const Ray& ray) {
  return walls.visit(surface, [&](const auto& wall) {
    for (const Sign side : {Sign::negative, Sign::positive})
      if (leads_away(wall, side, ray)) return root_departed(wall, side);
    return Root::both;  // along a tangent
  });
}

bool runs_along(const Surfaces& walls, const DepartedSurface& departed, const Vec2& direction) {
  return walls.visit(departed.surface,
                     [&](const auto& wall) { return runs_along(wall, direction); });
}

std::optional<Reflection> reflect_off(const Surfaces& walls, const Ray& ray, const NearestHit& hit,
                                      const ExactOrigin& origin, const Speed& speed) {
  return reflected(walls, {hit.surface, inner_side(walls, ray, hit), origin.normal}, ray.direction,
                   origin.point, speed);
}

std::optional<Reflection> refract_through(const Surfaces& walls, std::uint32_t surface, Sign side,
                                          const Vec2& refracted, const ExactOrigin& beyond,
                                          const Speed& speed) {
  auto out = leaving(walls, {surface, -side, beyond.normal},
                     speed.restore(refracted * speed.length()), beyond.point);
  if (out) out->normal = -out->normal;
  return out;
}

std::optional<Reflection> reflect_in_field(const Surfaces& walls, std::uint32_t surface, Sign side,
                                           const Vec2& direction, const ExactOrigin& origin,
                                           const Speed& speed) {
  return reflected(walls, {surface, side, origin.normal, false}, direction, origin.point, speed);
}

std::optional<Reflection> reflect_again(const Surfaces& walls, const DepartedSurface& departed,
                                        const Vec2& point, const Vec2& direction,
                                        const Speed& speed) {
  return walls.visit(departed.surface, [&](const auto& wall) {
    const Sign side = -side_met(wall, {point, -direction}, departed.root);  // to which it had left
    return reflected(walls, {departed.surface, side, normal_near(wall, point)}, direction, point,
                     speed);
  });
}

double moment_about(const Vec2& centre, const Ray& ray) {
  const DoubleDouble x = two_sum(ray.origin.x(), -centre.x());
  const DoubleDouble y = two_sum(ray.origin.y(), -centre.y());
  const Vec2& d = ray.direction;
  const DoubleDouble exact =
      DoubleDoubles::sum(two_product(x.hi, d.y()), two_product(-y.hi, d.x())).value;
  return exact.hi + (exact.lo + (x.lo * d.y() - y.lo * d.x()));
}

Vec2 with_moment(const Surfaces& walls, const DepartedSurface& departed, const Vec2& point,
                 const Vec2& direction, double moment) {
  constexpr double kGrazing = 0x1p-12, kRounding = 0x1p-36;
  const Vec2 centre = walls.arc(departed.surface).curve.centre;
  const Vec2 from = point - centre;
  const double along = from.dot(direction);
  const double sizes = std::sqrt(from.dot(from)) * std::sqrt(direction.dot(direction));
  if (!(std::fabs(along) > kGrazing * sizes)) return direction;
  const double turn = (moment - moment_about(centre, {point, direction})) / along;
  if (!(std::fabs(turn) < kRounding)) return direction;
  const Vec2 turned = direction + turn * Vec2(-direction.y(), direction.x());
  const Sign side = departed.root == Root::first ? Sign::negative : Sign::positive;
  return leads_away(walls, departed.surface, side, point, turned) ? turned : direction;
}

}  // namespace flatray
