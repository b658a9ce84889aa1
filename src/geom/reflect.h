#pragma once
#include "geom/ray.h"

namespace flatray {

/// `direction` mirrored by a line along `along`. Signs only flip where `along` is parallel to an
/// axis, and components swap exactly where it is a diagonal; never -0.
///
/// Needs   `along` of any length but zero.
/// Error   each component is the nearest double to the exact one, so the length is kept within 1
///         ulp; a component beyond the doubles is the largest of its sign.
Vec2 reflect(const Vec2& direction, const Vec2& along);

}  // namespace flatray
