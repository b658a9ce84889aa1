#pragma once

// What the kernels that look at many pairs first take and give: plain data only, as in sweep.h.
namespace flatray::sight {

/// Pairs of shapes that move, as they lie in memory: of the first its two shapes, as numbers, and
/// both velocities, x and y; each next one is `stride` bytes on.
struct Pairs {
  const unsigned* shapes;
  const double* moves;
  long stride;
};

/// Boxes: x and y of the centre of each shape, then how far the farthest vertex is from it along
/// each, or more; NaN where it is none for the lanes, which is near all. For t in [0, length]:
/// `near` is 0 where both certainly never touch, else 1. Room for as many as the next multiple of
/// kLanes.
using Kernel = void (*)(const double* boxes, double length, const Pairs& pairs, int count,
                        double* near);
inline constexpr int kLanes = 8;

}  // namespace flatray::sight
