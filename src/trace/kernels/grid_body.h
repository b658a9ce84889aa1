// What comes before and after the walk, in double precision, written once over the lanes of
// vector.h: rays into the coordinates of the grid, and t of the walls found.

struct Placed {
  Real x, y, dx, dy;
};

// Starts rays from beyond the grid where they enter it, in the ring where they pass by.
void bring_in(const Grid& grid, Placed& r) {
  const Real half_x = all(grid.half_x), half_y = all(grid.half_y), zero = all(0);
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
    const Real ux = choose(able, dx / length, one), uy = choose(able, dy / length, zero);
    r.dx = choose(less(size(ux), least), with_sign_of(least, ux), ux);
    r.dy = choose(less(size(uy), least), with_sign_of(least, uy), uy);
    bring_in(grid, r);
    store_single(walking.ox + i, r.x);
    store_single(walking.oy + i, r.y);
    store_single(walking.dx + i, r.dx);
    store_single(walking.dy + i, r.dy);
    store_single(walking.inverse_x + i, one / size(r.dx));
    store_single(walking.inverse_y + i, one / size(r.dy));
    double doubt[FLATRAY_LANES];
    store(doubt, choose(able, zero, all(kDoubt)));
    for (int k = 0; k < FLATRAY_LANES; ++k) fate[i + k] = static_cast<int>(doubt[k]);
  }
}

// An unevaluated sum; `low` is what rounding to `high` left out.
struct Pair {
  Real high, low;
};
Pair difference(Real a, Real b) {
  const Real d = a - b, from_b = d - a;
  return {d, (a - (d - from_b)) - (b + from_b)};
}
// Halves of 26 bits, whose products are exact. Source: Veltkamp, Dekker.
Pair halves(Real a) {
  const Real c = a * all(0x1p27 + 1), high = c - (c - a);
  return {high, a - high};
}
Pair product(Real a, Real b) {
  const Real p = a * b;
  const Pair x = halves(a), y = halves(b);
  return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

// A number known to 2^-100 of `terms`.
struct Known {
  Pair value;
  Real terms;
};
// a x b. Of the low parts: each of nine terms is at most 2 u of the products and is rounded some
// eight times by u, what is left out is u^2 of them; 64 u^2 = 2^-100 covers it.
inline Known cross(const Pair& ax, const Pair& ay, const Pair& bx, const Pair& by) {
  const Pair p = product(ax.high, by.high), q = product(ay.high, bx.high);
  const Pair high = difference(p.high, q.high);
  const Real mixed = (ax.high * by.low + ax.low * by.high) - (ay.high * bx.low + ay.low * bx.high);
  return {{high.high, high.low + (p.low - q.low) + mixed}, size(p.high) + size(q.high)};
}

// N / D rounded once, NaN where it is not certain which way. With q1 = N / D as far as the high
// parts say and q2 the rest, q1 + q2 is off by what N, D and the remainder are, over D, and by
// what D is off by in q2; twice that is allowed for. Products may underflow only far below the
// bound. Infinities make NaNs, and no comparison holds.
inline Real quotient(const Known& n, const Known& d) {
  const Real inverse = all(1) / d.value.high, q1 = n.value.high * inverse;
  const Pair p = product(q1, d.value.high);
  const Real high = n.value.high - p.high, carried = q1 * d.value.low;
  const Real rest = (high - p.low) + (n.value.low - carried);
  const Real rest_terms = size(high) + size(p.low) + size(n.value.low) + size(carried);
  const Real divisor = size(inverse), q2 = rest * inverse;
  const Real known = (n.terms + size(q1) * d.terms) * all(0x1p-99) + rest_terms * all(0x1p-50);
  const Real reach =
      known * divisor + size(q2) * (all(0x1p-49) + all(4) * size(d.value.low) * divisor);
  const Real sum = q1 + q2, low = q2 - (sum - q1);
  const Mask normal = both(both(less(all(0x1p-800), n.terms), less(all(0x1p-800), d.terms)),
                           both(less(all(0x1p-800), sum), less(sum, all(0x1p900))));
  const Mask certain = both(equal(sum + (low + reach), sum), equal(sum + (low - reach), sum));
  const Mask small = both(less(size(d.value.low) * divisor, all(0x1p-3)), less(size(q2), size(q1)));
  return choose(both(both(normal, certain), small), sum, all(__builtin_nan("")));
}

// t = ((a - o) x (b - a)) / (d x (b - a)).
void finish(const Rays& rays, const Finish& walls) {
  const Real zero = all(0);
  for (int i = 0; i < rays.count; i += FLATRAY_LANES) {
    const Ends e = fetch_ends(walls.ends, walls.slots + i);
    const Pair ex = difference(e.bx, e.ax), ey = difference(e.by, e.ay);
    const Pair wx = difference(e.ax, load(rays.ox + i)), wy = difference(e.ay, load(rays.oy + i));
    const Pair dx = {load(rays.dx + i), zero}, dy = {load(rays.dy + i), zero};
    store(walls.t + i, quotient(cross(wx, wy, ex, ey), cross(dx, dy, ex, ey)));
  }
}
