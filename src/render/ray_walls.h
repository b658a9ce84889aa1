#pragma once
#include "render/plan.h"
#include "transport/orbit_tracer.h"

namespace flatray {

/// Whether rays of the scene fly among walls that stand still: those with a speed do not.
Need need_of_ray_walls(const Scene& scene);

/// The mirrors of one frame, made ready for all its rays that need them.
class RayWalls {
 public:
  /// Needs   what need_of_ray_walls() says.
  RayWalls(const Scene& scene, const FrameState& state, const Tracer* asked);
  RayWalls(const RayWalls&) = delete;
  RayWalls& operator=(const RayWalls&) = delete;

  const World& world() const { return world_; }
  const OrbitTracer& orbits() const { return orbits_; }

 private:
  const World world_;
  const std::vector<Material> materials_;
  const Glass glass_;
  const OrbitTracer orbits_;
};

/// What is built for a frame, and why, as `flatray explain` tells it; without a need what is left out.
/// Cost   builds them.
std::vector<RenderPlan::Choice> ray_wall_choices(const Scene& scene, const FrameState& state,
                                                 const Tracer* asked);

}  // namespace flatray
