#pragma once
#include "anim/timeline.h"
#include "base/result.h"

namespace flatray {

struct Simulation;

/// Whether all events up to a time are there.
///
/// Error   at `where`: events without end, or more than were allowed, before `last`; what came after
///         is not its business.
Result<void> check_complete(const Scene& scene, const Simulation& done, double last,
                            const Place& where);

/// The timeline of a scene, with what follows where its entities meet.
///
/// Gives   the same places in a frame whatever the last one.
/// Error   events without end, or more than Collisions::most, before the last frame.
/// Cost    where nothing responds that of the timeline alone; else that of simulate().
Result<Timeline> make_timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame);

}  // namespace flatray
