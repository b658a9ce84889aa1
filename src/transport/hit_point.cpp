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

// Where a tangent touches: the middle between two roots that are one.
Vec2 touched(const Ray& ray, const Ellipse& curve) {
  const auto coordinate = [&](int axis) {
    return round_once([&](const auto& number) {
      const auto d = curve_form(number, curve, pair_of(number, ray.direction));
      const auto w =
          curve_form(number, curve, pair_of(number, curve.centre) - pair_of(number, ray.origin));
      return number(ray.origin[axis]) + number(ray.direction[axis]) * (dot(w, d) / dot(d, d));
    });
  };
  return {coordinate(0), coordinate(1)};
}

// The end of an arc that a ray arrives at; of two at the same time the first.
Vec2 end_met(const Ray& ray, const Arc& arc, Root root) {
  const Vec2& centre = arc.curve.centre;
  if (root == Root::none) {
    const auto from = hit_joint(ray, arc.curve, arc.from), to = hit_joint(ray, arc.curve, arc.to);
    return from && (!to || compare(*from, *to) <= 0) ? arc.from : arc.to;
  }
  const ExactHit exact(ray, arc.curve,
                       root == Root::second ? HitTime::Root::second : HitTime::Root::first);
  if (arc.extent == Arc::Extent::half) return exact.nearest();
  const bool at_from = exact.turn(centre, centre, arc.from) == Sign::zero;
  const bool at_to = exact.turn(centre, centre, arc.to) == Sign::zero;
  if (at_from != at_to) return at_from ? arc.from : arc.to;
  // Of a half turn: the ends lie opposite, and the arc is on the left of the line from `from`.
  return exact.ahead(centre, centre, arc.from) == Sign::positive ? arc.from : arc.to;
}

HitTime::Root root_of(const NearestHit& hit) {
  return hit.root == Root::second ? HitTime::Root::second : HitTime::Root::first;
}

}  // namespace

ExactHit exact_hit(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (walls.is_straight(hit.surface)) return {ray, walls.segments[walls.slot[hit.surface]]};
  return {ray, walls.curve(hit.surface), root_of(hit)};
}

QuickHit quick_hit(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (walls.is_straight(hit.surface))
    return quick_hit(ray, walls.segments[walls.slot[hit.surface]]);
  return quick_hit(ray, walls.curve(hit.surface), root_of(hit));
}

Vec2 hit_point(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (is_zero(ray.direction)) return ray.origin;
  if (hit.at_end)
    return walls.is_straight(hit.surface) ? end_met(ray, walls.segments[walls.slot[hit.surface]])
                                          : end_met(ray, walls.arc(hit.surface), hit.root);
  if (hit.kind == HitClass::along) return ray.origin;
  if (hit.root == Root::both) return touched(ray, walls.curve(hit.surface));
  return exact_hit(walls, ray, hit).nearest();
}

}  // namespace flatray
