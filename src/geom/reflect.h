#pragma once
#include "geom/ray.h"

namespace flatray {

/// `direction` mirrored by a line along `along`: length kept within 4 ulp; signs only flip where
/// `along` is parallel to an axis, and components swap exactly where it is a diagonal.
///
/// Error   2 ulp a component where it does not cancel; computed in double-double, rounded once.
Vec2 reflect(const Vec2& direction, const Vec2& along);

}  // namespace flatray
