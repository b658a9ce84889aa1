#pragma once
#include <functional>
#include <memory>

#include "study/rooms/scene_orbits.h"

namespace flatray {

/// Where on the walls an orbit bounces: how far along them, as a share of all walls, and the sine
/// of the angle at which it leaves, in the sense of the walls. Reflection keeps areas in it.
struct BoundaryPoint {
  double along, sine;
};

/// Looks at the bounces of one orbit as they come, and keeps what it is asked to find.
class BoundaryWatch {
 public:
  virtual ~BoundaryWatch() = default;
  virtual void see(const BoundaryPoint& point) = 0;
  virtual Numbers numbers() const = 0;
};

/// Orbits of the scene's rays, or drawn ones, that share the bounces of the context's count.
struct BoundaryOrbits {
  NamedOrbits orbits;
  std::uint64_t bounces;  ///< of each, unless it ends
};
Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                       std::uint64_t random_orbits);

/// Follows them, each with a watch of its own, in blocks (study/statistics/blocks.h).
/// Gives   the audit of fast orbits; what each watch found to `take`, in the order of the orbits.
Result<std::vector<Measure>> watch_bounces(
    const ExperimentContext& context, const Room& room, const BoundaryOrbits& orbits,
    const std::function<std::unique_ptr<BoundaryWatch>()>& make_watch,
    const std::function<void(std::size_t orbit, std::span<const double> found)>& take);

}  // namespace flatray
