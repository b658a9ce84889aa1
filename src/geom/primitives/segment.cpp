#include <algorithm>

#include "geom/decide.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

// The ray lies on the line of the segment: it meets the first end ahead, or is between both.
void meet_along(const Segment& wall, const Ray& ray, std::vector<WallMeeting>& met) {
  const HitTime a = HitTime::abreast(ray, wall.a), b = HitTime::abreast(ray, wall.b);
  const auto [near, far] = compare(a, b) <= 0 ? std::pair(a, b) : std::pair(b, a);
  if (far.sign() == Sign::negative) return;
  const bool ends_here = far.sign() == Sign::zero;
  const bool at_end = ends_here || near.sign() != Sign::negative;
  const HitClass kind = ends_here || compare(near, far) == 0 ? HitClass::touch : HitClass::along;
  met.push_back(
      {at_end && !ends_here ? near : HitTime::abreast(ray, ray.origin), kind, Root::none, at_end});
}

}  // namespace

Bounds bounds_of(const Segment& wall) { return {wall.a.cwiseMin(wall.b), wall.a.cwiseMax(wall.b)}; }

PlaceOn place_on(const Segment& wall, const Vec2& point) {
  if (point == wall.a || point == wall.b) return PlaceOn::at_end;
  return bounds_of(wall).contains(point) && side_of(wall, point) == Sign::zero ? PlaceOn::inner
                                                                               : PlaceOn::outside;
}

bool line_passes_far(const Segment& wall, const Vec2& point, const Vec2& reach) {
  const auto from = within(point, reach) - pair_of(kNear, wall.a);
  return cross(pair_of(kNear, wall.b) - pair_of(kNear, wall.a), from).sign().has_value();
}

bool passes_near(const Segment& wall, const Vec2& point, const Vec2& reach) {
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax(wall.a[axis], wall.b[axis]);
    if (high < point[axis] - reach[axis] || low > point[axis] + reach[axis]) return false;
  }
  return !line_passes_far(wall, point, reach);
}

void meet(const Segment& wall, const Ray& ray, const MeetingRules&, std::vector<WallMeeting>& met) {
  if (const auto hit = hit_segment(ray, wall))
    met.push_back({hit->t, HitClass::touch, Root::none, hit->part != SegmentHit::Part::inner});
  else if (side_of_ray(ray, wall.a) == Sign::zero && side_of_ray(ray, wall.b) == Sign::zero)
    meet_along(wall, ray, met);
}

bool is_crossed(const Segment& wall, const Ray& ray) {
  return turn_from_edge(wall.a, wall.b, ray.direction) != Sign::zero;
}

Vec2 end_met(const Segment& wall, const Ray& ray, Root) {
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

Sign side_met(const Segment& wall, const Ray& ray, Root) {
  return -turn_from_edge(wall.a, wall.b, ray.direction);
}

bool leads_away(const Segment& wall, Sign side, const Ray& ray) {
  return turn_from_edge(wall.a, wall.b, ray.direction) != -side;
}

bool runs_along(const Segment& wall, const Vec2& direction) {
  return turn_from_edge(wall.a, wall.b, direction) == Sign::zero;
}

bool lies_along(const Segment& one, const Segment& other) {
  return side_of(other, one.a) == Sign::zero && side_of(other, one.b) == Sign::zero;
}

bool overlap(const Segment& one, const Segment& other) {
  if (!lies_along(one, other)) return false;
  const Vec2 size = (one.b - one.a).cwiseAbs();
  const int axis = size.x() >= size.y() ? 0 : 1;
  const auto [from, to] = std::minmax(one.a[axis], one.b[axis]);
  const auto [other_from, other_to] = std::minmax(other.a[axis], other.b[axis]);
  return std::max(from, other_from) < std::min(to, other_to);
}

// Each edge with its lower end and without its upper.
bool crosses_to_right(const Segment& wall, const Vec2& point) {
  if ((wall.a.y() > point.y()) == (wall.b.y() > point.y())) return false;
  return side_of(wall, point) == (wall.b.y() > wall.a.y() ? Sign::positive : Sign::negative);
}

}  // namespace flatray
