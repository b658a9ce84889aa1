// The kernels themselves, written once over `Real` and `Mask`. Each tier's file includes this with FLATRAY_TIER and
// FLATRAY_LANES set. Bounds and meaning of the results: lanes.h.
#include "trace/kernels/lanes.h"

namespace flatray::lanes::FLATRAY_TIER {
namespace {

#include "trace/kernels/vector.h"

constexpr double kNoEdge = -1;  // the end of the range asked for
constexpr double kInfinite = __builtin_inf();
constexpr double kUnderflow = 0x1p-1070;               // more than all underflowing products of a term lose
constexpr double kLargest = 0x1p1000, kLeast = 0x1p-1000;  // outside, a bound could itself over- or underflow

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
  const Mask bounded = both(both(possible, m.crossing),
                            both(less(all(kLeast), low), less(high, all(kInfinite))));
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
  const Mask out = either(either(missed, equal(left, all(k))),
                          both(m.crossing, either(behind, farther)));
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
    store(found.high + i, best.high);
  }
}

// One end of a hit interval: the greatest t seen, in [low, high], its edge, and the most any other edge could have.
// The far end is kept with its sign turned, so that it too is a greatest.
struct End {
  Real low, high, edge = all(kNoEdge), other = all(-kInfinite);
  explicit End(double range_end) : low(all(range_end)), high(all(range_end)) {}
  void offer(Mask given, Real new_low, Real new_high, int k) {
    const Mask beyond = both(given, less(low, new_low));
    const Real loser = choose(beyond, high, new_high);
    other = choose(both(given, less(other, loser)), loser, other);
    edge = choose(beyond, all(k), edge);
    low = choose(beyond, new_low, low);
    high = choose(beyond, new_high, high);
  }
};

// A clip in progress: how far it is decided, and where the origins lie.
struct Clipping {
  End enter, exit;
  Mask none, unsure, missed, outside;
  explicit Clipping(const Polygon& p) : enter(p.low), exit(-p.high) {
    none = less(all(0), all(0));
    unsure = missed = outside = none;
  }
};

// Rays surely parallel to an edge: both along the same axis.
Mask parallel(const Group& g, const double* a) {
  const Mask none = less(all(0), all(0));
  const Mask level = a[1] == a[3] ? equal(g.dy, all(0)) : none;
  return either(level, a[0] == a[2] ? equal(g.dx, all(0)) : none);
}

void clip_edge(const Group& g, const Polygon& p, int k, const Seen& a, const Seen& b, Clipping& c) {
  const Real d = (b.side - a.side) * all(p.turn), n = (a.x * b.y - a.y * b.x) * all(p.turn);
  const Real width = size(d), height = size(n);
  const Mask certain = less(g.numerator, height), negative = less(n, all(0));
  const Mask entering = less(d, all(0)), along = parallel(g, p.vertices + 2 * k);
  const Real least = (height - g.numerator) / (width + g.denominator);
  const Real most = (height + g.numerator) / (width - g.denominator);
  const Mask bounded = both(both(certain, less(g.denominator, width)),
                            both(less(all(kLeast), least), less(most, all(kInfinite))));
  const Mask crossing = but_not(bounded, along);
  // t has the sign of n d; the far end turns it once more, so that both ends have the sign opposite to n.
  const Real low = choose(negative, least, all(0) - most), high = choose(negative, most, all(0) - least);
  c.enter.offer(both(crossing, entering), low, high, k);
  c.exit.offer(but_not(crossing, entering), low, high, k);
  c.outside = either(c.outside, both(certain, negative));
  c.missed = either(c.missed, both(along, both(certain, negative)));
  c.unsure = either(c.unsure, but_not(equal(all(0), all(0)), either(crossing, both(along, certain))));
}

void store_clip(const Clipping& c, int i, const Clip& result) {
  // What is missed for sure stays so whatever an unsure edge would add.
  const Mask missed = either(c.missed, less(all(0) - c.exit.low, c.enter.low));
  const Mask ends = both(less(c.enter.other, c.enter.low), less(c.exit.other, c.exit.low));
  const Mask sure = but_not(both(ends, less(c.enter.high, all(0) - c.exit.high)), c.unsure);
  const Real verdict = choose(sure, c.enter.edge, all(kUnsure));
  store(result.enter + i, choose(missed, all(kMissed), verdict));
  store(result.exit + i, c.exit.edge);
  store(result.start + i, choose(c.outside, all(0), all(1)));
}

void clip(const Polygon& polygon, const Rays& rays, const Clip& result) {
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    const Group g = load_group(rays, i, polygon);
    Clipping c(polygon);
    c.unsure = both(equal(g.dx, all(0)), equal(g.dy, all(0)));
    Seen a = see(g, polygon.vertices[0], polygon.vertices[1]);
    for (int k = 0; k < polygon.count; ++k) {
      const Seen b = see(g, polygon.vertices[2 * k + 2], polygon.vertices[2 * k + 3]);
      clip_edge(g, polygon, k, a, b, c);
      a = b;
    }
    store_clip(c, i, result);
  }
}

}  // namespace

extern const Kernels kKernels;
const Kernels kKernels = {&nearest, &clip};

}  // namespace flatray::lanes::FLATRAY_TIER
