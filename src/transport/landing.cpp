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

// The same for a curve, by w = point - centre in the form in which it is a circle of radius r:
// |w|^2 - r^2 changes by 2 (|w_x| reach_x + |w_y| reach_y) and the squares of the reach. What w and r
// are off by there is under kDetFilter of the terms, which `slack` counts as reach.
bool curve_passes_far(const Ellipse& wall, const Vec2& point, const Vec2& reach) {
  const auto plain = [](double x) { return x; };
  const Vec2 from = point - wall.centre;
  const auto w = curve_form(plain, wall, Pair<double>{from.x(), from.y()});
  Vec2 within = reach;
  double slack = 0;
  if (!wall.is_circle()) {
    const Vec2 u = wall.u.cwiseAbs(), v = wall.v.cwiseAbs(), far = from.cwiseAbs();
    const Vec2 terms(far.x() * v.y() + far.y() * v.x(), u.x() * far.y() + u.y() * far.x());
    within = Vec2(reach.x() * v.y() + reach.y() * v.x(), u.x() * reach.y() + u.y() * reach.x()) +
             2 * kDetFilter * terms;
    slack = 2 * kDetFilter * (u.x() * v.y() + u.y() * v.x());
  }
  const double r = std::fabs(form_size(plain, wall));
  const double size = dot(w, w), square = r * r;
  const double change = std::fabs(w.x) * within.x() + std::fabs(w.y) * within.y() + r * slack;
  const double bound =
      4 * (change + within.squaredNorm() + slack * slack) + 8 * kDetFilter * (size + square);
  return std::fabs(size - square) > bound + kDetFilterLeast;
}

// Whether an arc surely ends before it comes into the box: on the outer side of one end's line and
// far from it, where the arc is less than a half turn.
bool ends_before(const Arc& arc, const Vec2& point, const Vec2& reach) {
  const Vec2& centre = arc.curve.centre;
  if (arc.extent == Arc::Extent::whole) return false;
  if (arc.extent == Arc::Extent::half)
    return line_passes_far({Vec2(0, 0), Vec2(arc.from.y(), -arc.from.x())}, point - centre,
                           reach) &&
           arc.from.dot(point - centre) < 0;
  if (orientation(centre, arc.from, arc.to) == Sign::negative) return false;
  const Segment from{centre, arc.from}, to{arc.to, centre};
  for (const Segment& end : {from, to})
    if (line_passes_far(end, point, reach) && orientation(end.a, end.b, point) == Sign::negative)
      return true;
  return false;
}

}  // namespace

// A wall that passes by the hit: the point must not lie on it, nor beyond it as seen from the exact
// hit, nor, where it is an arc that goes on into another wall, on the other side of its end.
struct Lander::Fence {
  std::uint32_t surface;
  Sign side;  // of the exact hit; zero where it is on the line of a segment, beyond its ends
  bool hit;   // the exact hit lies on the wall itself
  ArcPlace cone = ArcPlace::at_end;  // in which the exact hit lies
};

Lander::Lander(const Surfaces& walls) : walls_(walls), cells_(walls) {}

bool Lander::passes_near(std::uint32_t surface, const Vec2& point, const Vec2& within) const {
  if (!walls_.is_straight(surface)) {
    const Arc arc = walls_.arc(surface);
    return !curve_passes_far(arc.curve, point, within) && !ends_before(arc, point, within);
  }
  const Segment& wall = walls_.segments[walls_.slot[surface]];
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax(wall.a[axis], wall.b[axis]);
    if (high < point[axis] - within[axis] || low > point[axis] + within[axis]) return false;
  }
  return !line_passes_far(wall, point, within);
}

std::vector<std::uint32_t> Lander::walls_near(const Vec2& point, std::uint32_t hit) const {
  const Vec2 within(reach(point.x()), reach(point.y()));
  return cells_.near(point, within,
                     [&](std::uint32_t i) { return i != hit && passes_near(i, point, within); });
}

Lander::Fence Lander::fence(std::uint32_t surface, const ExactHit& hit) const {
  const std::uint32_t slot = walls_.slot[surface];
  if (walls_.is_straight(surface))
    return {surface, hit.side_of(walls_.segments[slot]), hit.on(walls_.segments[slot])};
  const Arc arc = walls_.arc(surface);
  return {surface, hit.side_of(arc.curve), hit.place_on(arc) != ArcPlace::outside,
          hit.place_in(arc)};
}

Sign Lander::side(std::uint32_t surface, const Vec2& point) const {
  const std::uint32_t slot = walls_.slot[surface];
  if (!walls_.is_straight(surface)) return curve_side(point, walls_.curve(surface));
  return orientation(walls_.segments[slot].a, walls_.segments[slot].b, point);
}

bool Lander::stands_on(std::uint32_t surface, const Vec2& point) const {
  if (!walls_.is_straight(surface))
    return place_on(walls_.arc(surface), point) != ArcPlace::outside;
  return lies_on(point, walls_.segments[walls_.slot[surface]]);
}

// The end of a wall need not be a double, and is not on its own wall then.
Landing Lander::land_at(const Vec2& end, std::uint32_t surface) const {
  Landing landing{end, walls_at(end)};
  std::vector<std::uint32_t>& corner = landing.corner;
  const auto place = std::lower_bound(corner.begin(), corner.end(), surface);
  if (place == corner.end() || *place != surface) corner.insert(place, surface);
  return landing;
}

std::vector<std::uint32_t> Lander::walls_at(const Vec2& point) const {
  return cells_.near(point, Vec2(0, 0), [&](std::uint32_t i) { return stands_on(i, point); });
}

bool Lander::keeps_to_cone(std::uint32_t surface, const Vec2& point, ArcPlace cone) const {
  if (walls_.kinds[surface] != SurfaceKind::arc || cone == ArcPlace::at_end) return true;
  const ArcPlace place = place_in_cone(walls_.arc(surface), point);
  return place == ArcPlace::at_end || place == cone;
}

bool Lander::may_stand(const Vec2& point, std::uint32_t hit, Sign outer,
                       const std::vector<Fence>& fences) const {
  return side(hit, point) != outer && keeps_to_cone(hit, point, ArcPlace::inner) &&
         std::all_of(fences.begin(), fences.end(), [&](const Fence& other) {
           return (other.side == Sign::zero || side(other.surface, point) == other.side) &&
                  !stands_on(other.surface, point) &&
                  keeps_to_cone(other.surface, point, other.cone);
         });
}

// The same point as land() finds, where doubles can tell and no other wall passes.
std::optional<Landing> Lander::land_quickly(const Ray& ray, const NearestHit& hit,
                                            const QuickHit& quick) const {
  if (!quick.is_certain || !walls_near(quick.nearest, hit.surface).empty()) return std::nullopt;
  const Sign outer = -inner_side(walls_, ray, hit);
  bool doubt = false;
  const auto point = nearest_double(quick.nearest, [&](const Vec2& candidate) {
    const std::optional<Sign> side = quick.side(candidate);
    doubt = !side;
    return doubt || (*side != outer && keeps_to_cone(hit.surface, candidate, ArcPlace::inner));
  });
  if (doubt || !point) return std::nullopt;
  return Landing{*point, {}, normal_at(ray, hit, quick)};
}

Vec2 Lander::normal_at(const Ray& ray, const NearestHit& hit, const QuickHit& quick) const {
  if (!walls_.is_straight(hit.surface))
    return quick.is_normal_certain ? quick.normal : exact_hit(walls_, ray, hit).normal();
  const Segment& wall = walls_.segments[walls_.slot[hit.surface]];
  const Vec2 edge = wall.b - wall.a;
  return {-edge.y(), edge.x()};
}

Landing Lander::land(const Ray& ray, const NearestHit& hit) const {
  if (hit.at_end || hit.kind == HitClass::along)
    return land_at(hit_point(walls_, ray, hit), hit.surface);
  const QuickHit quick = quick_hit(walls_, ray, hit);
  if (const auto landing = land_quickly(ray, hit, quick)) return *landing;
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
  if (point) return {*point, {}, normal_at(ray, hit, quick)};
  std::sort(passing.begin(), passing.end());
  return {nearest, std::move(passing)};
}

bool is_end(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  if (!walls.is_straight(surface)) return place_on(walls.arc(surface), point) == ArcPlace::at_end;
  const Segment& wall = walls.segments[walls.slot[surface]];
  return point == wall.a || point == wall.b;
}

Sign inner_side(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  if (!walls.is_straight(hit.surface))
    return hit.root == Root::first ? Sign::positive : Sign::negative;
  const Segment& wall = walls.segments[walls.slot[hit.surface]];
  return -turn_from_edge(wall.a, wall.b, ray.direction);
}

}  // namespace flatray
