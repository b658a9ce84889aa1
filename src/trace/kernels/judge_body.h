// What a wall is to the rays of a group, as far as bounds can say: walk.h.

// Counts a wall for the rays that it is not ruled out for. Rays that go together mostly all miss a wall;
// of others some rarely do.
template <bool together>
inline void judge(const Constants& c, const Record& r, Mask idle, Asked& g) {
  const Float ax = r.ax - g.ox, ay = r.ay - g.oy, bx = r.bx - g.ox, by = r.by - g.oy;
  const Float side_a = fused_difference(g.dx, ay, g.dy * ax);
  const Float side_b = fused_difference(g.dx, by, g.dy * bx);
  const Float lower = smaller(side_a, side_b), upper = larger(side_a, side_b);
  const Float minus_side = all(0.0F) - c.side;
  const Mask missed = either(idle, either(less(c.side, lower), less(upper, minus_side)));
  if (together && bits(missed) == kEveryLane) return;
  const Mask sure = both(less(lower, minus_side), less(c.side, upper));
  const Float t_a = fused(g.dx, ax, g.dy * ay), t_b = fused(g.dx, bx, g.dy * by);
  const Float slope = (t_b - t_a) / (side_a - side_b), t = fused(side_a, slope, t_a);
  const Float error = fused(c.side, size(slope), c.time);
  const Float low = choose(sure, t - error, smaller(t_a, t_b) - c.time);
  const Float high = choose(sure, t + error, larger(t_a, t_b) + c.time);
  const Mask out = either(missed, either(less(high, all(0.0F)), less(g.limit, low)));
  const Mask closer = but_not(both(both(sure, less(all(0.0F), low)), less(high, g.high)), out);
  const Float loser = choose(closer, g.low, low);
  g.other = choose(out, g.other, smaller(g.other, loser));
  g.low = choose(closer, low, g.low);
  g.high = choose(closer, high, g.high);
  g.best = choose(closer, g.record, g.best);
}
