#include "study/stability/catalogue_orbit_check.h"

#include <algorithm>

#include "base/processor_time.h"
#include "geom/predicates.h"
#include "oracle/nearest.h"
#include "precise/certified_orbit.h"
#include "study/rooms/room.h"
#include "study/stability/ulps.h"
#include "trace/many_rays.h"

namespace flatray {
namespace {

// Of certified orbits, each again from its start for every number of bits.
constexpr std::size_t kCertified = 16;
constexpr std::uint64_t kCertifiedBounces = 50;  // or as many as are in order
constexpr std::size_t kLegs = 1000;  // of which the oracle tells the t: some 30 us each on a curve

// Outside the room, or on another side of a whole curve than the start.
bool is_out(const oracle::StiffOrbits& orbits, const Vec2& start, const Vec2& point) {
  for (std::size_t i = 0; i < orbits.room; ++i) {
    const Segment& wall = orbits.walls.segments[i];
    if (orientation(wall.a, wall.b, point) == Sign::negative) return true;
  }
  return std::ranges::any_of(orbits.walls.arcs, [&](const Arc& arc) {
    if (arc.extent != Arc::Extent::whole) return false;
    const Sign before = side_of(arc, start), now = side_of(arc, point);
    return now != Sign::zero && before != Sign::zero && now != before;
  });
}

bool ends_as(OrbitEnd end, oracle::StiffOrbits::End expected) {
  using End = oracle::StiffOrbits::End;
  return expected == End::any || expected == End::open ||
         (end == OrbitEnd::limit && expected == End::limit) ||
         (end == OrbitEnd::escape && expected == End::escape) ||
         (end == OrbitEnd::corner && expected == End::corner) ||
         (end == OrbitEnd::along && expected == End::along);
}

bool escapes(const oracle::StiffOrbits& orbits, OrbitEnd end) {
  using End = oracle::StiffOrbits::End;
  return end == OrbitEnd::escape && orbits.end != End::escape && orbits.end != End::open;
}

template <class AnyOrbit>
bool walls_agree(const oracle::LongOrbit& truth, const AnyOrbit& orbit) {
  if (orbit.bounces.size() < truth.bounces.size()) return false;
  for (std::size_t i = 0; i < truth.bounces.size(); ++i)
    if (orbit.bounces[i].surface != truth.bounces[i].surface) return false;
  return true;
}

void compare(const oracle::StiffOrbits& orbits, const oracle::LongOrbit& truth, const Orbit& orbit,
             CatalogueTally& tally) {
  ++tally.queries;
  if (!ends_as(orbit.end, orbits.end) || (orbits.count && orbit.bounces.size() != *orbits.count) ||
      !walls_agree(truth, orbit))
    ++tally.wrong;
  const bool out = std::ranges::any_of(orbit.bounces, [&](const Bounce& bounce) {
    return is_out(orbits, orbit.start, bounce.point);
  });
  if (escapes(orbits, orbit.end) || out) ++tally.leaks;
}

// Whether an orbit turned round at its last bounce comes to the walls before it, the last of them
// first.
template <class Follow>
bool leads_back(const Orbit& there, const Follow& follow) {
  if (there.bounces.size() < 2) return false;
  const Bounce &last = there.bounces.back(), &before = there.bounces[there.bounces.size() - 2];
  const Orbit back = std::move(follow({Ray{last.point, -before.out}}).front());
  return back.bounces.size() + 1 >= there.bounces.size() &&
         std::equal(there.bounces.rbegin() + 1, there.bounces.rend(), back.bounces.begin(),
                    [](const Bounce& a, const Bounce& b) { return a.surface == b.surface; });
}

bool is_same(const Orbit& a, const Orbit& b) {
  const auto same = [](const Bounce& one, const Bounce& other) {
    return one.surface == other.surface && one.t == other.t && one.point == other.point &&
           one.out == other.out;
  };
  return a.end == b.end &&
         std::equal(a.bounces.begin(), a.bounces.end(), b.bounces.begin(), b.bounces.end(), same);
}

// What flies from each bounce of some orbits, and the bounce it came to.
struct Legs {
  RayBatch rays;
  std::vector<Bounce> next;
};
Legs legs_of(const Surfaces& walls, std::span<const Orbit> orbits) {
  Legs legs;
  legs.rays.tangents = false;
  for (const Orbit& orbit : orbits)
    for (std::size_t i = 1; i < orbit.bounces.size(); ++i) {
      const Bounce& from = orbit.bounces[i - 1];
      legs.rays.add({from.point, from.out}, departed_by(walls, from));
      legs.next.push_back(orbit.bounces[i]);
    }
  return legs;
}

// In one batch they must come where each came alone; t of some of them against the oracle's.
void check_legs(const Surfaces& surfaces, const Legs& legs, const Tracer& tracer,
                CatalogueTally& tally) {
  if (legs.next.empty()) return;
  const auto walls = tracer.build(surfaces);
  const RayBatch many = many_of(legs.rays);
  const std::vector<NearestHit> hits = measured_hits(*walls, many, surfaces.size(), tally);
  const std::size_t count = legs.next.size(), step = (count + kLegs - 1) / kLegs;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Bounce& next = legs.next[i % count];
    const bool same = hits[i] && hits[i].surface == next.surface && hits[i].t == next.t;
    ++tally.queries;
    if (!same) ++tally.apart;
    if (!same || i >= count || i % step != 0) continue;
    const auto t = oracle::time_of(many.ray(i), surfaces, hits[i].surface, hits[i].root);
    if (t)
      tally.ulps.push_back(ulps_between(hits[i].t, *t));
    else
      ++tally.wrong;
  }
}

}  // namespace

void check_orbits(const oracle::StiffOrbits& orbits, const std::vector<oracle::LongOrbit>& truth,
                  const Tracer& tracer, CatalogueTally& tally) {
  const std::vector<Material> mirrors(orbits.walls.size(), Material::mirror);
  const auto follow = [&](const std::vector<Ray>& starts) {
    return trace_orbits(orbits.walls, mirrors, starts, orbits.bounces, {CornerRule::stop, &tracer});
  };
  std::vector<Orbit> alone;
  for (const Ray& start : orbits.starts) alone.push_back(std::move(follow({start}).front()));
  std::vector<Ray> many = orbits.starts;
  while (many.size() <= kMostRaysOneByOne)
    many.insert(many.end(), orbits.starts.begin(), orbits.starts.end());
  const std::vector<Orbit> among = follow(many);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    compare(orbits, truth[i], alone[i], tally);
    if (!orbits.there_and_back) continue;
    ++tally.queries;
    if (!leads_back(alone[i], follow)) ++tally.wrong;
  }
  for (std::size_t i = 0; i < among.size(); ++i) {
    compare(orbits, truth[i % alone.size()], among[i], tally);
    if (!is_same(among[i], alone[i % alone.size()])) ++tally.apart;
  }
  check_legs(orbits.walls, legs_of(orbits.walls, alone), tracer, tally);
}

void check_certified_orbits(const oracle::StiffOrbits& orbits,
                            const std::vector<oracle::LongOrbit>& truth, CatalogueTally& tally) {
  const std::uint64_t bounces =
      std::max(orbits.ordered, std::min(orbits.bounces, kCertifiedBounces));
  for (std::size_t i = 0; i < std::min(orbits.starts.size(), kCertified); ++i) {
    const double begin = thread_seconds();
    const auto orbit = certified_orbit(orbits.walls, orbits.starts[i], bounces);
    tally.seconds += thread_seconds() - begin;
    tally.in_batches += orbit->bounces.size();
    ++tally.queries;
    const bool whole = bounces == orbits.bounces && orbit->decided;
    if (!walls_agree(truth[i], *orbit) || (whole && !ends_as(orbit->end, orbits.end)))
      ++tally.wrong;
    // Their points are the nearest doubles, on either side of a wall.
    if (escapes(orbits, orbit->end)) ++tally.leaks;
  }
}

}  // namespace flatray
