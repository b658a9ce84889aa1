#pragma once
#include <optional>
#include <vector>

#include "anim/timeline.h"
#include "geom/bounds.h"
#include "geom/cubic.h"

namespace flatray {

/// What a group that turns adds to the place of what it carries: R(turned) arm.
struct Swing {
  Cubic<Vec2> arm;
  Cubic<double> turned;  ///< radians
};

/// Where a body is, and how it is turned: at + the sum of the swings; angle.
struct RigidMotion {
  Cubic<Vec2> at = linear(Vec2(0, 0), Vec2(0, 0));
  Cubic<double> angle = linear(0, 0);  ///< radians
  std::vector<Swing> swings{};
  double doubt = 0, angle_doubt = 0;  ///< by how much rounding may have moved it, and turned it

  /// Whether it goes straight and turns evenly, if at all.
  bool is_even() const { return swings.empty() && at.is_linear() && angle.is_linear(); }
};

/// at + t * velocity, turned by angle + t * spin.
inline RigidMotion even_motion(const Vec2& at, const Vec2& velocity, double angle, double spin) {
  return {linear(at, velocity), linear(angle, spin)};
}

/// A motion for t from 0 to 1, and the scale that stays.
struct Carried {
  RigidMotion motion;
  double scale = 1;
};

/// How an entity really moves, whatever its frames show: by its own velocities, keys and path, and by
/// those of the groups it stands in.
class TrueMotion {
 public:
  /// Needs   a timeline without responses that outlives it; nothing that changes its size.
  /// Cost    each corner that a path passes is a knot: kMostCorners in a frame are many.
  explicit TrueMotion(const Timeline& timeline) : timeline_(&timeline) {}

  /// Times strictly between two at which a motion passes a key or a corner, ascending. `top`: the
  /// group from which it is seen; nullopt for the world.
  std::vector<double> knots(std::uint32_t entity, std::optional<std::uint32_t> top, double from,
                            double to) const;
  /// From one time to another, as cubics of the part gone by.
  /// Needs   no knots between them; both while `frame` is shown, or its end; one time where no frame follows.
  /// Gives   what a path turns is turned at once at its corners.
  Carried between(std::uint32_t entity, std::optional<std::uint32_t> top, unsigned frame,
                  double from, double to) const;

 private:
  const Timeline* timeline_;
};

/// The innermost group both stand in; nullopt where there is none.
std::optional<std::uint32_t> group_of_both(const Scene& scene, std::uint32_t a, std::uint32_t b);

/// Whether an entity stands in this very group, and keeps one velocity in it as long as the scene goes.
bool keeps_velocity_in(const Scene& scene, std::uint32_t entity, std::uint32_t group);

/// About how many corners of a closed path a motion passes in a frame; 0 for less than a round.
double corners_a_frame(const Scene& scene, const Motion& motion);
inline constexpr double kMostCorners = 1 << 16;

/// A box around all places of a motion for t in [0, 1].
Bounds box_around(const RigidMotion& motion);

}  // namespace flatray
