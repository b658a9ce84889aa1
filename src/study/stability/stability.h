#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/isa.h"
#include "oracle/families.h"
#include "trace/tracer.h"

namespace flatray {

/// How the answers of one tracer to some rays of a family compare with the oracle's.
struct StabilityTally {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;          ///< rays that meet a wall and are told so right
  std::uint64_t wrong = 0;         ///< of wall, class, root or end; of these:
  std::uint64_t missed = 0;        ///< nothing met where there is a wall
  std::uint64_t invented = 0;      ///< a wall met where there is none
  std::uint64_t other_wall = 0;    ///< a wall that is not the first; else class or end is wrong
  std::uint64_t not_nearest = 0;   ///< hits whose t is not the double nearest to the exact one
  std::uint64_t off_by_more = 0;   ///< hits whose t is more than 1 ulp off it
  std::uint64_t by_rationals = 0;  ///< rays for which the oracle's bounds did not suffice
  std::uint64_t watched = 0;     ///< rays of which it is known whether they were decided one by one
  std::uint64_t one_by_one = 0;  ///< rays that no lanes were certain of
  std::uint64_t worst_ulps = 0;  ///< by which a t is off, rounded up
  /// Hits whose t is more than 2^8, 2^16, ... 2^48 ulps off.
  std::array<std::uint64_t, 6> off_by_far{};
  std::uint64_t timed = 0;        ///< rays that were timed
  std::uint64_t nanoseconds = 0;  ///< of processor time for those
  std::uint64_t objects = 0;      ///< walls, each time they were made ready
  std::uint64_t bytes = 0;        ///< that took beside the walls themselves
  std::string first_wrong;        ///< "item 17 ray 3"; "" for none

  /// A number of ulps that no more than one hit in a thousand exceeds: 1, a power of 2^8, or the
  /// worst.
  std::uint64_t most_ulps() const;

  void add(const StabilityTally& other);
};
/// All that are plain counts.
inline constexpr std::array kStabilityCounts = {
    &StabilityTally::rays,        &StabilityTally::hits,        &StabilityTally::wrong,
    &StabilityTally::not_nearest, &StabilityTally::off_by_more, &StabilityTally::by_rationals,
    &StabilityTally::missed,      &StabilityTally::invented,    &StabilityTally::other_wall,
    &StabilityTally::watched,     &StabilityTally::one_by_one,  &StabilityTally::worst_ulps,
    &StabilityTally::timed,       &StabilityTally::nanoseconds, &StabilityTally::objects,
    &StabilityTally::bytes};

/// Who is asked: a tracer in an instruction-set tier.
struct TracerInTier {
  const Tracer* tracer;
  Isa isa = active_isa();
};

/// Of what runs keep and go on from.
inline constexpr std::uint64_t kRaysAChunk = std::uint64_t{256} * oracle::kRaysAScene;

/// Rays `first` to `first + count - 1` of a family, those of a scene in one batch.
///
/// Needs   `first` a multiple of oracle::kRaysAScene.
/// Gives   a tally for each of `asked`.
/// Cost    some 1 us a ray, found out once for all, and 1 to 2 us for each asked; of `exact`, and
///         where most walls are too close for bounds, some 20 us.
std::vector<StabilityTally> check_rays(std::span<const TracerInTier> asked,
                                       const oracle::Family& family, std::uint64_t seed,
                                       std::uint64_t first, std::uint64_t count);

}  // namespace flatray
