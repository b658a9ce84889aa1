#pragma once
#include <span>
#include <vector>

#include "geom/exact.h"
#include "geom/vec.h"

namespace flatray {

/// Exact area of the union or of the symmetric difference of convex pieces inside
/// pixel [x, x+1] x [y, y+1], by vertical slabs between the corners and crossings of their sides and
/// the pixel's. Shares nothing with the engine: no windings, no outlines.
///
/// Needs   convex rings in either orientation; without area they count for nothing.
/// Cost    some 100 us a pixel.
Rational exact_union_area(std::span<const std::vector<Vec2>> pieces, int x, int y);
Rational exact_odd_area(std::span<const std::vector<Vec2>> pieces, int x, int y);

}  // namespace flatray
