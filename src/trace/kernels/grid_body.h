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

// Where rays end, in cells.
void set_ends(const Grid& grid, const Walking& walking, int i, Real end) {
  const Real off = size(end) * all(0x1p-22) + all(2 * static_cast<double>(grid.unit));
  store_single(walking.end_low + i, end - off);
  store_single(walking.end_high + i, end + off);
}

void prepare(const Grid& grid, const Rays& rays, const Walking& walking, int* fate) {
  const Real one = all(1), least = all(kLeastStep), zero = all(0);
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    Placed r;
    r.x = (load(rays.ox + i) - all(grid.centre_x)) * all(grid.scale_x);
    r.y = (load(rays.oy + i) - all(grid.centre_y)) * all(grid.scale_y);
    const Real dx = load(rays.dx + i) * all(grid.scale_x);
    const Real dy = load(rays.dy + i) * all(grid.scale_y);
    const Real square = dx * dx + dy * dy, far = all(grid.far);
    const Mask able = both(both(less(all(kLeastSquare), square), less(square, all(kLargestSquare))),
                           both(less(size(r.x), far), less(size(r.y), far)));
    const Real length = choose(able, root(square), one);
    r.x = choose(able, r.x, all(grid.ring_x));
    r.y = choose(able, r.y, all(grid.ring_y));
    const Real shrink = one / length;
    const Real ux = choose(able, dx * shrink, one), uy = choose(able, dy * shrink, zero);
    r.dx = choose(less(size(ux), least), with_sign_of(least, ux), ux);
    r.dy = choose(less(size(uy), least), with_sign_of(least, uy), uy);
    bring_in(grid, r);
    store_single(walking.ox + i, r.x);
    store_single(walking.oy + i, r.y);
    store_single(walking.dx + i, r.dx);
    store_single(walking.dy + i, r.dy);
    const Real size_x = size(r.dx), size_y = size(r.dy), inverse = one / (size_x * size_y);
    store_single(walking.inverse_x + i, size_y * inverse);
    store_single(walking.inverse_y + i, size_x * inverse);
    if (walking.up_to != nullptr)
      set_ends(grid, walking, i, load(walking.up_to + i) * length - r.skipped);
    double doubt[FLATRAY_LANES];
    store(doubt, choose(able, zero, all(kDoubt)));
    for (int k = 0; k < FLATRAY_LANES; ++k) fate[i + k] = static_cast<int>(doubt[k]);
  }
}

// t of the walls found.
void finish(const Rays& rays, const Finish& walls) {
  for (int i = 0; i < rays.count; i += FLATRAY_LANES)
    store(walls.t + i, crossing_time({load(rays.ox + i), load(rays.oy + i), load(rays.dx + i),
                                      load(rays.dy + i)},
                                     fetch_ends(walls.ends, walls.slots + i)));
}
