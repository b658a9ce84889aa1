#pragma once
#include <memory>
#include <vector>

#include "anim/frame_state.h"
#include "scene/emitter.h"
#include "scene/spectrum.h"

namespace flatray {

/// A lamp that shines in a frame.
struct LampState {
  std::uint32_t lamp;        ///< index into Scene::lamps
  Pose pose;                 ///< of what its emitter says, in the world
  double power;              ///< above 0, of the largest channel
  LightColour colour;        ///< the largest channel is 1
  double nm;                 ///< its wavelength; 0: light of many
  const Spectrum* spectrum;  ///< null: light of all colours alike, but for its own
  std::unique_ptr<const Emitter> emitter;
  unsigned numbers;  ///< LampType::numbers
};

/// The lamps of a frame that are on, in order of their numbers.
std::vector<LampState> lamp_states(const Scene& scene, const FrameState& state);

/// Whether a lamp differs from frame to frame by itself, not by its groups.
bool moves(const Lamp& lamp);

}  // namespace flatray
