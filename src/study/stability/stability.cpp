#include "study/stability/stability.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/processor_time.h"
#include "oracle/nearest.h"
#include "study/stability/ulps.h"

namespace flatray {
namespace {

bool agrees(const NearestHit& hit, const oracle::NearestWall& truth) {
  if (!truth) return !hit;
  return hit && hit.surface == truth.wall && hit.kind == truth.kind && hit.at_end == truth.at_end &&
         hit.root == truth.root;
}

void count_ulps(double ulps, StabilityTally& tally) {
  constexpr double kMostCounted = 0x1p63;  // of what a whole number holds
  tally.worst_ulps = std::max(tally.worst_ulps,
                              static_cast<std::uint64_t>(std::ceil(std::min(kMostCounted, ulps))));
  for (std::size_t i = 0; i < tally.off_by_far.size(); ++i)
    if (ulps > std::ldexp(1.0, 8 * static_cast<int>(i + 1))) ++tally.off_by_far[i];
}

void compare(const NearestHit& hit, const oracle::NearestWall& truth, StabilityTally& tally) {
  ++tally.rays;
  if (truth.by == oracle::NearestWall::By::rationals) ++tally.by_rationals;
  if (!agrees(hit, truth)) {
    ++tally.wrong;
    if (!hit)
      ++tally.missed;
    else if (!truth)
      ++tally.invented;
    else if (hit.surface != truth.wall)
      ++tally.other_wall;
    return;
  }
  if (!truth) return;
  ++tally.hits;
  const double t = as_double(truth.t);
  if (hit.t != t) ++tally.not_nearest;
  if (!is_within_ulp(hit.t, t)) ++tally.off_by_more;
  if (hit.t != t) count_ulps(ulps_between(hit.t, t), tally);
}

// One scene by all that are asked: what is true is found once.
void check_scene(std::span<const TracerInTier> asked, const oracle::AimedScene& scene,
                 std::uint64_t item, std::span<StabilityTally> tallies) {
  const Surfaces walls = scene.surfaces();
  RayBatch rays;
  for (const Ray& ray : scene.rays) rays.add(ray);
  std::vector<oracle::NearestWall> truth;
  oracle::NearestWalls oracle(walls);
  for (const Ray& ray : scene.rays) truth.push_back(oracle.of(ray));
  std::vector<NearestHit> hits(rays.size());
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const auto accelerator = asked[k].tracer->build(walls, asked[k].isa);
    StabilityTally& tally = tallies[k];
    const double start = thread_seconds();
    accelerator->nearest(rays, hits);
    tally.nanoseconds += static_cast<std::uint64_t>(1e9 * (thread_seconds() - start));
    tally.timed += rays.size();
    tally.objects += walls.size();
    tally.bytes += accelerator->bytes();
    tally.watched += rays.size();
    tally.one_by_one += accelerator->left_by_lanes(rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const std::uint64_t before = tally.wrong;
      compare(hits[i], truth[i], tally);
      if (tally.wrong > before && tally.first_wrong.empty())
        tally.first_wrong = fmt::format("item {} ray {}", item, i);
    }
  }
}

}  // namespace

void StabilityTally::add(const StabilityTally& other) {
  const std::uint64_t worst = std::max(worst_ulps, other.worst_ulps);
  for (const auto count : kStabilityCounts) this->*count += other.*count;
  worst_ulps = worst;
  for (std::size_t i = 0; i < off_by_far.size(); ++i) off_by_far[i] += other.off_by_far[i];
  if (first_wrong.empty()) first_wrong = other.first_wrong;
}

std::uint64_t StabilityTally::most_ulps() const {
  const std::uint64_t allowed = hits / 1000;
  if (off_by_more <= allowed) return std::min<std::uint64_t>(worst_ulps, 1);
  for (std::size_t i = 0; i < off_by_far.size(); ++i)
    if (off_by_far[i] <= allowed) return std::min(worst_ulps, std::uint64_t{1} << 8 * (i + 1));
  return worst_ulps;
}

std::vector<StabilityTally> check_rays(std::span<const TracerInTier> asked,
                                       const oracle::Family& family, std::uint64_t seed,
                                       std::uint64_t first, std::uint64_t count) {
  std::vector<StabilityTally> tallies(asked.size());
  for (std::uint64_t ray = first; ray < first + count; ray += oracle::kRaysAScene) {
    const std::uint64_t item = ray / oracle::kRaysAScene;
    oracle::AimedScene scene = make_scene(family, seed, item);
    scene.rays.resize(std::min<std::uint64_t>(scene.rays.size(), first + count - ray));
    check_scene(asked, scene, item, tallies);
  }
  return tallies;
}

}  // namespace flatray
