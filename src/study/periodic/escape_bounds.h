#pragma once
#include <string>

#include "study/periodic/mirrors.h"

namespace flatray {

/// Bounds of the escape rates of a room of discs, proven: rounding and all that is left out are in
/// them.
struct EscapeBounds {
  std::size_t bounces;  ///< of each word that was looked at
  Range per_length, per_bounce;
};

/// From all words of so many bounces, as many as at most `most_words` allow: the largest eigenvalue
/// of their transfer matrix is between those of matrices of lower and of upper bounds of its
/// weights. Stopped() of the monitor is asked between words.
///
/// Needs   `about` near the escape rate a unit of length: the nearer, the closer the bounds.
/// Error   why there are none: the discs are not known to be open ones (OpenDiscs), or too many;
///         words tell too little, where discs are near each other.
/// Cost    some 10 us a word, 24 bytes.
/// Source  docs/NUMERICS.md, periodic orbits.
tl::expected<EscapeBounds, std::string> escape_bounds(const ExperimentContext& context,
                                                      const MirrorRoom& room,
                                                      std::size_t most_words, double about);

}  // namespace flatray
