#pragma once
#include <vector>

#include "anim/rigid_motion.h"
#include "collide/outline_contact.h"

namespace flatray {

/// A shape that is carried along for t from 0 to 1.
struct CarriedShape {
  const Shape* shape;
  Carried way;

  bool goes_straight() const { return way.motion.is_even() && way.motion.angle.is_constant(); }
  /// Needs   a straight way.
  MovingShape as_moving() const {
    const RigidMotion& motion = way.motion;
    return {shape, pose(motion.at.c[0], motion.angle.c[0], way.scale), motion.at.c[1]};
  }
};

/// Every time in which two such shapes meet, or the boxes around them, ascending and apart.
///
/// Error   where both go straight as shapes_meet(), else as turning_contact(), of ellipses that of polygons
///         in and about them: what overlaps on a cut alone touches, and what parts for
///         less than kTurningWidth, or after more than kMostPartingSteps steps, has not parted. Of what is
///         carried beyond kTamest it is not told whether it meets.
/// Cost    of ellipses a ms for each meeting.
std::vector<MeetingPart> carried_shapes_meet(const CarriedShape& a, const CarriedShape& b,
                                             Outline outline = Outline::own);
inline constexpr double kTamest = 1e150;

}  // namespace flatray
