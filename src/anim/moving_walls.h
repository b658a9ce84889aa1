#pragma once
#include <cstdint>
#include <vector>

#include "anim/timeline.h"
#include "anim/world.h"

namespace flatray {

/// Straight and even motion from one time to another: at from + (time - begin) * velocity.
struct Leg {
  double begin = 0, end = kInfinity;  ///< seconds
  Vec2 from{0, 0};                    ///< at `begin`
  /// The velocity is, without rounding, (to - from) / (end - begin): where the next leg begins, to
  /// the last bit. Of the last one, that has no end, it is `velocity`.
  Vec2 to{0, 0};
  Vec2 velocity{0, 0};

  bool is_last() const { return end == kInfinity; }
};

/// The mirrors of a scene from time 0 on, and how they move.
struct MovingWalls {
  /// Mirrors as a World has them; those of what moves as seen from where it is.
  World world;
  std::vector<std::vector<Leg>> motions;  ///< the first one rests
  std::vector<std::uint32_t> motion_of;   ///< by surface
  std::vector<double> gone_from;          ///< by motion: when it is removed; else infinity

  const std::vector<Leg>& legs(std::uint32_t surface) const { return motions[motion_of[surface]]; }
};

/// Needs   a scene without refused_mirrors().
/// Error   places at keys and events, and velocities in groups, are rounded as in the frames; between
///         those nothing is.
MovingWalls moving_walls(const Timeline& timeline);

}  // namespace flatray
