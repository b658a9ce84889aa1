#include "study/stability/catalogue_check.h"

#include <algorithm>

#include "base/processor_time.h"
#include "oracle/nearest.h"
#include "precise/certified_orbit.h"
#include "study/accuracy/timed.h"
#include "study/stability/catalogue_orbit_check.h"
#include "study/stability/ulps.h"
#include "trace/many_rays.h"

namespace flatray {
namespace {

constexpr unsigned kBits = 1024;
constexpr std::size_t kFewRays = 4;   // so few go one by one whatever the walls
constexpr std::size_t kShare = 1000;  // of which one answer may be farther off

// Rays among the same walls, and what is true of them.
struct RayGroup {
  const Surfaces* walls;
  RayBatch rays;
  std::vector<std::optional<std::uint32_t>> wall{};  // of a miss none
  std::vector<std::optional<double>> t{};
};

// The rays that follow `first` among the same walls, all at once.
RayGroup group_of(std::span<const oracle::StiffRay> rays) {
  RayGroup group{rays.front().walls.get(), {}};
  oracle::NearestWalls walls(*group.walls);
  for (const oracle::StiffRay& asked : rays) {
    if (asked.walls.get() != group.walls) break;
    group.rays.add(asked.ray);
    group.wall.emplace_back();
    group.t.push_back(asked.t);
    const oracle::NearestWall truth = walls.of(asked.ray);
    if (truth) group.wall.back() = static_cast<std::uint32_t>(truth.wall);
    if (asked.t == kInfinity) group.t.back() = truth.t;
  }
  return group;
}

std::vector<oracle::LongOrbit> truth_of(const oracle::StiffOrbits& orbits) {
  std::vector<oracle::LongOrbit> truth;
  for (const Ray& start : orbits.starts)
    truth.push_back(oracle::long_orbit(orbits.walls, start, orbits.ordered, kBits));
  return truth;
}

void compare(const NearestHit& hit, const RayGroup& group, std::size_t i, CatalogueTally& tally) {
  ++tally.queries;
  const auto& wall = group.wall[i];
  const auto& t = group.t[i];
  if (static_cast<bool>(hit) != t.has_value() || (hit && hit.surface != wall))
    ++tally.wrong;
  else if (hit)
    tally.ulps.push_back(ulps_between(hit.t, *t));
}

void check_group(const RayGroup& group, const Tracer& tracer, CatalogueTally& tally) {
  const auto walls = tracer.build(*group.walls);
  const std::size_t count = group.rays.size();
  std::vector<NearestHit> alone(count);
  for (std::size_t begin = 0; begin < count; begin += kFewRays) {
    RayBatch few;
    for (std::size_t i = begin; i < std::min(begin + kFewRays, count); ++i)
      few.add(group.rays.ray(i));
    walls->nearest(few, std::span(alone).subspan(begin, few.size()));
  }
  const RayBatch many = many_of(group.rays);
  const std::vector<NearestHit> among = measured_hits(*walls, many, group.walls->size(), tally);
  for (std::size_t i = 0; i < count; ++i) compare(alone[i], group, i, tally);
  for (std::size_t i = 0; i < among.size(); ++i) {
    compare(among[i], group, i % count, tally);
    if (among[i] != alone[i % count]) ++tally.apart;
  }
}

}  // namespace

std::vector<NearestHit> measured_hits(const Accelerator& walls, const RayBatch& rays,
                                      std::size_t objects, CatalogueTally& tally) {
  std::vector<NearestHit> hits(rays.size());
  tally.seconds += least_seconds_of(
      kTimesOfACase, [&] { walls.nearest(rays, hits); }, &thread_seconds, kTold);
  tally.in_batches += rays.size();
  tally.one_by_one += walls.left_by_lanes(rays);
  tally.objects += objects;
  tally.bytes += walls.bytes();
  return hits;
}

Result<CatalogueTally> check_certified(const oracle::StiffCase& stiff) {
  if (auto can = can_certify(); !can) return fail(std::move(can));
  CatalogueTally tally;
  for (const oracle::StiffOrbits& orbits : stiff.orbits)
    check_certified_orbits(orbits, truth_of(orbits), tally);
  return tally;
}

double CatalogueTally::most_ulps() const {
  return ulps.empty() ? 0 : ulps[ulps.size() - 1 - ulps.size() / kShare];
}

void CatalogueTally::add(const CatalogueTally& other) {
  using Tally = CatalogueTally;
  for (const auto count : {&Tally::queries, &Tally::wrong, &Tally::leaks, &Tally::apart,
                           &Tally::in_batches, &Tally::one_by_one, &Tally::objects, &Tally::bytes})
    this->*count += other.*count;
  seconds += other.seconds;
  ulps.insert(ulps.end(), other.ulps.begin(), other.ulps.end());
  std::ranges::sort(ulps);
}

std::vector<CatalogueTally> check_case(const oracle::StiffCase& stiff,
                                       std::span<const Tracer* const> tracers) {
  std::vector<CatalogueTally> tallies(tracers.size());
  for (std::size_t i = 0; i < stiff.rays.size();) {
    const RayGroup group = group_of(std::span(stiff.rays).subspan(i));
    for (std::size_t k = 0; k < tracers.size(); ++k) check_group(group, *tracers[k], tallies[k]);
    i += group.rays.size();
  }
  for (const oracle::StiffOrbits& orbits : stiff.orbits) {
    const std::vector<oracle::LongOrbit> truth = truth_of(orbits);
    for (std::size_t k = 0; k < tracers.size(); ++k)
      check_orbits(orbits, truth, *tracers[k], tallies[k]);
  }
  for (CatalogueTally& tally : tallies) std::ranges::sort(tally.ulps);
  return tallies;
}

}  // namespace flatray
