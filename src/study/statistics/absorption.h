#pragma once
#include <optional>
#include <vector>

#include "geom/exact.h"
#include "scene/scene.h"

namespace flatray {

/// Probabilities of one step, exact: rows x states.
using StepMatrix = std::vector<std::vector<Rational>>;

/// What the chain's draws have: multiples of 2^-64 from its cumulative table.
StepMatrix drawn_probabilities(const MarkovChain& chain);

/// What the scene asks for: the chain's fractions, or where it has none the simplest fractions that
/// round to its probabilities. nullopt where they do not sum to exactly 1.
std::optional<StepMatrix> given_probabilities(const MarkovChain& chain);

/// Whether a state is never left, by state.
std::vector<bool> absorbing_states(const StepMatrix& steps);

/// Number of steps to one of some states: closed form.
struct Absorption {
  Rational expected, variance;
};

/// From each state to those of `absorbing`, which are never left: expected (I - Q)^-1 1 of the paper's
/// kind of chain, exactly. nullopt where some way out of the state never ends in one, so that the
/// number is infinite.
/// Cost    O(states^3) operations on growing fractions: 64 states take seconds, half a minute where
///         their probabilities have 17 digits.
std::vector<std::optional<Absorption>> steps_to_absorption(const StepMatrix& steps,
                                                           const std::vector<bool>& absorbing);

}  // namespace flatray
