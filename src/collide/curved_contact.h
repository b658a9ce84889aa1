#pragma once
#include <optional>

#include "collide/outline_contact.h"

namespace flatray {

/// When two parts meet within a range, in linear motion, of which one at least is an ellipse; nullopt where
/// they never do.
///
/// Needs   ellipses of finite half-diameters with an area.
/// Gives   proven: the polygons in and about an ellipse, sandwich.h, meet exactly when contact() says.
///         What the two do not tell alike is not `certain`.
/// Error   they are made finer where the outer ones first and last meet, until what they differ by is lost
///         in the rounding of their corners: some 2^-38 of what coordinates and half-diameters add up to,
///         more for thin ellipses, over the speed along the normal.
/// Cost    some 0.3 ms.
std::optional<MeetingPart> curved_parts_meet(const ShapePart& a, const Vec2& velocity_a,
                                             const ShapePart& b, const Vec2& velocity_b,
                                             Range within);

}  // namespace flatray
