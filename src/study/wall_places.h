#pragma once
#include "trace/surfaces.h"

namespace flatray {

/// A wall by the way along it: a segment from its first end, a circle counter-clockwise from its
/// rightmost point.
///
/// Error   a few ulps of the largest coordinate.
double wall_length(const Surfaces& walls, std::uint32_t surface);
Vec2 wall_point(const Surfaces& walls, std::uint32_t surface, double position);
/// Where on a wall a point lies that is near it.
double wall_position(const Surfaces& walls, std::uint32_t surface, const Vec2& point);

/// Unit normal to the left of a segment, or outward of a circle.
Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point);
/// Of a wall as seen from the side `normal` points to: positive where rays that come from there are
/// parted.
double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal);

}  // namespace flatray
