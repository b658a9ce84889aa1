#pragma once
#include <array>
#include <vector>

#include "geom/ray.h"

namespace flatray::oracle {

/// What a core is carried by: R(angle) (x, y), each c[0] + c[1] t + c[2] t^2 + c[3] t^3.
struct CoreSwing {
  std::array<double, 4> x, y, angle;
};

/// A convex core with all points within `radius` of it: vertex p is at + t * velocity + R(angle + t *
/// spin) p, and what its swings add.
struct TurningCore {
  std::vector<Vec2> ring;
  double radius;
  Vec2 at, velocity;
  double angle, spin;
  std::array<double, 2> angle_bends{0, 0};  ///< what t^2 and t^3 add to the angle
  std::vector<CoreSwing> swings{};
};

/// When two turning bodies first touch within [0, length].
struct FirstTouch {
  enum class Kind { none, touch, unknown } kind;  ///< unknown: they graze too closely
  double low, high;                               ///< apart before; touching at high
};

/// How two such bodies lie at time t: 1 apart, -1 with a point in common. In 256 bits.
int apart_at(const TurningCore& a, const TurningCore& b, double t);

/// Needs   sizes about 1.
/// Source  steps of distance over greatest speed, in doubles down to 1e-9, then bisection by apart_at
///         to neighbouring doubles; sines by their series. Distances of vertices from sides and points
///         inside: no separating axis, no bound of curvature.
/// Cost    about a ms.
FirstTouch first_touch(const TurningCore& a, const TurningCore& b, double length);

}  // namespace flatray::oracle
