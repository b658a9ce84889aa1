#pragma once
#include "anim/frame_state.h"
#include "trace/surfaces.h"

namespace flatray {

/// What a surface belongs to.
struct SurfaceOwner {
  enum class Kind : std::uint8_t { entity, chamber, pillar } kind;
  std::uint32_t index;   ///< entity; chamber
  std::uint32_t pillar;  ///< of the chamber
  std::int32_t edge;     ///< of the shape as given; kNoEdge for a circle
  Material material;
};

/// The walls of one frame in world coordinates: outlines of every entity, chamber and pillar (cuts between the
/// pieces of one shape left out), each with its owner.
struct World {
  Surfaces surfaces;
  std::vector<SurfaceOwner> owners;  ///< by surface number
};

World build_world(const Scene& scene, const FrameState& state);

}  // namespace flatray
