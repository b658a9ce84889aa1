#include "transport/orbit.h"

#include <algorithm>

#include "base/check.h"
#include "geom/error_free.h"
#include "transport/landing.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

// A ray under way.
struct Flight {
  Ray ray;
  Left left;
  Speed speed;
  DoubleDouble time{0, 0};  // sum of all t
  Orbit* orbit;
};

void add(DoubleDouble& sum, double t) {
  const DoubleDouble next = two_sum(sum.hi, t);
  sum = two_sum(next.hi, next.lo + sum.lo);
}

class OrbitTracer {
 public:
  OrbitTracer(const Surfaces& walls, std::span<const Material> materials, std::uint64_t bounces)
      : walls_(walls), materials_(materials), bounces_(bounces), lander_(walls) {}

  // Whether the ray can set off.
  bool start(Flight& flight) const {
    const std::vector<std::uint32_t> stood_on = lander_.walls_at(flight.ray.origin);
    if (stood_on.size() == 1) {
      if (is_end(stood_on[0], flight.ray.origin)) return stop(flight, OrbitEnd::corner, stood_on);
      flight.left = {stood_on[0], root_stood_on(stood_on[0], flight.ray)};
      if (runs_along(flight)) return stop(flight, OrbitEnd::along, stood_on);
    } else if (!stood_on.empty()) {
      return stop(flight, OrbitEnd::corner, stood_on);
    }
    return bounces_ > 0;
  }

  // Takes the ray to its next wall; whether it goes on from there.
  bool advance(Flight& flight, const NearestHit& hit) const {
    if (!hit) {
      flight.orbit->end = OrbitEnd::escape;
      return false;
    }
    Landing landing = lander_.land(flight.ray, hit);
    add(flight.time, hit.t);
    if (landing.corner.empty()) {
      if (materials_[hit.surface] == Material::mirror) return bounce(flight, hit, landing.point);
      landing.corner = {hit.surface};
    }
    flight.ray.origin = landing.point;
    const bool absorbed = absorbs(landing.corner);
    return stop(flight, absorbed ? OrbitEnd::absorbed : OrbitEnd::corner,
                std::move(landing.corner));
  }

 private:
  bool bounce(Flight& flight, const NearestHit& hit, const Vec2& point) const {
    const auto reflection = reflect_off(walls_, flight.ray, hit, point, flight.speed);
    flight.ray.origin = point;
    if (!reflection) return stop(flight, OrbitEnd::along, {hit.surface});
    Orbit& orbit = *flight.orbit;
    orbit.bounces.push_back({hit.surface, point, hit.t,
                             (flight.time.hi + flight.time.lo) * flight.speed.length(),
                             reflection->normal, reflection->incidence});
    flight.ray.direction = reflection->direction;
    // Inside a curve the ray goes on from the root it would have entered by, outside from the
    // other.
    flight.left = {hit.surface, hit.root == Root::none     ? Root::none
                                : hit.root == Root::second ? Root::first
                                                           : Root::second};
    return orbit.bounces.size() < bounces_;
  }

  static bool stop(Flight& flight, OrbitEnd end, std::vector<std::uint32_t> surfaces) {
    flight.orbit->end = end;
    flight.orbit->end_point = flight.ray.origin;
    flight.orbit->end_surfaces = std::move(surfaces);
    return false;
  }

  bool absorbs(const std::vector<std::uint32_t>& surfaces) const {
    return std::all_of(surfaces.begin(), surfaces.end(),
                       [&](std::uint32_t i) { return materials_[i] == Material::absorb; });
  }

  bool is_end(std::uint32_t surface, const Vec2& point) const {
    if (!walls_.is_straight(surface))
      return place_on(walls_.arc(surface), point) == ArcPlace::at_end;
    const Segment& wall = walls_.segments[walls_.slot[surface]];
    return point == wall.a || point == wall.b;
  }

  // From a point on a curve a ray goes inward from the first root, or outward from the second;
  // `both` on the tangent.
  Root root_stood_on(std::uint32_t surface, const Ray& ray) const {
    if (walls_.is_straight(surface)) return Root::none;
    return leads_away(walls_, surface, Sign::negative, ray.origin, ray.direction)   ? Root::first
           : leads_away(walls_, surface, Sign::positive, ray.origin, ray.direction) ? Root::second
                                                                                    : Root::both;
  }

  bool runs_along(const Flight& flight) const {
    const std::uint32_t slot = walls_.slot[flight.left.surface];
    if (!walls_.is_straight(flight.left.surface)) return flight.left.root == Root::both;
    const Segment& wall = walls_.segments[slot];
    return turn_from_edge(wall.a, wall.b, flight.ray.direction) == Sign::zero;
  }

  const Surfaces& walls_;
  std::span<const Material> materials_;
  std::uint64_t bounces_;
  Lander lander_;
};

// Rays still under way, in the order they were given.
void trace_wavefront(const OrbitTracer& orbits, const Accelerator& walls,
                     std::vector<Flight>& flights) {
  for (Flight& flight : flights) flight.orbit->out = unit(flight.ray.direction);
  std::erase_if(flights, [&](Flight& flight) { return !orbits.start(flight); });
  RayBatch rays;
  rays.tangents = false;
  std::vector<NearestHit> hits;
  while (!flights.empty()) {
    rays.resize(flights.size());
    hits.resize(flights.size());
    for (std::size_t i = 0; i < flights.size(); ++i) rays.set(i, flights[i].ray, flights[i].left);
    walls.nearest(rays, hits);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < flights.size(); ++i)
      if (orbits.advance(flights[i], hits[i]))
        std::swap(flights[kept++], flights[i]);
      else
        flights[i].orbit->out = unit(flights[i].ray.direction);
    flights.resize(kept, flights.front());
  }
}

}  // namespace

const char* name(OrbitEnd end) {
  switch (end) {
    case OrbitEnd::limit:
      return "limit";
    case OrbitEnd::escape:
      return "escape";
    case OrbitEnd::absorbed:
      return "absorbed";
    case OrbitEnd::corner:
      return "corner";
    case OrbitEnd::along:
      return "along";
  }
  unreachable();
}

std::vector<Orbit> trace_orbits(const Surfaces& walls, std::span<const Material> materials,
                                std::span<const Ray> starts, std::uint64_t bounces) {
  std::vector<Orbit> orbits(starts.size());
  std::vector<Flight> flights;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    orbits[i].start = starts[i].origin;
    orbits[i].direction = starts[i].direction;
    flights.push_back({starts[i], {}, Speed(starts[i].direction), {0, 0}, &orbits[i]});
  }
  trace_wavefront(OrbitTracer(walls, materials, bounces), *accelerate(walls), flights);
  return orbits;
}

Orbit trace_orbit(const Surfaces& walls, std::span<const Material> materials, const Ray& start,
                  std::uint64_t bounces) {
  return std::move(trace_orbits(walls, materials, std::span(&start, 1), bounces).front());
}

}  // namespace flatray
