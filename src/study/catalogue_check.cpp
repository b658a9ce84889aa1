#include "study/catalogue_check.h"

#include <algorithm>
#include <cmath>

#include "geom/predicates.h"
#include "oracle/long_orbit.h"
#include "oracle/nearest.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

constexpr unsigned kBits = 1024;

double ulps_between(double found, double truth) {
  if (found == truth) return 0;
  const double ulp = std::nextafter(std::fabs(truth), kInfinity) - std::fabs(truth);
  return std::fabs(found - truth) / ulp;
}

// The rays that follow `first` among the same walls, all at once.
std::size_t check_rays(const std::vector<oracle::StiffRay>& rays, std::size_t first,
                       const Tracer& tracer, CatalogueTally& tally) {
  const Surfaces& walls = *rays[first].walls;
  RayBatch batch;
  std::size_t end = first;
  for (; end < rays.size() && rays[end].walls == rays[first].walls; ++end) batch.add(rays[end].ray);
  std::vector<NearestHit> hits(batch.size());
  tracer.build(walls)->nearest(batch, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const oracle::StiffRay& asked = rays[first + i];
    const NearestHit& hit = hits[i];
    std::optional<double> t = asked.t;
    bool right = static_cast<bool>(hit) == t.has_value();
    if (!walls.any_curves()) {
      const oracle::NearestWall truth = oracle::nearest_wall(asked.ray, walls.segments);
      right = right && (!hit || hit.surface == truth.wall);
      if (t == kInfinity) t = truth.t;
    }
    ++tally.queries;
    if (!right)
      ++tally.wrong;
    else if (hit)
      tally.worst_ulps = std::max(tally.worst_ulps, ulps_between(hit.t, *t));
  }
  return end;
}

// Outside the room, or on another side of a circle than the start.
bool is_out(const oracle::StiffOrbits& orbits, const Vec2& start, const Vec2& point) {
  for (std::size_t i = 0; i < orbits.room; ++i) {
    const Segment& wall = orbits.walls.segments[i];
    if (orientation(wall.a, wall.b, point) == Sign::negative) return true;
  }
  return std::any_of(
      orbits.walls.circles.begin(), orbits.walls.circles.end(), [&](const Circle& circle) {
        const Sign before = curve_side(start, circle), now = curve_side(point, circle);
        return now != Sign::zero && before != Sign::zero && now != before;
      });
}

bool ends_as(OrbitEnd end, oracle::StiffOrbits::End expected) {
  using End = oracle::StiffOrbits::End;
  return expected == End::any || (end == OrbitEnd::limit && expected == End::limit) ||
         (end == OrbitEnd::escape && expected == End::escape) ||
         (end == OrbitEnd::corner && expected == End::corner);
}

bool walls_agree(const oracle::LongOrbit& truth, const Orbit& orbit) {
  if (orbit.bounces.size() < truth.bounces.size()) return false;
  for (std::size_t i = 0; i < truth.bounces.size(); ++i)
    if (orbit.bounces[i].surface != truth.bounces[i].surface) return false;
  return true;
}

void check_orbits(const oracle::StiffOrbits& orbits, const std::vector<oracle::LongOrbit>& truth,
                  const Tracer& tracer, CatalogueTally& tally) {
  using End = oracle::StiffOrbits::End;
  const std::vector<Material> mirrors(orbits.walls.size(), Material::mirror);
  const std::vector<Orbit> found = trace_orbits(orbits.walls, mirrors, orbits.starts,
                                                orbits.bounces, {CornerRule::stop, &tracer});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Orbit& orbit = found[i];
    ++tally.queries;
    if (!ends_as(orbit.end, orbits.end) ||
        (orbits.count && orbit.bounces.size() != *orbits.count) || !walls_agree(truth[i], orbit))
      ++tally.wrong;
    const bool escapes = orbit.end == OrbitEnd::escape && orbits.end != End::escape;
    const bool out = std::any_of(
        orbit.bounces.begin(), orbit.bounces.end(),
        [&](const Bounce& bounce) { return is_out(orbits, orbit.start, bounce.point); });
    if (escapes || out) ++tally.leaks;
  }
}

}  // namespace

std::vector<CatalogueTally> check_case(const oracle::StiffCase& stiff,
                                       std::span<const Tracer* const> tracers) {
  std::vector<CatalogueTally> tallies(tracers.size());
  for (std::size_t k = 0; k < tracers.size(); ++k)
    for (std::size_t i = 0; i < stiff.rays.size();)
      i = check_rays(stiff.rays, i, *tracers[k], tallies[k]);
  for (const oracle::StiffOrbits& orbits : stiff.orbits) {
    std::vector<oracle::LongOrbit> truth;
    for (const Ray& start : orbits.starts)
      truth.push_back(oracle::long_orbit(orbits.walls, start, orbits.ordered, kBits));
    for (std::size_t k = 0; k < tracers.size(); ++k)
      check_orbits(orbits, truth, *tracers[k], tallies[k]);
  }
  return tallies;
}

}  // namespace flatray
