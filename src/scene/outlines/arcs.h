#pragma once
#include "scene/shape.h"

namespace flatray {

/// Unit vector at an angle; multiples of 90 degrees exactly.
Vec2 unit_at_degrees(double degrees);

/// Whether angles in degrees are a whole turn apart, as far as the doubles next to what was written tell.
bool is_whole_turn(double from, double to);

/// Reads `from` and `to`, degrees: the arc that runs counter-clockwise between them.
Result<EllipseArc> circular_arc(Args& args, const Vec2& centre, double radius);

inline Shape shape_of(ArcPath path) { return {.arc_paths = {std::move(path)}}; }

}  // namespace flatray
