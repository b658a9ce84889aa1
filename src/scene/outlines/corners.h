#pragma once
#include <vector>

#include "geom/vec.h"

namespace flatray {

/// Corners at equal angles round a centre, counter-clockwise from `degrees`; their distances from
/// the centre are those of `radii` in turn.
///
/// Gives   corners at multiples of 90 degrees exactly on the axes through the centre, and those of
///         opposite directions at opposite offsets.
/// Error   offsets within 2 ulp of the radius.
std::vector<Vec2> corners(const Vec2& centre, int count, double degrees,
                          std::initializer_list<double> radii);

}  // namespace flatray
