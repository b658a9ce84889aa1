#include "study/rooms/boundary_orbits.h"

namespace flatray {

Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                       std::uint64_t random_orbits) {
  FLATRAY_TRY(watched, orbits_to_watch(context, room, random_orbits));
  const std::uint64_t orbits = watched->starts.size();
  return BoundaryOrbits{std::move(*watched),
                        context.bounces.value_or((context.count + orbits - 1) / orbits)};
}

}  // namespace flatray
