#pragma once
#include "study/periodic/open_discs.h"

namespace flatray {

/// A leg of an orbit, and how many times as wide what is across an unstable orbit gets on it.
struct OrbitStep {
  Near length, stretch;
};

/// From the bounce in the middle of a word, the earlier of two, to the next: enclosures for every
/// orbit that stays for ever and has the word in its own. Errors fall as fast as neighbours part,
/// with half the number of bounces.
///
/// Needs   four bounces or more, of discs that differ from the one before.
/// Gives   an infinite error where too little is known.
/// Source  docs/NUMERICS.md, periodic orbits.
OrbitStep middle_step(const OpenDiscs& discs, const Word& word);

}  // namespace flatray
