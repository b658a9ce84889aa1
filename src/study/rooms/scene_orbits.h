#pragma once
#include "study/rooms/room.h"

namespace flatray {

/// Orbits an experiment looks at one by one: the rays of the scene, or drawn ones where it has
/// none, of quasi-random starts all under one shift.
///
/// Error   no walls; a ray that starts in an obstacle, or outside the chamber: nothing is measured
///         of it.
struct NamedOrbits {
  std::vector<std::string> names;
  std::vector<OrbitStart> starts;
  bool random = false;
};
Result<NamedOrbits> orbits_to_watch(const ExperimentContext& context, const Room& room,
                                    std::uint64_t random_orbits);

}  // namespace flatray
