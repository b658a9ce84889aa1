#pragma once
#include "study/rooms/scene_orbits.h"

namespace flatray {

/// Where on the walls an orbit bounces: how far along them, as a share of all walls, and the sine
/// of the angle at which it leaves, in the sense of the walls. Reflection keeps areas in it.
struct BoundaryPoint {
  double along, sine;
};

struct BoundaryOrbits {
  NamedOrbits orbits;
  std::vector<std::vector<BoundaryPoint>> points;  ///< by orbit
  std::vector<Measure> audit;                      ///< of fast ones
};

/// Orbits of the scene's rays, or `random_orbits`, that share the bounces of the context's count.
Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                       std::uint64_t random_orbits);

}  // namespace flatray
