#pragma once
#include <optional>

#include "geom/hit_interval.h"
#include "geom/primitives/arc.h"
#include "oracle/surd.h"
#include "trace/rays.h"

namespace flatray::oracle {

/// Where a ray meets a wall, as tracers must answer.
template <class Time>
struct WallHitOf {
  Time t;
  HitClass kind;
  Root root;
  bool at_end;
};
using WallHit = WallHitOf<Surd>;

/// Where a ray first meets a straight wall at t >= 0: both as parametric segments, in rationals.
std::optional<WallHit> first_wall_hit(const Ray& ray, const Segment& wall);

/// Where it first meets a curved one.
///
/// Source  the ray in the frame where the curve is a circle about 0: of an ellipse, whose
///         half-diameters are the axes of that frame, the unit circle. The foot of the
///         perpendicular, half the chord about it, and angles from one end of the arc in quarters
///         of a turn; all in rationals and one square root.
/// Cost    some 30 us.
std::optional<WallHit> first_wall_hit(const Ray& ray, const Arc& arc);

/// Where the line of a ray meets the whole curve of a wall in one of its roots: the first, or for
/// any other `root` the second. Nothing where it passes by.
///
/// Needs   a direction that is not zero.
std::optional<Surd> root_of(const Ray& ray, const Ellipse& curve, Root root);

}  // namespace flatray::oracle
