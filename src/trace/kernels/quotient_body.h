// Quotients of differences of products, rounded once: double-double over the lanes of vector.h.

// An unevaluated sum; `low` is what rounding to `high` left out.
struct Pair {
  Real high, low;
};
Pair difference(Real a, Real b) {
  const Real d = a - b, from_b = d - a;
  return {d, (a - (d - from_b)) - (b + from_b)};
}
#ifdef __FMA__
Pair product(Real a, Real b) {
  const Real p = a * b;
  return {p, fused_difference(a, b, p)};
}
#else
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
#endif

// A number known to 2^-100 of `terms`. Its high part alone may be 0, or of the other sign.
struct Known {
  Pair value;
  Real terms;

  Real rounded() const { return value.high + value.low; }
};
// a x b. Of the low parts: each of nine terms is at most 2 u of the products and is rounded some
// eight times by u, what is left out is u^2 of them; 64 u^2 = 2^-100 covers it.
inline Known cross(const Pair& ax, const Pair& ay, const Pair& bx, const Pair& by) {
  const Pair p = product(ax.high, by.high), q = product(ay.high, bx.high);
  const Pair high = difference(p.high, q.high);
  const Real mixed =
      fused(ax.high, by.low, ax.low * by.high) - fused(ay.high, bx.low, ay.low * bx.high);
  return {{high.high, high.low + (p.low - q.low) + mixed}, size(p.high) + size(q.high)};
}

// The same of an a that is no sum.
inline Known cross(Real ax, Real ay, const Pair& bx, const Pair& by) {
  const Pair p = product(ax, by.high), q = product(ay, bx.high);
  const Pair high = difference(p.high, q.high);
  const Real mixed = fused(ax, by.low, all(0) - ay * bx.low);
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
  const Real known =
      fused(fused(size(q1), d.terms, n.terms), all(0x1p-99), rest_terms * all(0x1p-50));
  const Real low_share = size(d.value.low) * divisor;
  const Real reach = fused(known, divisor, size(q2) * fused(all(4), low_share, all(0x1p-49)));
  const Real sum = q1 + q2, low = q2 - (sum - q1);
  const Mask normal = both(both(less(all(0x1p-800), n.terms), less(all(0x1p-800), d.terms)),
                           both(less(all(0x1p-800), sum), less(sum, all(0x1p900))));
  const Mask certain = both(equal(sum + (low + reach), sum), equal(sum + (low - reach), sum));
  const Mask small = both(less(low_share, all(0x1p-3)), less(size(q2), size(q1)));
  return choose(both(both(normal, certain), small), sum, all(__builtin_nan("")));
}

struct RayLanes {
  Real ox, oy, dx, dy;
};
// t = ((a - o) x (b - a)) / (d x (b - a)), the nearest double or NaN.
inline Real crossing_time(const RayLanes& ray, const Ends& e) {
  const Pair ex = difference(e.bx, e.ax), ey = difference(e.by, e.ay);
  const Pair wx = difference(e.ax, ray.ox), wy = difference(e.ay, ray.oy);
  return quotient(cross(wx, wy, ex, ey), cross(ray.dx, ray.dy, ex, ey));
}

// An exact sum of an exact product and a sum, to 2^-104 of the sizes of both.
inline Pair total(const Pair& a, const Pair& b) {
  const Pair high = difference(a.high, all(0) - b.high);
  const Real low = high.low + (a.low + b.low), sum = high.high + low;
  return {sum, low - (sum - high.high)};
}
// To 2^-103 of itself.
inline Pair square(const Pair& a) {
  const Pair p = product(a.high, a.high);
  return {p.high, p.low + all(2) * a.high * a.low};
}

// t at which a circle is met, the nearest double or NaN: a step of Newton's method for f = |o + t d - c|^2 - r^2
// from t as doubles have it, with f in double-double. f is off by 2^-100 of r times what its places are sums of, its
// slope by 2^-50 of the products of that; the step leaves out a (step)^2. `side` is -1 where the first root is asked,
// 1 for the second: the slope has that sign there, and nowhere beyond the middle between the two.
inline Real circle_time(const RayLanes& ray, const Ends& circle, Real side) {
  const Pair wx = difference(circle.ax, ray.ox), wy = difference(circle.ay, ray.oy);
  const Real r = circle.bx, a = ray.dx * ray.dx + ray.dy * ray.dy;
  const Real b = ray.dx * wx.high + ray.dy * wy.high, k = ray.dx * wy.high - ray.dy * wx.high;
  const Real h = root(r * r * a - k * k), t = (b + side * h) / a;
  const Pair tx = product(t, ray.dx), ty = product(t, ray.dy);
  const Pair x = total(tx, {all(0) - wx.high, all(0) - wx.low});
  const Pair y = total(ty, {all(0) - wy.high, all(0) - wy.low});
  const Pair r2 = product(r, r), inside = total(square(x), square(y));
  const Real f = (inside.high - r2.high) + (inside.low - r2.low);
  const Real slope_x = ray.dx * x.high, slope_y = ray.dy * y.high;
  const Real slope = all(2) * (slope_x + slope_y), inverse = all(1) / slope,
             step = all(0) - f * inverse;
  const Real terms = r * (size(tx.high) + size(ty.high) + size(wx.high) + size(wy.high) + r);
  const Real steep = size(inverse), curved = a * size(step) * steep;
  const Real slope_off = (size(slope_x) + size(slope_y)) * steep * all(0x1p-48);
  const Real reach = fused(all(0x1p-98) * terms, steep, size(step) * (slope_off + all(2) * curved));
  const Real sum = t + step, low = step - (sum - t);
  const Mask normal = both(both(less(all(0x1p-700), r2.high), less(terms, all(0x1p900))),
                           both(less(all(0x1p-700), sum), less(sum, all(0x1p900))));
  const Mask certain = both(equal(sum + (low + reach), sum), equal(sum + (low - reach), sum));
  const Mask near = both(less(all(0), side * slope), less(curved, all(0x1p-10)));
  return choose(both(both(normal, certain), near), sum, all(__builtin_nan("")));
}
