#include "transport/hit_point.h"

#include "geom/clip_range.h"

namespace flatray {

ExactHit exact_hit(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  return walls.visit(hit.surface, [&](const auto& wall) { return ExactHit(ray, wall, hit.root); });
}

Vec2 hit_point(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (is_zero(ray.direction)) return ray.origin;
  if (hit.kind == HitClass::along && !hit.at_end) return ray.origin;
  return walls.visit(hit.surface, [&](const auto& wall) {
    return hit.at_end ? end_met(wall, ray, hit.root) : point_met(wall, ray, hit.root);
  });
}

}  // namespace flatray
