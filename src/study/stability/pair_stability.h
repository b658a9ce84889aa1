#pragma once
#include "study/stability/stability.h"

namespace flatray {

/// Of the times at which turning pairs meet: wider ones count as not told exactly.
inline constexpr double kAskedWidth = 0x1p-40;

/// A kind of moving pairs that are hard to tell about: in straight motion, asked one by one
/// ("contact") and, without radii, together ("contacts"), or turning ("turning").
struct PairFamily {
  std::string name;
  std::vector<std::string> methods;
};
std::vector<PairFamily> pair_families();

/// Of what runs keep and go on from.
inline constexpr std::uint64_t kPairsAChunk = 1024;

/// Pairs `first` to `first + count - 1` of a family against the oracle.
///
/// Gives   a tally for each method, pairs as rays: `other_wall` counts classes and starts that are
///         wrong, times are those of the first and the last touch. Of turning pairs `not_nearest`
///         counts intervals wider than asked, `by_rationals` what either side leaves undecided.
/// Cost    5 to 100 us a pair, some 300 of round ones, a ms of turning ones.
std::vector<StabilityTally> check_pairs(const PairFamily& family, std::uint64_t seed,
                                        std::uint64_t first, std::uint64_t count);

}  // namespace flatray
