#pragma once
#include <vector>

#include "anim/frame_state.h"
#include "geom/ray.h"

namespace flatray {

/// A ray of the scene as it sets off at a time.
struct RayState {
  std::uint32_t ray;  ///< index into Scene::rays
  Ray start;          ///< in the world; the direction is not zero
  double scale = 1;   ///< of the groups it stands in
  Stroke stroke;
  double opacity = 1;
};

/// The rays of a scene at a time in seconds, by their numbers, without those whose direction then has
/// no length.
std::vector<RayState> ray_states(const Scene& scene, double time);
/// The same in the world of a frame, displaced as everything is.
std::vector<RayState> ray_states(const Scene& scene, const FrameState& state);

/// Whether a ray differs from frame to frame by itself, not by its groups.
bool moves(const RayPath& ray);

}  // namespace flatray
