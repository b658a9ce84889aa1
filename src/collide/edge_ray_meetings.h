#pragma once
#include "collide/meetings.h"

namespace flatray {

/// Meetings as the paper's method finds them: in each frame the edges of either entity as rays
/// against the convex pieces of the other, as its table 4 has rays of both, and nothing between
/// frames.
///
/// Gives   times of the first and last frame of each run of frames with a hit. How they meet, start
///         and where is not known: class through, start boundary and no place whatever they do. What it
///         does not see, find_meetings does: what goes through another between two frames.
/// Error   more meetings than MeetingLimits has.
Result<std::vector<Meeting>> find_edge_ray_meetings(const Timeline& timeline, unsigned last_frame);

}  // namespace flatray
