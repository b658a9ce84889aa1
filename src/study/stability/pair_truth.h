#pragma once
#include <set>
#include <string>

#include "anim/timeline.h"

namespace flatray {

/// Which entities of a scene meet, by arithmetic that what finds meetings has no part in.
struct PairTruth {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< entities, ascending
  std::set<Pair> compared;                               ///< all pairs looked at
  std::set<Pair> meet;                                   ///< of these
  std::size_t bent = 0;      ///< of those compared, pairs with discs, or of which one turns
  std::size_t grazing = 0;   ///< pairs that come too close for bits to tell: not compared
  std::size_t left_out = 0;  ///< pairs with arcs, ellipses, capsules: the reference knows none
  std::size_t cut = 0;       ///< pairs that there was no time for

  /// "12 pairs of polygons by shadows in rationals (oracle/contact), 3 of which meet; ..."
  std::string words() const;
};

/// Motion as find_meetings() has it: straight for the whole time where velocities are kept, else as
/// TrueMotion tells, from frame to frame.
///
/// Needs   last_frame as the timeline has it.
/// Gives   pairs of which one moves; those never within each other's reach take no arithmetic.
/// Cost    some 100 us for each two pieces, a ms of what is round or turns, and that each frame
///         where motion is not straight.
PairTruth pair_truth(const Timeline& timeline, unsigned last_frame, double seconds);

/// Wrong pairs of those compared, split into those not seen and those not there.
struct PairErrors {
  std::size_t missed = 0, invented = 0;
};
PairErrors pair_errors(const PairTruth& truth, const std::set<PairTruth::Pair>& found);

}  // namespace flatray
