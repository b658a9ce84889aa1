#pragma once
#include <optional>

#include "geom/error_free.h"
#include "geom/predicates.h"
#include "trace/hits.h"
#include "trace/surfaces.h"
#include "transport/exact_origin.h"

namespace flatray {

/// Length of a direction, kept over any number of reflections.
class Speed {
 public:
  explicit Speed(const Vec2& start);

  /// `direction` with its length brought back where it is more than 1 ulp off; else untouched.
  Vec2 restore(const Vec2& direction) const;
  /// `direction` times the power of two that brings its larger component to [1, 2), or near it
  /// after reflections.
  Vec2 near_one(const Vec2& direction) const { return direction * scale_[0] * scale_[1]; }
  /// |start|
  double length() const;

 private:
  DoubleDouble square(const Vec2& direction) const;

  int exponent_;         // of the larger component
  double scale_[2];      // 2^-exponent, in two steps because it may be beyond the doubles
  DoubleDouble square_;  // of the start, near one
};

/// A sum and one more number, in double-doubles; infinity where it overflows.
DoubleDouble plus(const DoubleDouble& sum, double more);

/// What a mirror does to a ray, or glass.
struct Reflection {
  Vec2 direction, normal;
};

/// Whether `direction` leads from `point` away from a wall, on the side given: left (positive) of a
/// segment, where along it will do too, or strictly outward (positive) or inward of a curve.
/// Exact.
bool leads_away(const Surfaces& walls, std::uint32_t surface, Sign side, const Vec2& point,
                const Vec2& direction);

/// What a ray that sets off from a point of a wall has left: on a curve inward from a root by which rays
/// enter, or outward from one by which they leave; along its tangent from both, as one that has touched it. Exact.
Root root_stood_on(const Surfaces& walls, std::uint32_t surface, const Ray& ray);
/// What a reflected ray has left: inside a curve the root it would have entered by, outside the other.
inline Root root_departed_by(Root met) {
  return met == Root::none                  ? Root::none
         : enters(met) || met == Root::both ? Root::second
                                            : Root::first;
}
/// Whether a direction runs along the straight wall just left. Exact.
bool runs_along(const Surfaces& walls, const DepartedSurface& departed, const Vec2& direction);

/// (origin - centre) x direction: r times the speed times the sine of the incidence at a circle,
/// which its reflections keep. Error   1 ulp of its terms' squares.
double moment_about(const Vec2& centre, const Ray& ray);

/// `direction`, reflected at `point` of a circle, turned by as little as gives it `moment` again, so
/// that rounding does not add up from bounce to bounce. Untouched where the ray grazes (under 2^-12
/// of a right angle), where more than rounding would be turned, or where it would no longer lead
/// away.
Vec2 with_moment(const Surfaces& walls, const DepartedSurface& departed, const Vec2& point,
                 const Vec2& direction, double moment);

/// Reflects `ray` where it meets the wall of `hit` and may stand.
///
/// Gives   a direction that does not lead back through the wall: exactly decided, moved by at most
///         kSearchUlps in each component where rounding had turned it; nullopt where that is not
///         enough (then the ray runs along the wall).
/// Error   2 ulp a component (geom/reflect.h) and 1 for the rounding of the wall's own direction.
std::optional<Reflection> reflect_off(const Surfaces& walls, const Ray& ray, const NearestHit& hit,
                                      const ExactOrigin& origin, const Speed& speed);
/// The same of a ray that comes from a side and goes on through the wall, `refracted` to a direction of length 1:
/// on from there it leads away from the wall on its other side. Its normal is towards the side it comes from.
std::optional<Reflection> refract_through(const Surfaces& walls, std::uint32_t surface, Sign side,
                                          const Vec2& refracted, const ExactOrigin& beyond,
                                          const Speed& speed);
/// The same of a ray of `direction` that comes to a wall from a side in a field, which could bend it back into
/// a straight wall that it ran along: it does not.
std::optional<Reflection> reflect_in_field(const Surfaces& walls, std::uint32_t surface, Sign side,
                                           const Vec2& direction, const ExactOrigin& origin,
                                           const Speed& speed);
/// The same of a ray that comes back along `direction` to a wall it has left at `point`.
std::optional<Reflection> reflect_again(const Surfaces& walls, const DepartedSurface& departed,
                                        const Vec2& point, const Vec2& direction,
                                        const Speed& speed);

}  // namespace flatray
