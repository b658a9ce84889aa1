#include "transport/hit_point.h"

#include "geom/clip_range.h"
#include "geom/decide.h"

namespace flatray {
namespace {

// The end of a segment that a ray arrives at. A ray along the segment meets the first one ahead.
Vec2 end_met(const Ray& ray, const Segment& wall) {
  if (side_of_ray(ray, wall.a) != Sign::zero) return wall.b;
  if (side_of_ray(ray, wall.b) != Sign::zero) return wall.a;
  const int axis = ray.direction.x() != 0 ? 0 : 1;
  const auto before = [&](const Vec2& p, const Vec2& q) {
    return ray.direction[axis] > 0 ? p[axis] < q[axis] : q[axis] < p[axis];
  };
  const auto [first, second] =
      before(wall.b, wall.a) ? std::pair(wall.b, wall.a) : std::pair(wall.a, wall.b);
  return before(first, ray.origin) ? second : first;
}

// The foot of the perpendicular from the centre, where a tangent touches.
Vec2 foot(const Ray& ray, const Circle& circle) {
  const auto coordinate = [&](int axis) {
    return round_once([&](auto number) {
      const auto dx = number(ray.direction.x()), dy = number(ray.direction.y());
      const auto wx = number(circle.centre.x()) - number(ray.origin.x());
      const auto wy = number(circle.centre.y()) - number(ray.origin.y());
      return number(ray.origin[axis]) +
             number(ray.direction[axis]) * ((wx * dx + wy * dy) / (dx * dx + dy * dy));
    });
  };
  return {coordinate(0), coordinate(1)};
}

}  // namespace

ExactHit exact_hit(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  const std::uint32_t slot = walls.slot[hit.surface];
  return walls.kinds[hit.surface] == SurfaceKind::segment
             ? ExactHit(ray, walls.segments[slot])
             : ExactHit(ray, walls.circles[slot], hit.root);
}

Vec2 hit_point(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (is_zero(ray.direction)) return ray.origin;
  const std::uint32_t slot = walls.slot[hit.surface];
  if (hit.at_end) return end_met(ray, walls.segments[slot]);
  if (hit.kind == HitClass::along) return ray.origin;
  if (hit.root == Root::both) return foot(ray, walls.circles[slot]);
  return exact_hit(walls, ray, hit).nearest();
}

}  // namespace flatray
