#pragma once
#include <vector>

#include "anim/frame_state.h"
#include "collide/round_contact.h"

namespace flatray {

/// A shape that moves along a straight line without turning.
struct MovingShape {
  const Shape* shape;
  Pose place;  ///< at t = 0
  Vec2 velocity;
};

/// The convex parts of a shape as placed: pieces, segments, discs.
struct ShapePart {
  std::vector<Vec2> ring;
  double radius = 0;
};
std::vector<ShapePart> parts_of(const Shape& shape, const Pose& place);

/// A time in which two shapes have a point in common.
struct MeetingPart {
  Range times;
  HitClass kind;
  StartPlace start;  ///< how they lie at t = 0
  Vec2 point;        ///< where they first meet in this part, about; of an overlap a vertex inside
  Vec2 normal;       ///< unit, out of the first shape; of those that meet from the start that of the
                     ///< shortest way apart
};

/// Every time within a range in which two shapes meet, ascending and apart: the times of their
/// convex pieces, segments and discs together.
///
/// Gives   kind: through where any pieces overlap, else along where any touch for a while.
/// Error   as round_contact(); shapes with arcs are taken without those.
std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within);

/// The same of the boxes around both shapes.
std::vector<MeetingPart> boxes_meet(const MovingShape& a, const MovingShape& b, Range within);

/// Whether a shape has parts that shapes_meet leaves out.
bool has_parts_left_out(const Shape& shape);

}  // namespace flatray
