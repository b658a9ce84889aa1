#include "transport/exact_origin.h"

#include <algorithm>
#include <cmath>

#include "geom/decide.h"
#include "geom/pair.h"
#include "transport/near_doubles.h"

namespace flatray {
namespace {

// The exact hit is within 1 ulp of its nearest double, and the point kept within kSearchUlps of
// that: what lies beyond 4 plays no part.
constexpr int kReachUlps = 4;
static_assert(kSearchUlps + 1 < kReachUlps);

template <class Wall>
bool is_on_joints(const Wall&, const Vec2&) {
  return false;
}

template <class Wall>
bool keeps_to_cone(const Wall& wall, const Vec2& point, PlaceOn cone) {
  if (cone == PlaceOn::at_end) return true;
  const PlaceOn place = place_in_cone(wall, point);
  return place == cone || (place == PlaceOn::at_end && !is_on_joints(wall, point));
}

// Whether a segment that a ray runs along begins before a place.
bool begins_before(const Segment& wall, const Ray& ray, const Vec2& place) {
  const auto is_ahead = [&](const Vec2& from, const Vec2& to) {
    return decide([&](const auto& number) {
             return dot(pair_of(number, to) - pair_of(number, from),
                        pair_of(number, ray.direction));
           }) == Sign::positive;
  };
  return is_ahead(wall.a, place) || is_ahead(wall.b, place);
}

// Of the wall hit, on which the point may not lie.
Sign outer_side(const Surfaces& walls, const Ray& ray, const NearestHit& hit, GoesOn to) {
  const Sign inner = inner_side(walls, ray, hit);
  return to == GoesOn::back ? -inner : inner;
}

// Of walls in ascending order, each once.
void add_to(std::vector<std::uint32_t>& walls, std::uint32_t surface) {
  const auto place = std::ranges::lower_bound(walls, surface);
  if (place == walls.end() || *place != surface) walls.insert(place, surface);
}

double reach(double x) { return step_ulps(std::fabs(x), kReachUlps) - std::fabs(x); }

}  // namespace

// A wall that passes by the hit: the point must not lie on it, nor beyond it as seen from the exact
// hit, nor, where it is an arc that goes on into another wall, on the other side of its end.
struct ExactOrigins::NearWall {
  std::uint32_t surface;
  Sign side;  // of the exact hit; zero where it is on the line of a segment, beyond its ends
  bool hit;   // the exact hit lies on the wall itself
  PlaceOn cone = PlaceOn::at_end;  // in which the exact hit lies
  bool passed = false;             // it is touched there, and passed by
};

ExactOrigins::ExactOrigins(const Surfaces& walls) : walls_(walls), cells_(walls) {}

std::vector<std::uint32_t> ExactOrigins::walls_near(const Vec2& point, std::uint32_t hit) const {
  const Vec2 within(reach(point.x()), reach(point.y()));
  return cells_.near(point, [&](std::uint32_t i) {
    return i != hit &&
           walls_.visit(i, [&](const auto& wall) { return passes_near(wall, point, within); });
  });
}

template <class Exact>
ExactOrigins::NearWall ExactOrigins::near_wall(std::uint32_t surface, const Exact& hit) const {
  return walls_.visit(surface, [&](const auto& wall) -> NearWall {
    const PlaceOn place = hit.place_on(wall);
    if (place == PlaceOn::inner)
      if (const auto side = hit.touched_side(wall))  // it is passed by
        return {surface, *side, false, hit.place_in(wall), true};
    return {surface, hit.side_of(wall), place != PlaceOn::outside, hit.place_in(wall)};
  });
}

// The end of a wall need not be a double, and is not on its own wall then.
ExactOrigin ExactOrigins::at_end(const Vec2& end, std::uint32_t surface) const {
  ExactOrigin origin{end, walls_at(end)};
  add_to(origin.corner, surface);
  return origin;
}

std::vector<std::uint32_t> ExactOrigins::walls_at(const Vec2& point) const {
  return cells_.near(point, [&](std::uint32_t i) {
    return walls_.visit(i, [&](const auto& wall) { return place_on(wall, point); }) !=
           PlaceOn::outside;
  });
}

bool ExactOrigins::may_stand(const Vec2& point, std::uint32_t hit, Sign outer,
                             const std::vector<NearWall>& near) const {
  const auto on_own = [&](const auto& wall) {
    return side_of(wall, point) != outer && keeps_to_cone(wall, point, PlaceOn::inner);
  };
  return walls_.visit(hit, on_own) && std::ranges::all_of(near, [&](const NearWall& other) {
           return walls_.visit(other.surface, [&](const auto& wall) {
             return (other.side == Sign::zero || side_of(wall, point) == other.side) &&
                    place_on(wall, point) == PlaceOn::outside &&
                    keeps_to_cone(wall, point, other.cone);
           });
         });
}

std::optional<Vec2> ExactOrigins::across(const Vec2& point, std::uint32_t surface,
                                         Sign from) const {
  std::vector<NearWall> near;
  for (const std::uint32_t other : walls_near(point, surface))
    near.push_back(walls_.visit(other, [&](const auto& wall) -> NearWall {
      return {other, side_of(wall, point), false, place_in_cone(wall, point)};
    }));
  return nearest_double(point, [&](const Vec2& there) {
    return walls_.visit(surface, [&](const auto& wall) { return side_of(wall, there); }) == -from &&
           may_stand(there, surface, from, near);
  });
}

// The same point as after() finds, where doubles can tell and no other wall passes.
std::optional<ExactOrigin> ExactOrigins::quick_after(const Ray& ray, const NearestHit& hit,
                                                     const QuickHit& quick, GoesOn to) const {
  if (!quick.is_certain || !walls_near(quick.nearest, hit.surface).empty()) return std::nullopt;
  const Sign outer = outer_side(walls_, ray, hit, to);
  bool doubt = false;
  const auto point = walls_.visit(hit.surface, [&](const auto& wall) {
    return nearest_double(quick.nearest, [&](const Vec2& candidate) {
      const std::optional<Sign> side = side_by_hit(wall, quick, candidate);
      doubt = !side;
      return doubt || (*side != outer && keeps_to_cone(wall, candidate, PlaceOn::inner));
    });
  });
  if (doubt || !point) return std::nullopt;
  return ExactOrigin{*point, {}, normal_at(ray, hit, quick)};
}

Vec2 ExactOrigins::normal_at(const Ray& ray, const NearestHit& hit, const QuickHit& quick) const {
  return quick.is_normal_certain ? quick.normal : exact_hit(walls_, ray, hit).normal();
}

// Of a hit between the ends of its wall, without its normal.
template <class Exact>
ExactOrigin ExactOrigins::beside_others(const Exact& exact, std::uint32_t surface,
                                        Sign outer) const {
  const Vec2 nearest = exact.nearest();
  std::vector<NearWall> near;
  std::vector<std::uint32_t> met{surface}, passing{surface};
  for (const std::uint32_t other : walls_near(nearest, surface)) {
    near.push_back(near_wall(other, exact));
    passing.push_back(other);
    if (near.back().hit) met.push_back(other);
  }
  std::ranges::sort(met);
  if (met.size() > 1) return {nearest, std::move(met)};
  const auto point = nearest_double(
      nearest, [&](const Vec2& candidate) { return may_stand(candidate, surface, outer, near); });
  if (point) return {*point, {}};
  std::ranges::sort(passing);
  return {nearest, std::move(passing)};
}

// All walls that are met in a corner, of which the double may not tell, but none that is only touched.
template <class Exact>
ExactOrigin ExactOrigins::with_met(ExactOrigin origin, const Exact& exact,
                                   std::uint32_t surface) const {
  for (const std::uint32_t other : walls_near(exact.nearest(), surface)) {
    const NearWall near = near_wall(other, exact);
    if (near.passed) std::erase(origin.corner, other);
    if (near.hit) add_to(origin.corner, other);
  }
  return origin;
}

ExactOrigin ExactOrigins::after(const Ray& ray, const NearestHit& hit, GoesOn to) const {
  if (hit.at_end || hit.kind == HitClass::along) {
    const ExactOrigin origin = at_end(hit_point(walls_, ray, hit), hit.surface);
    const auto exact =
        walls_.visit(hit.surface, [&](const auto& wall) { return exact_end(wall, ray, hit.root); });
    return exact ? with_met(origin, *exact, hit.surface) : origin;
  }
  const QuickHit quick =
      walls_.visit(hit.surface, [&](const auto& wall) { return quick_hit(ray, wall, hit.root); });
  if (const auto origin = quick_after(ray, hit, quick, to)) return *origin;
  ExactOrigin origin =
      beside_others(exact_hit(walls_, ray, hit), hit.surface, outer_side(walls_, ray, hit, to));
  if (origin.corner.empty()) origin.normal = normal_at(ray, hit, quick);
  return origin;
}

ExactOrigin ExactOrigins::after(const FieldFlight& flight, const FieldHit& hit) const {
  const Vec2& start = flight.ray.origin;
  const FieldMeeting& met = hit.meeting;
  if (hit.at_end) {
    if (met.closes()) return at_end(start, hit.surface);
    return with_met(at_end(met.nearest(), hit.surface), met, hit.surface);
  }
  ExactOrigin origin =
      met.closes() ? ExactOrigin{start, {}} : beside_others(met, hit.surface, -met.from());
  if (origin.corner.empty())
    origin.normal = walls_.visit(hit.surface, [&](const auto& wall) {
      return met.closes() ? normal_near(wall, start) : met.normal(wall);
    });
  return origin;
}

bool is_end(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  return walls.visit(surface, [&](const auto& wall) { return place_on(wall, point); }) ==
         PlaceOn::at_end;
}

Sign inner_side(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  return walls.visit(hit.surface, [&](const auto& wall) { return side_met(wall, ray, hit.root); });
}

bool is_before(const Surfaces& walls, const Ray& ray, const NearestHit& hit, const Vec2& place) {
  const bool straight = walls.segment_slot(hit.surface) != kNoSurface;
  const double doubt = straight ? 0.5 : 0x1p-40;  // a curve may have been crossed twice
  if (!(std::fabs(hit.t - 1) < doubt)) return hit.t < 1;
  const Sign from = inner_side(walls, ray, hit);
  if (straight && from == Sign::zero) return begins_before(walls.segment(hit.surface), ray, place);
  const Sign there =
      walls.visit(hit.surface, [&](const auto& wall) { return side_of(wall, place); });
  return there == -from;
}

}  // namespace flatray
