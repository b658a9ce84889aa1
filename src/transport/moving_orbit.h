#pragma once
#include "anim/moving_walls.h"
#include "transport/orbit.h"

namespace flatray {

/// What a bounce off a wall that moves has beside that off one that stands still.
struct BounceTime {
  double time;         ///< seconds of the clock
  Vec2 wall_velocity;  ///< of the wall met

  bool operator==(const BounceTime&) const = default;
};

/// An orbit at finite speed. Of its bounces `t` is seconds, `in` and `out` are velocities: a wall
/// that comes makes faster, one that goes slower.
struct MovingOrbit {
  Orbit orbit;
  std::vector<BounceTime> times;  ///< by bounce
  double end_time = 0;            ///< of the last bounce, or of what ended it
  Vec2 velocity{0, 0};            ///< after the last bounce
};

/// How long a particle is followed.
struct MovingLimits {
  std::uint64_t bounces = 0;
  double until = kInfinity;  ///< seconds: it ends there, or at the last double, as `limit`
};

/// Follows a particle among mirrors that move in straight lines, from time `from` on, at the
/// velocity of `start`. A bounce off a wall of velocity u with normal n makes of v
/// v - 2 ((v - u) . n) n / n.n, as if nothing but the wall stood still.
///
/// Needs   walls of segments and circles, mirrors or absorbing; a velocity that is not zero, from >= 0.
/// Gives   what trace_orbit gives of walls at rest: starts on a wall, ends of walls, points where
///         two are met at one time (corners, also between walls that come together) and circles
///         that are only touched mean the same. A wall that closes in from behind is met as well. One
///         that is removed meets nothing from then on.
/// Error   which wall is next, and whether there is one, is exact for the doubles of the last bounce
///         (place, velocity, time as a sum of two doubles) and the motion of the walls: nothing
///         tunnels, whatever the speed of walls and of the particle. Rounded are times (to 2^-80 of
///         them), places (the nearest double on the inner side, as ExactOrigins) and velocities (nearest
///         doubles; moved by at most 2 more where that would lead back into the wall): at every
///         scale the same.
/// Cost    all walls are looked at for each bounce, some 0.3 us each.
MovingOrbit trace_moving_orbit(const MovingWalls& walls, const Ray& start, double from,
                               const MovingLimits& limits);

/// `direction` at a speed.
Vec2 at_speed(const Vec2& direction, double speed);

}  // namespace flatray
