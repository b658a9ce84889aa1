#pragma once
#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// Cuts the walls of a chamber at the ends of its holes, into `parts` and `kept`.
///
/// Gives   parts that share the doubles of their ends, so that nothing leaves between them. Parts of an arc
///         lie on the curve of all of it; the line of a part of a straight wall may be an ulp off the wall's.
/// Error   every hole that is on no edge, reaches beyond its edge or into another hole, or is so small that
///         its ends are the same doubles.
Diagnostics cut_walls(const Shape& shape, Chamber& chamber);

}  // namespace flatray
