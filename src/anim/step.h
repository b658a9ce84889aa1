#pragma once
#include "base/check.h"
#include "scene/scene.h"

namespace flatray {

/// State after one step.
/// Needs   `draw` uniform over 64 bits: random_bits(seed, Stream::markov, step, entity).
inline StateId step(const MarkovChain& chain, StateId from, std::uint64_t draw) {
  for (const Transition& choice : chain.rows[from])
    if (draw <= choice.cumulative) return choice.to;
  unreachable();
}

}  // namespace flatray
