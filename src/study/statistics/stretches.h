#pragma once
#include "study/statistics/estimate.h"

namespace flatray {

/// What of one long run falls into a stretch of it: the ratio of all x to all y is what is
/// measured.
struct Stretch {
  double x, y;
};

/// Stretches that a run is cut into where it is to tell its own error.
inline constexpr std::size_t kStretches = 32;
/// Of these in a part, as which they tell the error.
inline constexpr std::size_t kStretchesInPart = 4;

/// A mean over runs of which what follows each other is not independent, by batch means: stretches
/// so long that they know little of each other. Neighbours are compared in 32 of them, the error is
/// that of fours of them, which know less of each other still.
///
/// Needs   stretches in the order of their runs.
/// Gives   no error, and a remark why, where there are fewer than kStretches, or where neighbours
///         resemble each other more than one run in twenty of independent ones has it: then the run
///         is too short to tell its error.
/// Source  batch means, Schmeiser 1982; lag-one correlation, von Neumann 1941.
Measure measure_of_run(std::string name, std::span<const Stretch> stretches);

}  // namespace flatray
