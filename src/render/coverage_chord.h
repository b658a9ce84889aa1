#pragma once
#include <optional>

#include "geom/bounded.h"
#include "render/coverage_edges.h"

namespace flatray {

/// floor(kFullCoverage * area / share) of an area between 0 and `share`, where the bounds decide.
/// Needs   share > 0.
std::optional<std::uint32_t> bounded_steps(const Bounded& area, const Bounded& share);

/// The step of a pixel that one edge cuts from border to border and no other touches: without a
/// division, so that coordinates of few digits, whose areas often lie on a step, are decided.
///
/// Needs   `winding` at the pixel's upper left corner, just inside, without the edge.
/// Gives   nullopt where the edge may end inside the pixel, is level, or the bounds do not decide.
std::optional<std::uint32_t> chord_steps(const ScanEdge& edge, int winding, int column, int row,
                                         FillRule rule);

}  // namespace flatray
