#pragma once

// What the kernels of fast orbits take and give: plain data only, so that nothing compiled for one
// instruction-set tier can be picked by the linker for another. They add, subtract, multiply, divide
// and take square roots one by one, so every tier gives the same bits.
namespace flatray::flights {

inline constexpr int kWidest = 8;  ///< lanes of the widest tier; counts of rays are multiples of it

/// Doubles of a wall. Walls are in order of their kind: segments, those of the hull first, arcs of
/// circles, of ellipses; the place of a wall in that order is its slot.
enum Record : int {
  kNormalX,
  kNormalY,
  kOffset,
  kBend,  // segment: n.p = offset; 2 where it reflects, else 0
  kShiftX,
  kShiftY,
  kNextLeft,
  kEvent,  // added to the point, left then, what happens there
  kAlongX,
  kAlongY,
  kMiddle,
  kHalf,  // segment: |along.p - middle| <= half
  kCentreX = 0,
  kCentreY,
  kSquare,  // curve; radius squared of a circle
  kFormXx = 8,
  kFormXy,
  kFormYx,
  kFormYy,  // curve: |form (p - centre)| = 1
  kFromX,
  kFromY,
  kToX,
  kToY,     // arc: signs of these times p - centre
  kExtent,  // whole, or how the signs count
  kRecord = 20
};
inline constexpr double kWhole = 0, kBoth = 1, kEither = 2;

/// What happens at the end of a flight.
inline constexpr double kBounced = 0, kCrossed = 1, kAbsorbed = 2, kNothing = 3, kUnsure = 4;

struct Walls {
  const double* records;
  int hull;  ///< segments with the room on one side of their line, the first ones; normals lead out
  int segments, circles, ellipses;
  /// Places nearer than this to an end, a tangent, another wall or the start are not decided.
  double near;
};

struct Rays {
  double *x, *y, *dx, *dy;
  double* departed;  ///< slot of the wall just left, and a half more inside a curve; -1: none
};

/// Flights of `count` rays whose directions are of length 1.
struct Flights {
  Rays from, to;  ///< `to`: the point on the wall, moved by its shift, and the direction from there
  double *t, *wall, *event, *nx, *ny;  ///< the unit normal is towards the side of the ray
  int count;
};

using Fly = void (*)(const Walls&, const Flights&);

namespace portable {
extern const Fly kFly;
}
namespace baseline {
extern const Fly kFly;
}
namespace avx2 {
extern const Fly kFly;
}
namespace avx512 {
extern const Fly kFly;
}

}  // namespace flatray::flights
