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

  /// Needs   a way that is even.
  MovingShape as_moving() const;
};

/// Every time in which two such shapes meet, or the boxes around them, ascending and apart.
///
/// Error   where both go straight and turn evenly as shapes_meet(), else as turning_contact(). Of what
///         is carried beyond kTamest it is not told whether it meets.
std::vector<MeetingPart> carried_shapes_meet(const CarriedShape& a, const CarriedShape& b,
                                             Outline outline = Outline::own);
inline constexpr double kTamest = 1e150;

/// What shapes_meet() tells of shapes of which one turns, for t from 0 to `length`.
std::vector<MeetingPart> turning_shapes_meet(const MovingShape& a, const MovingShape& b,
                                             double length);

}  // namespace flatray
