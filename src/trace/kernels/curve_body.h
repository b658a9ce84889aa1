// What a curve is to the rays of a group, as far as bounds can say: walk.h.

// Curves in rows: of every lane its own, or one for all.
struct Curves {
  Record size, form, part;
};
inline const float* row_of(const Curve& curve, int row) { return &curve.centre_x + 4 * row; }
inline Curves curves_at(const Curve* curves, const unsigned* slot) {
  const auto rows = [&](int row) {
    return fetch([&](int lane) { return row_of(curves[slot[lane]], row); });
  };
  return {rows(0), rows(1), rows(2)};
}
inline Curves spread_curve(const Curve& curve) {
  const auto row = [&](int of) { return spread_record(row_of(curve, of)); };
  return {row(0), row(1), row(2)};
}

// The roots in which rays have left their curves, where these are those of `slot`.
struct Left {
  Mask first, second;
};
inline Left left_of(Int departed, Int roots, Int slot) {
  const Mask same = equal(departed, slot);
  return {both(same, odd(__builtin_bit_cast(Float, roots))),
          both(same, less(all(1.5F), real(roots)))};
}

// Of the last word of a record: whether the curve is its whole disc, and its slot.
inline Mask is_circle(const Record& r) {
  return odd(__builtin_bit_cast(Float, shifted(__builtin_bit_cast(Int, r.by), all(1))));
}
inline Int slot_of(const Record& r) { return shifted(__builtin_bit_cast(Int, r.by), all(2)); }

// One of the two points in which lines meet curves, by t: whether it is surely behind or beside the part, or
// surely met; t at the earliest and latest.
struct Meeting {
  Mask is_none, is_met;
  Float low, high;
};

// Lines and curves in the form in which these are circles: t = (b -+ h) / a, h^2 = q.
struct Chord {
  Float px, py, gx, gy;  // centre - origin, direction
  Float b, inverse;      // inverse: 1 / a
  Float q, off, h;       // off: what q is off by at most
  Float error;           // of b -+ h, without what a is off by
};
inline Chord chord_of(const Constants& c, const Curves& w, const Asked& g) {
  const Float x = w.size.ax - g.ox, y = w.size.ay - g.oy;
  Chord o;
  o.px = fused(w.form.ax, x, w.form.ay * y);
  o.py = fused(w.form.bx, x, w.form.by * y);
  o.gx = fused(w.form.ax, g.dx, w.form.ay * g.dy);
  o.gy = fused(w.form.bx, g.dx, w.form.by * g.dy);
  o.b = fused(o.px, o.gx, o.py * o.gy);
  const Float a = fused(o.gx, o.gx, o.gy * o.gy), k = fused_difference(o.gx, o.py, o.gy * o.px);
  const Float r2 = w.size.bx * w.size.bx, k2 = k * k, e = c.curve + w.size.by;
  o.inverse = all(1.0F) / a;
  o.q = fused_difference(r2, a, k2);
  o.off = fused(all(kForm), r2 + k2, e * fused(all(2.0F), size(k), e));
  o.h = root(o.q);
  o.error = e + o.off / o.h;
  return o;
}
// How far beyond the ends of its part a curve is met, where that is negative, in the form.
inline Float inside_of(const Curves& w, const Chord& o, Float t) {
  const Float beside = fused(t, o.gx, all(0.0F) - o.px), along = fused(t, o.gy, all(0.0F) - o.py);
  return fused(beside, w.part.ax, along * w.part.ay) - w.part.bx * w.size.bx;
}

inline Meeting meeting(const Constants& c, const Curves& w, const Chord& o, Float root,
                       Mask is_left) {
  const Float t = (o.b + root) * o.inverse;
  const Float error = fused(size(t), all(kForm), o.error) * o.inverse;
  const Float inside = inside_of(w, o, t), off = error + c.part;
  const Float low = t - error, high = t + error;
  // What joins an end to its curve is met, also where the root beside it is left.
  const Mask is_inner = either(less(w.part.bx, all(-2.0F)), less(off, inside));
  const Mask left = both(is_left, is_inner);
  const Mask out = either(either(left, less(high, all(0.0F))), less(inside, all(0.0F) - off));
  return {out, both(less(all(0.0F), low), less(off, inside)), low, high};
}

// Takes the earlier of two meetings that is not none, where lines surely cross their curves; else what is known
// is only that they meet none of them before `early`.
inline void count(const Meeting& first, const Meeting& second, Mask crossed, Mask passed,
                  Float early, Asked& g) {
  const Mask one = but_not(crossed, first.is_none);
  const Mask none = both(both(crossed, first.is_none), second.is_none);
  const Mask sure = both(
      crossed, either(both(first.is_none, second.is_met), but_not(first.is_met, first.is_none)));
  const Float low = choose(crossed, choose(one, first.low, second.low), early);
  const Float high = choose(one, first.high, second.high);
  const Mask out = either(either(passed, none), less(g.limit, low));
  const Mask closer = but_not(both(sure, less(high, g.high)), out);
  const Float loser = choose(closer, g.low, low);
  g.other = choose(out, g.other, smaller(g.other, loser));
  g.low = choose(closer, low, g.low);
  g.high = choose(closer, high, g.high);
  g.best = choose(closer, sum(g.record, choose(one, all(0), all(kSecond))), g.best);
}

// Circles: their discs are they themselves, and the form of a vector is the vector.
inline Meeting meeting_circle(Float t, Float error, Mask is_left) {
  const Float low = t - error, high = t + error;
  return {either(is_left, less(high, all(0.0F))), less(all(0.0F), low), low, high};
}
inline void judge_circles(const Constants& c, Float radius, Float beside, Float ahead, Float early,
                          Mask missed, const Left& left, Asked& g) {
  const Float r2 = radius * radius, k2 = beside * beside, q = r2 - k2, h = root(q);
  const Float off = fused(all(kForm), r2 + k2, c.curve * fused(all(2.0F), size(beside), c.curve));
  const Mask passed = either(missed, less(q, all(0.0F) - off)), crossed = less(off, q);
  const Float error = fused(all(kForm), size(ahead) + h, c.curve + off / h);
  count(meeting_circle(ahead - h, error, left.first), meeting_circle(ahead + h, error, left.second),
        crossed, passed, early, g);
}

inline void judge_forms(const Constants& c, const Curves& w, Float early, Mask missed,
                        const Left& left, Asked& g) {
  const Float zero = all(0.0F);
  const Chord o = chord_of(c, w, g);
  const Mask passed = either(missed, less(o.q, zero - o.off)), crossed = less(o.off, o.q);
  count(meeting(c, w, o, zero - o.h, left.first), meeting(c, w, o, o.h, left.second), crossed,
        passed, early, g);
}

// Counts curves for the rays that they are not ruled out for: `r` are the discs about them, curves_of() gives
// them.
template <class CurvesOf>
inline void judge_curve(const Constants& c, const Record& r, const CurvesOf& curves_of, Mask idle,
                        const Left& left, Asked& g) {
  const Float to_x = r.ax - g.ox, to_y = r.ay - g.oy;
  const Float beside = fused_difference(g.dx, to_y, g.dy * to_x), reach = r.bx + c.time;
  const Float ahead = fused(g.dx, to_x, g.dy * to_y), early = ahead - reach;
  const Mask late = less(smaller(g.limit, g.high), early);
  const Mask missed =
      either(either(idle, late), either(less(reach, size(beside)), less(ahead + reach, all(0.0F))));
  const unsigned open = ~bits(missed) & kEveryLane;
  if (open == 0) return;
  if ((open & ~bits(is_circle(r))) == 0)
    judge_circles(c, r.bx, beside, ahead, early, missed, left, g);
  else
    judge_forms(c, curves_of(), early, missed, left, g);
}

template <bool some_departed>
inline void test_curves(const Constants& c, const Grid& grid, Group& g) {
  alignas(64) unsigned at[kLanes], slot[kLanes];
  const Mask idle = negative(g.record);
  const Int record = choose(idle, all(0), g.record);
  store(at, record);
  const Record r =
      fetch([&](int lane) { return grid.records + 4 * static_cast<unsigned long>(at[lane]); });
  const Int slots = slot_of(r);
  store(slot, slots);
  const Left left =
      some_departed ? left_of(__builtin_bit_cast(Int, g.departed_ax), whole(g.departed_ay), slots)
                    : Left{none(), none()};
  judge_curve(
      c, r, [&] { return curves_at(grid.curves, slot); }, idle, left, g);
  const Mask last = either(idle, odd(r.by));
  g.moving = both(g.live, last);
  g.record = choose(last, all(-1), next(g.record));
}
