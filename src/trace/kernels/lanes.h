#pragma once
#include "trace/kernels/walk.h"

// What the kernels take and give: plain data only, so that nothing compiled for one instruction-set
// tier can be picked by the linker for another.
//
// The kernels cull, and say "sure" only where a bound proves it; every other ray is decided again
// by the exact code. So every tier gives the same answers. The kernel for polygons works in doubles
// with one bound for the whole ray; those for walls work in floats (walk.h).
//
// Of a polygon the bound is, with u = 2^-53, W = A - o for a vertex A, and X, Y at least the largest
// |W_x|, |W_y| as computed (rounding is monotone, so the box of all vertices gives them): a
// difference has an error of u of its computed size, a product u of its own and 2^-1075 where it
// underflows, so that d x W is off by at most 3 u S, S = |d_x| Y + |d_y| X. 4 u S + 2^-1070 pays for
// rounding the bound itself. An infinity or NaN makes every comparison that would be "sure" false.
namespace flatray::lanes {

inline constexpr int kWidest = 8;  ///< lanes of the widest tier; ray counts are multiples of it

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
  void (*clip)(const Polygon&, const Rays&, const Clip&);
  WalkKernels walk;
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
