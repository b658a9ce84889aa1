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

/// The timeline of a scene, with what follows where its entities meet, as far as that can be told.
struct PartTimeline {
  Timeline timeline;
  unsigned last_frame;  ///< 0: none
  Diagnostics
      problems;  ///< why there are no more: events without end, or more than Collisions::most
};
/// Gives   the same places in a frame whatever the last one.
/// Error   of bodies_of().
/// Cost    where nothing responds that of the timeline alone; else that of simulate().
Result<PartTimeline> timeline_before_trouble(const Scene& scene, std::uint64_t seed,
                                             unsigned last_frame);

/// All of it; its problems are an error.
Result<Timeline> make_timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame);

}  // namespace flatray
