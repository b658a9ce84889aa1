#pragma once
#include <memory>

#include "scene/scene.h"

namespace flatray {

/// How a ray leaves a lamp, in coordinates of the lamp: at angle 0 it looks along x.
struct Emitted {
  Vec2 at{0, 0};
  Vec2 direction{1, 0};  ///< of length 1
};

/// Sends out rays that all carry the same power.
class Emitter {
 public:
  virtual ~Emitter() = default;
  /// Needs   `u`: as many numbers as LampType::numbers says, in [0, 1), angles first, then places.
  virtual Emitted emit(const double* u) const = 0;
};

inline constexpr unsigned kMostLampNumbers = 5;

/// The emitter of a lamp at a time in seconds; none where its numbers then leave nothing.
std::unique_ptr<const Emitter> emitter_at(const Scene& scene, const Lamp& lamp, double time);

}  // namespace flatray
