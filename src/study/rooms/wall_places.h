#pragma once
#include "trace/surfaces.h"

namespace flatray {

/// A wall by the way along it: a segment from its first end, an arc counter-clockwise from its
/// beginning, a circle from its rightmost point, an ellipse from the end of its first half-diameter.
///
/// Error   a few ulps of the largest coordinate; of ellipses some 1e-9 of the length.
/// Cost    of ellipses 10 us, and 500 us for a point by its position.
double wall_length(const Surfaces& walls, std::uint32_t surface);
Vec2 wall_point(const Surfaces& walls, std::uint32_t surface, double position);
/// Where on a wall a point lies that is near it.
double wall_position(const Surfaces& walls, std::uint32_t surface, const Vec2& point);

/// Points along a wall, both ends among them, to draw it: the two of a segment, many of a curve.
std::vector<Vec2> wall_outline(const Surfaces& walls, std::uint32_t surface);

/// Unit normal to the left of a segment, or outward of a curve.
Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point);
/// Of a wall as seen from the side `normal` points to: positive where rays that come from there are
/// parted.
double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal);

}  // namespace flatray
