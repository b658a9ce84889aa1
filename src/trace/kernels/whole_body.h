// Rays on whole numbers against every wall, in doubles that round nothing but t: whole.h. Over
// vector.h and quotient_body.h.

inline Mask is_whole(const Real& at, double low, double side, const WholeBox& box) {
  const Real w = at - all(low), round = all(box.round);
  const Mask near = but_not(less(w, all(side)), less(w, all(-box.reach)));
  // An origin of more digits than its distance from the corner has is not found again from it.
  return both(near, both(equal((w + round) - round, w), equal(w + all(low), at)));
}

// With m the greater component, 2^k <= c < 2^(k + 1) and c = 2^28 m: d + c - c is a multiple of
// v = 2^(k - 53), and m < 2^(k - 27) = 2^26 v. No multiple of any v' fails with m < 2^24 v'.
inline Mask is_short(const Real& dx, const Real& dy) {
  const Real most = larger(size(dx), size(dy)), c = most * all(0x1p28);
  const Mask usual = both(less(all(0x1p-170), most), less(most, all(0x1p170)));
  return both(usual, both(equal((dx + c) - c, dx), equal((dy + c) - c, dy)));
}

inline void hold(const WholeBox& box, const Rays& rays, double* whole) {
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    const Mask origin = both(is_whole(load(rays.ox + i), box.low_x, box.side_x, box),
                             is_whole(load(rays.oy + i), box.low_y, box.side_y, box));
    const Mask direction = is_short(load(rays.dx + i), load(rays.dy + i));
    store(whole + i, choose(both(origin, direction), all(1), all(0)));
  }
}

struct WholeBest {
  Real t = all(__builtin_inf()), numer = all(0), denom = all(1);
  Real wall = all(-1), sides = all(0);
};

inline void meet(const double* ends, int number, const Real& left, const RayLanes& r,
                 WholeBest& best) {
  const Real zero = all(0), ax = all(ends[0]) - r.ox, ay = all(ends[1]) - r.oy;
  const Real bx = all(ends[2]) - r.ox, by = all(ends[3]) - r.oy;
  const Real side_a = r.dx * ay - r.dy * ax, side_b = r.dx * by - r.dy * bx;
  const Real sides = side_a * side_b;
  const Mask beside = less(zero, sides);
  if (full(beside)) return;
  const Real across = side_b - side_a, ahead = ax * by - ay * bx;
  Real numer = choose(less(across, zero), zero - ahead, ahead), denom = size(across);
  const Mask parallel = equal(across, zero);
  if (!full(less(zero, denom))) {  // on the line: met at the nearer end, or at once
    const Real at_a = r.dx * ax + r.dy * ay, at_b = r.dx * bx + r.dy * by;
    const Real along =
        choose(less(larger(at_a, at_b), zero), all(-1), larger(smaller(at_a, at_b), zero));
    numer = choose(parallel, along, numer);
    denom = choose(parallel, r.dx * r.dx + r.dy * r.dy, denom);
  }
  const Mask out = either(either(beside, less(numer, zero)), equal(left, all(number)));
  const Real t = numer / denom;
  Mask closer = but_not(less(t, best.t), out);
  const Mask tie = but_not(equal(t, best.t), out);
  if (!full(
          but_not(equal(zero, zero), tie))) {  // rounding keeps order: which is the lesser quotient
    const Pair a = product(numer, best.denom), b = product(best.numer, denom);
    const Mask less_by_low = both(equal(a.high, b.high), less(a.low, b.low));
    closer = either(closer, both(tie, either(less(a.high, b.high), less_by_low)));
  }
  best.t = choose(closer, t, best.t);
  best.numer = choose(closer, numer, best.numer);
  best.denom = choose(closer, denom, best.denom);
  best.wall = choose(closer, all(number), best.wall);
  best.sides = choose(closer, sides, best.sides);
}

inline void scan(const WholeWallList& walls, const Rays& rays, const double* left,
                 const WholeHits& hits) {
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    const RayLanes r = {load(rays.ox + i), load(rays.oy + i), load(rays.dx + i), load(rays.dy + i)};
    const Real left_of = load(left + i);
    WholeBest best;
    for (int k = 0; k < walls.count; ++k)
      meet(walls.ends + 4 * static_cast<long>(k), k, left_of, r, best);
    store(hits.t + i, best.t + all(0));  // never -0
    store(hits.wall + i, best.wall);
    store(hits.sides + i, best.sides);
  }
}
