#pragma once
#include "trace/kernels/walk.h"

// Rays and straight walls on whole numbers: plain data, as in lanes.h.
//
// Ends of walls are multiples of u, a power of two, in a box of sides up to 2^25 u; origins are such,
// too, no more than 2^24 u beside the box; directions are multiples of some v up to 2^26 v. Then
// differences W, V of two points are whole and at most 2^26 u, products at most 2^52 of their unit,
// and differences of two products, as the sides d x W, d x V, their difference d x (B - A), W x V,
// d.W and d.d, at most 2^53: whole numbers, which doubles hold. So signs are exact, zeros included, and
// t, a quotient of two of them, is rounded once. With u and v between 2^-200 and 2^200 products of two
// such neither overflow nor lose digits.
namespace flatray::lanes {

/// Where whole origins lie.
struct WholeBox {
  double low_x, low_y;    ///< of the box of the walls
  double reach;           ///< 2^24 u
  double side_x, side_y;  ///< of the box, and `reach` more
  double round;           ///< 1.5 * 2^52 u: w + round - round is the multiple of u nearest to w
};

/// Straight walls by number.
struct WholeWallList {
  const double* ends;  ///< ax, ay, bx, by of each
  int count;
};

/// By ray: t and number of the first wall, and whether it is met between its ends: the product of
/// its sides, else 0. Infinity, -1 and 0 where there is none.
struct WholeHits {
  double *t, *wall, *sides;
};

struct WholeKernels {
  /// 1 for each ray that is whole, else 0. One without direction never is.
  void (*hold)(const WholeBox&, const Rays&, double* whole);
  /// `left`: number of the wall each ray has just left, or -1. Needs rays that are whole.
  void (*scan)(const WholeWallList&, const Rays&, const double* left, const WholeHits&);
};

}  // namespace flatray::lanes
