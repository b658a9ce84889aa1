#pragma once
#include "trace/kernels/walk.h"

// What the kernels take and give: plain data only, so that nothing compiled for one instruction-set
// tier can be picked by the linker for another.
//
// The kernels cull. They work in plain doubles with an error bound for the whole ray, and say
// "sure" only where the bound proves it; every other ray is decided again by the exact code. So
// every tier gives the same answers.
//
// The bounds, with u = 2^-53, W = A - o and V = B - o for the segment A, B, and X, Y at least the
// largest |W_x|, |W_y| as computed (rounding is monotone, so the box of all ends gives them). A
// difference has an error of u of its computed size, a product u of its own and 2^-1075 where it
// underflows.
//   side      s_A = d x W      error <= 3 u S, S = |d_x| Y + |d_y| X; E = 4 u S + 2^-1070
//   denominator D = s_B - s_A  error <= 8 u S (two sides and one difference below 2 S); 4 E
//   numerator N = W x V        error <= 8 u X Y; F = 16 u X Y + 2^-1070
// t = N / D. What E and F have beyond the proven error pays for rounding the bounds and the
// quotients themselves. An infinity or NaN makes every comparison that would be "sure" false.
namespace flatray::lanes {

inline constexpr int kWidest = 8;  ///< lanes of the widest tier; ray counts are multiples of it

struct Rays {
  const double *ox, *oy, *dx, *dy;
  const double* left;  ///< slot of the segment just left, or -1
  int count;
};

struct Walls {
  const double* ends;  ///< ax, ay, bx, by of each segment
  int count;
  double low_x, low_y, high_x, high_y;  ///< box of all ends
};

/// By ray: the slot of the segment that surely is the first met, between its ends and at t > 0;
/// kNothing: surely none; kDoubtful: to be decided.
struct Nearest {
  double* slot;
};
inline constexpr double kNothing = -1, kDoubtful = -2;

struct Polygon {
  const double* vertices;  ///< x, y of each, `count` of them and the first again
  int count;
  double low_x, low_y, high_x, high_y;  ///< box of them
};

/// By ray: the edges at which the vertices surely change from the left to the right of its line and
/// back, all others surely being beside it. kMissed: the line passes beside the polygon. kUnsure in
/// `down`: to be decided.
struct Clip {
  double *down, *up;
};
inline constexpr double kMissed = -1, kUnsure = -2;

struct Kernels {
  void (*nearest)(const Walls&, const Rays&, const Nearest&);
  void (*clip)(const Polygon&, const Rays&, const Clip&);
  GridKernels grid;
};

namespace portable {
extern const Kernels kKernels;
}
namespace baseline {
extern const Kernels kKernels;
}
namespace avx2 {
extern const Kernels kKernels;
}
namespace avx512 {
extern const Kernels kKernels;
}

}  // namespace flatray::lanes
