// Culls pairs by the boxes around them. Lanes are pairs.

constexpr double kInfinite = __builtin_inf();

// Where they are at the end of the time.
inline Real later(Real centre, Real way, double length) {
  if (length < kInfinite) return centre + all(length) * way;
  return choose(equal(way, all(0)), centre, way * all(kInfinite));
}

// Boxes that stay apart along an axis at both ends of the time do so all along. Errors of some u
// each, of what the terms add up to, are far below the 2^-40 allowed for.
inline Mask stay_apart(Real centre, Real way, Real half, double length) {
  const double finite = length < kInfinite ? length : 0;
  const Real reach = half + all(0x1p-40) * (size(centre) + size(way) * all(finite));
  const Real end = later(centre, way, length), minus = all(0) - reach;
  return either(both(less(reach, centre), less(reach, end)),
                both(less(centre, minus), less(end, minus)));
}

// Beside the whole way.
inline Mask passes(Real cx, Real cy, Real wx, Real wy, Real half_x, Real half_y) {
  const Real left = cx * wy, right = cy * wx;
  const Real across = size(left - right) - all(0x1p-50) * (size(left) + size(right));
  const Real reach = half_x * size(wy) + half_y * size(wx);
  return less(reach * all(1 + 0x1p-40) + all(0x1p-900), across);
}

void cull_boxes(const double* boxes, double length, const Moves& moves, int count, double* near) {
  const auto *bodies = reinterpret_cast<const char*>(moves.bodies),
             *velocities = reinterpret_cast<const char*>(moves.velocities);
  for (int i = 0; i < count; i += FLATRAY_LANES) {
    const double *at_a[FLATRAY_LANES], *at_b[FLATRAY_LANES], *moves_at[FLATRAY_LANES];
    for (int lane = 0; lane < FLATRAY_LANES; ++lane) {
      const long by = moves.stride * (i + lane < count ? i + lane : count - 1);
      const auto* numbers = reinterpret_cast<const unsigned*>(bodies + by);
      at_a[lane] = boxes + 4L * numbers[0];
      at_b[lane] = boxes + 4L * numbers[1];
      moves_at[lane] = reinterpret_cast<const double*>(velocities + by);
    }
    const Ends a = fetch_ends(at_a, 0), b = fetch_ends(at_b, 0), v = fetch_ends(moves_at, 0);
    const Real wx = v.bx - v.ax, wy = v.by - v.ay;
    const Real cx = b.ax - a.ax, cy = b.ay - a.ay, half_x = a.bx + b.bx, half_y = a.by + b.by;
    const Mask apart =
        either(either(stay_apart(cx, wx, half_x, length), stay_apart(cy, wy, half_y, length)),
               passes(cx, cy, wx, wy, half_x, half_y));
    const Mask pass = less(all(0), size(wx) + size(wy));
    store(near + i, choose(both(apart, pass), all(0), all(1)));
  }
}
