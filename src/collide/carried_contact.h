#pragma once
#include <vector>

#include "anim/rigid_motion.h"
#include "collide/outline_contact.h"

namespace flatray {

/// What stands for an entity: its own outline, or the upright box around it at each time.
enum class Outline : std::uint8_t { own, box };

/// A shape that is carried along for t from 0 to 1.
struct CarriedShape {
  const Shape* shape;
  Carried way;

  bool goes_straight() const { return way.motion.is_even() && way.motion.angle.is_constant(); }
  /// Needs   a straight way.
  MovingShape as_moving() const;
};

/// Every time in which two such shapes meet, or the boxes around them, ascending and apart.
///
/// Error   where both go straight as shapes_meet(), else as turning_contact(): what overlaps on a cut
///         alone touches, and what parts for less than kTurningWidth, or after more than
///         kMostPartingSteps steps, has not parted. Of what is carried beyond kTamest it is not told
///         whether it meets.
std::vector<MeetingPart> carried_shapes_meet(const CarriedShape& a, const CarriedShape& b,
                                             Outline outline = Outline::own);
inline constexpr double kTamest = 1e150;

}  // namespace flatray
