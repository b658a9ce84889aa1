// What comes before and after the walk, in double precision, written once over the lanes of
// vector.h: rays into the coordinates of the grid, and t of the walls found.
#include "trace/kernels/quotient_body.h"

struct Placed {
  Real x, y, dx, dy, skipped;  // of its way, before it enters the grid
};

// Starts rays from beyond the grid where they enter it, in the ring where they pass by.
void bring_in(const Grid& grid, Placed& r) {
  const Real half_x = all(grid.half_x), half_y = all(grid.half_y), zero = all(0);
  r.skipped = zero;
  if (full(both(less(size(r.x), half_x), less(size(r.y), half_y)))) return;
  const Real side_x = with_sign_of(half_x, r.dx), side_y = with_sign_of(half_y, r.dy);
  const Real into =
      larger(larger((zero - side_x - r.x) / r.dx, (zero - side_y - r.y) / r.dy), zero);
  const Real out = smaller((side_x - r.x) / r.dx, (side_y - r.y) / r.dy);
  const auto inside = [&](Real at, Real half) { return larger(zero - half, smaller(at, half)); };
  const Mask misses = less(out, into), starts_out = less(zero, into);
  const Real x = choose(starts_out, inside(r.x + into * r.dx, half_x), r.x);
  const Real y = choose(starts_out, inside(r.y + into * r.dy, half_y), r.y);
  r.x = choose(misses, all(grid.ring_x), x);
  r.y = choose(misses, all(grid.ring_y), y);
  r.skipped = into;
}

constexpr double kLatest =
    0x1p90;  // beyond all that is met, and sooner than what stands for no hit

// Where rays end, in cells.
void set_ends(const Grid& grid, const Walking& walking, int i, Real end) {
  end = smaller(end, all(kLatest));
  const Real off = size(end) * all(0x1p-22) + all(2 * static_cast<double>(grid.unit));
  store_single(walking.end_low + i, end - off);
  store_single(walking.end_high + i, end + off);
}

// Of the walls just left, what their records begin with.
void mark_departed(const Grid& grid, const Walking& walking, int i) {
  unsigned slot[FLATRAY_LANES];
  int known[FLATRAY_LANES];
  for (int k = 0; k < FLATRAY_LANES; ++k) {
    const bool none = walking.departed[i + k] == kNone;
    slot[k] = none ? 0 : walking.departed[i + k];
    known[k] = none ? 0 : 1;
  }
  const Ends wall = fetch_ends(grid.ends, slot);
  const Mask any = less(all(0), real(known));
  const Real none = all(__builtin_nan(""));
  const auto put = [&](float* to, Real at, double centre, double scale) {
    store_single(to + i, choose(any, (at - all(centre)) * all(scale), none));
  };
  put(walking.departed_ax, wall.ax, grid.centre_x, grid.scale_x);
  put(walking.departed_ay, wall.ay, grid.centre_y, grid.scale_y);
  put(walking.departed_bx, wall.bx, grid.centre_x, grid.scale_x);
}

// Of the curves just left, their slots and roots.
void mark_departed_curves(const Walking& walking, int i) {
  for (int k = i; k < i + FLATRAY_LANES; ++k) {
    walking.departed_ax[k] = __builtin_bit_cast(float, walking.departed[k]);
    walking.departed_ay[k] = static_cast<float>(walking.roots[k]);
    walking.departed_bx[k] = 0;
  }
}

bool prepare(const Grid& grid, const Rays& rays, const Walking& walking, int* fate) {
  const Real one = all(1), least = all(kLeastStep), zero = all(0), far = all(grid.far);
  bool some_unable = false;
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    Placed r;
    r.x = (load(rays.ox + i) - all(grid.centre_x)) * all(grid.scale_x);
    r.y = (load(rays.oy + i) - all(grid.centre_y)) * all(grid.scale_y);
    Real dx = load(rays.dx + i) * all(grid.scale_x);
    Real dy = load(rays.dy + i) * all(grid.scale_y);
    Real square = dx * dx + dy * dy;
    const Mask able = both(both(less(all(kLeastSquare), square), less(square, all(kLargestSquare))),
                           both(less(size(r.x), far), less(size(r.y), far)));
    if (!full(able)) {
      some_unable = true;
      for (int k = 0; k < FLATRAY_LANES; ++k)
        if ((bits(able) >> k & 1U) == 0) fate[i + k] = kDoubt;
      r.x = choose(able, r.x, all(grid.ring_x));
      r.y = choose(able, r.y, all(grid.ring_y));
      square = choose(able, square, one);
      dx = choose(able, dx, one);
      dy = choose(able, dy, zero);
    }
    const Real length = root(square), shrink = one / length;
    const Real ux = dx * shrink, uy = dy * shrink;
    r.dx = choose(less(size(ux), least), with_sign_of(least, ux), ux);
    r.dy = choose(less(size(uy), least), with_sign_of(least, uy), uy);
    bring_in(grid, r);
    store_single(walking.ox + i, r.x);
    store_single(walking.oy + i, r.y);
    store_single(walking.dx + i, r.dx);
    store_single(walking.dy + i, r.dy);
    if (grid.cells != nullptr) {
      const Real size_x = size(r.dx), size_y = size(r.dy), inverse = one / (size_x * size_y);
      store_single(walking.inverse_x + i, size_y * inverse);
      store_single(walking.inverse_y + i, size_x * inverse);
      if (walking.departed != nullptr && grid.curves != nullptr)
        mark_departed_curves(walking, i);
      else if (walking.departed != nullptr)
        mark_departed(grid, walking, i);
    }
    if (walking.up_to != nullptr)
      set_ends(grid, walking, i, load(walking.up_to + i) * length - r.skipped);
  }
  return some_unable;
}

constexpr int kAhead = 128;  // rays whose walls are asked for at once

// The walls that rays have found, any of those that have found none; and asks for their ends.
void ask_for_ends(const Grid& grid, const int* found, int count, unsigned* slot) {
  for (int k = 0; k < count; ++k) {
    slot[k] = found[k] < 0 ? 0 : static_cast<unsigned>(found[k]);
    __builtin_prefetch(grid.ends + 4 * static_cast<long>(slot[k]));
  }
}

// Answers of the rays of a vector; which of them are open.
unsigned answer(const Grid& grid, const Rays& rays, const Finish& f, int i, const unsigned* slot,
                void* to) {
  double word[FLATRAY_LANES];
  for (int k = 0; k < FLATRAY_LANES; ++k) word[k] = __builtin_bit_cast(double, f.met + slot[k]);
  const Real found = real(f.found + i);
  const Real t =
      crossing_time({load(rays.ox + i), load(rays.oy + i), load(rays.dx + i), load(rays.dy + i)},
                    fetch_ends(grid.ends, slot));
  const Mask hit = less(all(kNoRecord), found);
  store_pairs(to, choose(hit, load(word), all(__builtin_bit_cast(double, f.missed))),
              choose(hit, t, all(__builtin_inf())));
  return bits(either(equal(found, all(kDoubt)), but_not(hit, equal(t, t))));
}

int finish(const Grid& grid, const Rays& rays, const Finish& f) {
  unsigned slot[kAhead];
  double last[2 * FLATRAY_LANES];
  int open = 0;
  for (int from = 0; from < rays.count; from += kAhead) {
    const int some = rays.count - from < kAhead ? rays.count - from : kAhead;
    ask_for_ends(grid, f.found + from, some, slot);
    for (int k = 0; k < some; k += FLATRAY_LANES) {
      const int i = from + k, left = f.count - i;
      const bool whole = left >= FLATRAY_LANES;
      char* const to = static_cast<char*>(f.answers) + 16 * static_cast<long>(i);
      unsigned unsure = answer(grid, rays, f, i, slot + k, whole ? to : static_cast<void*>(last));
      if (!whole && left > 0) __builtin_memcpy(to, last, 16 * static_cast<unsigned long>(left));
      for (; unsure != 0; unsure &= unsure - 1)
        if (const int lane = __builtin_ctz(unsure); lane < left) f.open[open++] = i + lane;
    }
  }
  return open;
}

void finish_curves(const Grid& grid, const Rays& rays, const CurvesMet& met) {
  for (int i = 0; i < met.count; i += FLATRAY_LANES) {
    int ray[FLATRAY_LANES], second[FLATRAY_LANES];
    unsigned slot[FLATRAY_LANES];
    for (int k = 0; k < FLATRAY_LANES; ++k) {
      ray[k] = met.rays[i + k < met.count ? i + k : met.count - 1];
      const int found = met.found[ray[k]];
      second[k] = found & kSecond;
      slot[k] = static_cast<unsigned>(found & ~kSecond);
    }
    const RayLanes of = {gather(rays.ox, ray), gather(rays.oy, ray), gather(rays.dx, ray),
                         gather(rays.dy, ray)};
    const Real side = choose(less(all(0), real(second)), all(1), all(-1));
    store(met.t + i, circle_time(of, fetch_ends(grid.ends, slot), side));
  }
}
