// The kernels themselves, written once over `Real` and `Mask`. Each tier's file includes this with
// FLATRAY_TIER and FLATRAY_LANES set. Bounds and meaning of the results: lanes.h.
#include "trace/kernels/lanes.h"

namespace flatray::lanes::FLATRAY_TIER {
namespace {

#include "trace/kernels/vector.h"

constexpr double kInfinite = __builtin_inf();
constexpr double kUnderflow = 0x1p-1070;  // more than all underflowing products of a term lose
constexpr double kLargest = 0x1p1000;     // above, a bound could itself overflow

Real abs_larger(Real a, Real b) { return larger(size(a), size(b)); }

// A group of rays, and what the side of a vertex may be off by.
struct Group {
  Real ox, oy, dx, dy, error;
};

Group load_group(const Rays& rays, int i, const Polygon& polygon) {
  Group g;
  g.ox = load(rays.ox + i);
  g.oy = load(rays.oy + i);
  g.dx = load(rays.dx + i);
  g.dy = load(rays.dy + i);
  const Real x = abs_larger(all(polygon.low_x) - g.ox, all(polygon.high_x) - g.ox);
  const Real y = abs_larger(all(polygon.low_y) - g.oy, all(polygon.high_y) - g.oy);
  const Real s = size(g.dx) * y + size(g.dy) * x;
  g.error = choose(less(s, all(kLargest)), s * all(0x1p-51) + all(kUnderflow), all(kInfinite));
  return g;
}

// The side of the rays a point lies on.
Real side_of(const Group& g, double x, double y) {
  return g.dx * (all(y) - g.oy) - g.dy * (all(x) - g.ox);
}

// The line of a ray crosses a convex ring where its vertices change sides: one edge down, from left
// to right, and one up. Any vertex not surely beside the line leaves the ray unsure.
struct Crossings {
  Real down = all(kMissed), up = all(kMissed);
  Mask sure = equal(all(0), all(0));
};

void clip(const Polygon& polygon, const Rays& rays, const Clip& result) {
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    const Group g = load_group(rays, i, polygon);
    const Real left = g.error, right = all(0) - g.error;
    Crossings c;
    Real a = side_of(g, polygon.vertices[0], polygon.vertices[1]);
    for (int k = 0; k < polygon.count; ++k) {
      const Real b = side_of(g, polygon.vertices[2 * k + 2], polygon.vertices[2 * k + 3]);
      const Mask b_right = less(b, right), b_left = less(left, b);
      c.sure = both(c.sure, either(b_left, b_right));
      c.down = choose(both(less(left, a), b_right), all(k), c.down);
      c.up = choose(both(less(a, right), b_left), all(k), c.up);
      a = b;
    }
    store(result.down + i, choose(c.sure, c.down, all(kUnsure)));
    store(result.up + i, c.up);
  }
}

#include "trace/kernels/grid_body.h"

namespace single {
// Each over the former.
// clang-format off
#include "trace/kernels/single_moves.h"
#include "trace/kernels/group_body.h"
#include "trace/kernels/judge_body.h"
#include "trace/kernels/curve_body.h"
#include "trace/kernels/walk_body.h"
#include "trace/kernels/scan_body.h"
#include "trace/kernels/packet_body.h"
// clang-format on
}  // namespace single

// One ray alone in doubles, and records in lanes: of a list in all, of a cell in four.
namespace list {
#include "trace/kernels/candidates_body.h"
}  // namespace list
#if FLATRAY_LANES > 1
#define FLATRAY_RECORD_LANES 2
#else
#define FLATRAY_RECORD_LANES 1
#endif
#undef FLATRAY_LANES
#define FLATRAY_LANES FLATRAY_RECORD_LANES
namespace records {
#include "trace/kernels/candidates_body.h"
}  // namespace records
#undef FLATRAY_LANES
#define FLATRAY_LANES 1
namespace single_curve {
// clang-format off
#include "trace/kernels/single_moves.h"
#include "trace/kernels/group_body.h"
#include "trace/kernels/curve_body.h"
// clang-format on
}  // namespace single_curve
namespace single_ray {
#include "trace/kernels/single_ray_body.h"
}  // namespace single_ray

}  // namespace

extern const Kernels kKernels;
const Kernels kKernels = {
    &clip,
    {&prepare, &single::walk, &single::scan, &finish, &finish_curves, &single_ray::nearest,
     &single_ray::nearest_curve, &single_ray::visit_lists}};

}  // namespace flatray::lanes::FLATRAY_TIER
