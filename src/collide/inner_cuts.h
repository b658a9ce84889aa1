#pragma once
#include <span>
#include <vector>

#include "collide/outline_contact.h"

namespace flatray {

/// Parts of a body, and how it moves.
struct MovingParts {
  std::span<const ShapePart> parts;
  Vec2 velocity;

  /// Of a part that is no ellipse.
  MovingBody body(std::size_t part) const {
    return {parts[part].ring, velocity, parts[part].radius};
  }
};

/// Cuts between the convex pieces of an outline are inside it: what has no area and only ever lies
/// on cuts overlaps, where contact with each piece alone tells that they touch.
///
/// Needs   `met`: meetings of both within a range, ascending and apart, of their parts alone.
/// Gives   class through and start overlapping where that is so.
/// Error   exact for the doubles given.
/// Cost    nothing where nothing is cut; else three predicates for each cut and part without area.
void count_cuts_as_inside(const MovingParts& a, const MovingParts& b, Range within,
                          std::vector<MeetingPart>& met);

}  // namespace flatray
