#pragma once
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace flatray {

/// Seeded walks of one chain from one state until an absorbing one.
struct WalkPlan {
  const MarkovChain& chain;
  StateId start = 0;
  std::vector<bool> absorbing;         ///< by state
  std::uint64_t walks = 0;             ///< at most 2^32
  std::uint64_t longest = 1ULL << 32;  ///< steps after which a walk is given up, at most 2^32
  std::uint64_t seed = 0;
  std::uint32_t name = 0;  ///< tells these draws from those of other plans under the same seed
};

struct WalkCounts {
  explicit WalkCounts(const MarkovChain& chain)
      : transitions(chain.rows.size(), std::vector<std::uint64_t>(chain.rows.size())) {}
  WalkCounts& operator+=(const WalkCounts& other);

  std::uint64_t steps = 0;                              ///< of all walks together
  std::uint64_t unfinished = 0;                         ///< walks given up
  std::vector<std::vector<std::uint64_t>> transitions;  ///< taken, from x to
};

/// Step s of walk w is drawn as random_bits(seed, Stream::experiment, s, w, name). Integer sums
/// over blocks of walks fixed by their number, so the same counts for any number of threads. Cost
/// about 15 ns a step.
WalkCounts walk(const WalkPlan& plan, unsigned threads);

}  // namespace flatray
