#pragma once
#include "scene/scene.h"

namespace flatray {

/// A scene in motion. Kinematic scenes need nothing stored but the Markov states, replayed once up to the last
/// frame; contact responses will add piecewise motion here.
class Timeline {
 public:
  /// Needs   `scene` outlives the timeline. `seed` replaces the scene's own where given by the command line.
  Timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame);

  const Scene& scene() const { return *scene_; }
  std::uint64_t seed() const { return seed_; }

  struct MarkovFrame {
    StateId state;
    std::uint32_t sub_state;
    Vec2 moved;  ///< sum of the velocities so far, world units
  };
  /// For entity `index` with a chain, at frame k in [1, last_frame].
  const MarkovFrame& markov(std::uint32_t index, unsigned frame) const;

  const Bounds& content() const { return content_; }  ///< of frame 1, for scenes without a window

 private:
  const Scene* scene_;
  std::uint64_t seed_;
  std::vector<std::vector<MarkovFrame>> markov_;  ///< by entity, empty without a chain
  Bounds content_;
};

}  // namespace flatray
