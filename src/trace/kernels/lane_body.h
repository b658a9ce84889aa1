// The kernels themselves, written once over `Real` and `Mask`. Each tier's file includes this with
// FLATRAY_TIER and FLATRAY_LANES set. Bounds and meaning of the results: lanes.h.
#include "trace/kernels/lanes.h"

namespace flatray::lanes::FLATRAY_TIER {
namespace {

#include "trace/kernels/vector.h"

constexpr double kNoEdge = -1;  // the end of the range asked for
constexpr double kInfinite = __builtin_inf();
constexpr double kUnderflow = 0x1p-1070;  // more than all underflowing products of a term lose
constexpr double kLargest = 0x1p1000,
                 kLeast = 0x1p-1000;  // outside, a bound could itself over- or underflow

Real abs_larger(Real a, Real b) { return larger(size(a), size(b)); }

// A group of rays with the error bounds of each.
struct Group {
  Real ox, oy, dx, dy;
  Real side, denominator, numerator;  // errors of s_A and s_B, of D, of N
};

template <class Walls>
Group load_group(const Rays& rays, int i, const Walls& walls) {
  Group g;
  g.ox = load(rays.ox + i);
  g.oy = load(rays.oy + i);
  g.dx = load(rays.dx + i);
  g.dy = load(rays.dy + i);
  const Real x = abs_larger(all(walls.low_x) - g.ox, all(walls.high_x) - g.ox);
  const Real y = abs_larger(all(walls.low_y) - g.oy, all(walls.high_y) - g.oy);
  const Real s = size(g.dx) * y + size(g.dy) * x, xy = x * y;
  const Real never = all(kInfinite), underflow = all(kUnderflow);
  g.side = choose(less(s, all(kLargest)), s * all(0x1p-51) + underflow, never);
  g.denominator = g.side * all(4);
  g.numerator = choose(less(xy, all(kLargest)), xy * all(0x1p-49) + underflow, never);
  return g;
}

// A point as seen from the origins, and the side of the rays it lies on.
struct Seen {
  Real x, y, side;
};
Seen see(const Group& g, double x, double y) {
  Seen p;
  p.x = all(x) - g.ox;
  p.y = all(y) - g.oy;
  p.side = g.dx * p.y - g.dy * p.x;
  return p;
}

// How the lines of the rays meet the line of one segment: |D|, and N with the sign of D taken off.
struct Meeting {
  Real size, ahead;
  Mask crossing;  // D surely not zero
};
Meeting meet(const Group& g, const Seen& a, const Seen& b) {
  const Real d = b.side - a.side, n = a.x * b.y - a.y * b.x;
  Meeting m;
  m.size = size(d);
  m.ahead = choose(less(d, all(0)), all(0) - n, n);
  m.crossing = less(g.denominator, m.size);
  return m;
}

// Best sure hit so far, t in [low, high], and the least t any other wall not ruled out could have.
struct Best {
  Real slot = all(kNothing), low = all(kInfinite), high = all(kInfinite), other = all(kInfinite);
};

// Walls that one side or their distance does not rule out: kept as best, or for their lower bound.
void keep(const Group& g, const Meeting& m, Mask possible, Mask inside, int k, Best& best) {
  const Real low = (m.ahead - g.numerator) / (m.size + g.denominator);
  const Real high = (m.ahead + g.numerator) / (m.size - g.denominator);
  const Mask bounded =
      both(both(possible, m.crossing), both(less(all(kLeast), low), less(high, all(kInfinite))));
  const Mask closer = both(both(bounded, inside), less(high, best.high));
  const Real loser = choose(closer, best.low, choose(bounded, low, all(-1)));
  best.other = choose(both(possible, less(loser, best.other)), loser, best.other);
  best.slot = choose(closer, all(k), best.slot);
  best.low = choose(closer, low, best.low);
  best.high = choose(closer, high, best.high);
}

void against(const Group& g, Real left, const double* ends, int k, Best& best) {
  const Seen a = see(g, ends[0], ends[1]), b = see(g, ends[2], ends[3]);
  const Real lower = smaller(a.side, b.side), upper = larger(a.side, b.side);
  const Real minus_side = all(0) - g.side;
  const Mask missed = either(less(g.side, lower), less(upper, minus_side));
  if (full(missed)) return;
  const Meeting m = meet(g, a, b);
  const Mask behind = less(m.ahead, all(0) - g.numerator);
  const Mask farther = less(best.high * (m.size + g.denominator), m.ahead - g.numerator);
  const Mask out =
      either(either(missed, equal(left, all(k))), both(m.crossing, either(behind, farther)));
  if (full(out)) return;
  const Mask inside = both(less(lower, minus_side), less(g.side, upper));
  keep(g, m, but_not(equal(all(0), all(0)), out), inside, k, best);
}

void nearest(const Walls& walls, const Rays& rays, const Nearest& found) {
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    const Group g = load_group(rays, i, walls);
    const Real left = load(rays.left + i);
    Best best;
    for (int k = 0; k < walls.count; ++k) against(g, left, walls.ends + 4 * k, k, best);
    const Real unsure = choose(less(best.other, all(kInfinite)), all(kDoubtful), all(kNothing));
    store(found.slot + i, choose(less(best.high, best.other), best.slot, unsure));
  }
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
    const Real left = g.side, right = all(0) - g.side;
    Crossings c;
    Real a = see(g, polygon.vertices[0], polygon.vertices[1]).side;
    for (int k = 0; k < polygon.count; ++k) {
      const Real b = see(g, polygon.vertices[2 * k + 2], polygon.vertices[2 * k + 3]).side;
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
#include "trace/kernels/walk_body.h"
}  // namespace single

}  // namespace

extern const Kernels kKernels;
const Kernels kKernels = {&nearest, &clip, {&prepare, &single::walk, &finish}};

}  // namespace flatray::lanes::FLATRAY_TIER
