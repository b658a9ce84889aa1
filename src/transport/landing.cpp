#include "transport/landing.h"

#include <algorithm>
#include <cmath>

#include "geom/error_bounds.h"
#include "trace/on_surface.h"
#include "transport/near_doubles.h"

namespace flatray {
namespace {

// The exact hit is within 1 ulp of its nearest double, and the point kept within kSearchUlps of
// that: what lies beyond 4 plays no part.
constexpr int kReachUlps = 4;
static_assert(kSearchUlps + 1 < kReachUlps);

double reach(double x) { return step_ulps(std::fabs(x), kReachUlps) - std::fabs(x); }

// Whether the line of a segment surely passes outside the box of half sides `reach` about `point`.
// The determinant changes by |e_x| reach_y + |e_y| reach_x in the box; its own error is
// kDetFilter's, doubled for the rest.
bool line_passes_far(const Segment& wall, const Vec2& point, const Vec2& reach) {
  const Vec2 edge = wall.b - wall.a, from = point - wall.a;
  const double left = edge.x() * from.y(), right = edge.y() * from.x();
  const double change = std::fabs(edge.x()) * reach.y() + std::fabs(edge.y()) * reach.x();
  const double bound = 2 * kDetFilter * (std::fabs(left) + std::fabs(right)) + 2 * change;
  return std::fabs(left - right) > bound + kDetFilterLeast;
}

// The same for a circle: |w|^2 - r^2 changes by 2 (|w_x| reach_x + |w_y| reach_y) and the squares
// of the reach.
bool circle_passes_far(const Circle& wall, const Vec2& point, const Vec2& reach) {
  const Vec2 w = point - wall.centre;
  const double size = w.squaredNorm(), square = wall.radius * wall.radius;
  const double change = std::fabs(w.x()) * reach.x() + std::fabs(w.y()) * reach.y();
  const double bound = 4 * (change + reach.squaredNorm()) + 8 * kDetFilter * (size + square);
  return std::fabs(size - square) > bound + kDetFilterLeast;
}

}  // namespace

// A wall that passes by the hit: the point must not lie on it, nor beyond it as seen from the exact
// hit.
struct Lander::Fence {
  std::uint32_t surface;
  Sign side;  // of the exact hit; zero where it is on the line of a segment, beyond its ends
  bool hit;   // the exact hit lies on the wall itself
};

Lander::Lander(const Surfaces& walls) : walls_(walls) {}

bool Lander::passes_near(std::uint32_t surface, const Vec2& point, const Vec2& within) const {
  if (walls_.kinds[surface] == SurfaceKind::circle)
    return !circle_passes_far(walls_.circles[walls_.slot[surface]], point, within);
  const Segment& wall = walls_.segments[walls_.slot[surface]];
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax(wall.a[axis], wall.b[axis]);
    if (high < point[axis] - within[axis] || low > point[axis] + within[axis]) return false;
  }
  return !line_passes_far(wall, point, within);
}

std::vector<std::uint32_t> Lander::walls_near(const Vec2& point, std::uint32_t hit) const {
  const Vec2 within(reach(point.x()), reach(point.y()));
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < walls_.size(); ++i)
    if (i != hit && passes_near(i, point, within)) near.push_back(i);
  return near;
}

Lander::Fence Lander::fence(std::uint32_t surface, const ExactHit& hit) const {
  const std::uint32_t slot = walls_.slot[surface];
  if (walls_.kinds[surface] == SurfaceKind::circle) {
    const Sign side = hit.side_of(walls_.circles[slot]);
    return {surface, side, side == Sign::zero};
  }
  return {surface, hit.side_of(walls_.segments[slot]), hit.on(walls_.segments[slot])};
}

Sign Lander::side(std::uint32_t surface, const Vec2& point) const {
  const std::uint32_t slot = walls_.slot[surface];
  if (walls_.kinds[surface] == SurfaceKind::circle) return circle_side(point, walls_.circles[slot]);
  return orientation(walls_.segments[slot].a, walls_.segments[slot].b, point);
}

bool Lander::stands_on(std::uint32_t surface, const Vec2& point) const {
  if (walls_.kinds[surface] == SurfaceKind::circle) return side(surface, point) == Sign::zero;
  return lies_on(point, walls_.segments[walls_.slot[surface]]);
}

Landing Lander::land_at(const Vec2& exact) const { return {exact, walls_at(exact)}; }

std::vector<std::uint32_t> Lander::walls_at(const Vec2& point) const {
  std::vector<std::uint32_t> met;
  for (std::uint32_t i = 0; i < walls_.size(); ++i)
    if (stands_on(i, point)) met.push_back(i);
  return met;
}

bool Lander::may_stand(const Vec2& point, std::uint32_t hit, Sign outer,
                       const std::vector<Fence>& fences) const {
  return side(hit, point) != outer &&
         std::all_of(fences.begin(), fences.end(), [&](const Fence& other) {
           return (other.side == Sign::zero || side(other.surface, point) == other.side) &&
                  !stands_on(other.surface, point);
         });
}

Landing Lander::land(const Ray& ray, const NearestHit& hit) const {
  if (hit.at_end || hit.kind == HitClass::along) return land_at(hit_point(walls_, ray, hit));
  const ExactHit exact = exact_hit(walls_, ray, hit);
  const Vec2 nearest = exact.nearest();
  std::vector<Fence> fences;
  std::vector<std::uint32_t> met{hit.surface}, passing{hit.surface};
  for (const std::uint32_t surface : walls_near(nearest, hit.surface)) {
    fences.push_back(fence(surface, exact));
    passing.push_back(surface);
    if (fences.back().hit) met.push_back(surface);
  }
  std::sort(met.begin(), met.end());
  if (met.size() > 1) return {nearest, std::move(met)};
  const Sign outer = -inner_side(walls_, ray, hit);
  const auto point = nearest_double(nearest, [&](const Vec2& candidate) {
    return may_stand(candidate, hit.surface, outer, fences);
  });
  if (point) return {*point, {}};
  std::sort(passing.begin(), passing.end());
  return {nearest, std::move(passing)};
}

Sign inner_side(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (walls.kinds[hit.surface] == SurfaceKind::circle)
    return hit.root == Root::first ? Sign::positive : Sign::negative;
  const Segment& wall = walls.segments[walls.slot[hit.surface]];
  return -turn_from_edge(wall.a, wall.b, ray.direction);
}

}  // namespace flatray
