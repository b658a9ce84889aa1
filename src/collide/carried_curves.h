#pragma once
#include <vector>

#include "anim/rigid_motion.h"
#include "collide/outline_contact.h"

namespace flatray {

/// Parts of which one at least is an ellipse, each carried along for t from 0 to `length`.
///
/// Gives   every meeting, ascending and apart.
/// Error   proven, as turning_contact() does for polygons in and about the ellipse, which are made finer
///         where they first and last touch until rounding ends that. What the two do not tell alike is
///         uncertain.
/// Cost    a ms for each meeting.
std::vector<MeetingPart> carried_curves_meet(const ShapePart& part_a, const RigidMotion& a,
                                             const ShapePart& part_b, const RigidMotion& b,
                                             double length);

}  // namespace flatray
