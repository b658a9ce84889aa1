#pragma once
#include "collide/meetings.h"

namespace flatray {

/// Meetings as the paper's method finds them: in each frame the edges of the first entity as rays
/// against the convex pieces of the second, and nothing between frames.
///
/// Gives   times of the first and last frame of each run of frames with a hit; class through, no
///         place. What it does not see, find_meetings does: what goes through another between two
///         frames, and the second inside the first.
std::vector<Meeting> find_edge_ray_meetings(const Timeline& timeline, unsigned last_frame);

}  // namespace flatray
