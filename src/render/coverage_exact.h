#pragma once
#include <span>

#include "geom/exact.h"
#include "render/coverage_edges.h"

namespace flatray {

/// Area of a region inside one pixel in rationals, where doubles cannot decide.
///
/// Needs   every edge that may touch the closed pixel, once; `winding` at the pixel's upper left
///         corner, just inside, as counted by `cut_row` without these edges.
/// Cost    some 50 us for one or two edges; grows with the square of their number.
Rational exact_area(std::span<const ScanEdge> edges, int winding, int column, int row,
                    FillRule rule);

/// floor(kFullCoverage * exact_area), by double-double where its error bound decides.
/// Cost    some 2 us for one edge, else that of `exact_area`.
std::uint32_t exact_steps(std::span<const ScanEdge> edges, int winding, int column, int row,
                          FillRule rule);

}  // namespace flatray
