#pragma once
#include <span>
#include <vector>

#include "geom/exact.h"
#include "scene/scene.h"

namespace flatray {

/// One row of a chain: where it goes and how likely, exactly.
struct ChainStep {
  StateId to;
  Rational probability;
};
using ChainRow = std::vector<ChainStep>;

/// Sum of a row, exact.
Rational total_probability(std::span<const ChainStep> row);

/// Makes a row sum to 1 in the way asked for. False where that way cannot: more than 1 leaves no
/// rest to send, 0 does not scale, `none` changes nothing.
bool repair_row(ChainRow& row, ChainRepair repair, StateId self, StateId start);

/// Cumulative 64-bit fixed point of a row that sums to 1: round(2^64 * sum so far) - 1, halves up.
/// Steps too unlikely for any draw are dropped, 0 among them; the last entry is 2^64 - 1.
std::vector<Transition> cumulative_row(std::span<const ChainStep> row);

}  // namespace flatray
