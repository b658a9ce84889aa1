// Lists of records against one ray alone, a record in each lane of single_vector.h.
#include "trace/kernels/single_moves.h"

constexpr float kFar = 1e30F;

// A ray, the same in every lane, and its bounds.
struct Line {
  Float ox, oy, dx, dy, side, time;
  unsigned departed;  // slot of the segment just left, or kNone
};

// The best sure hit, and the least t that any other wall not ruled out could have.
struct Candidates {
  float low = kFar, high = kFar, other = kFar;
  int record = kNoRecord;
  unsigned slot = kNone;

  float least() const { return high < other ? high : other; }
  int verdict() const {
    if (high < other) return record;
    return other < kFar ? kDoubt : kNoRecord;
  }
};

// Records that are not ruled out, as far as bounds can say.
struct Open {
  Float side_a, side_b, t_a, t_b, lower, upper;
};

inline void weigh(const Grid& grid, const Line& line, const Open& o, unsigned record, unsigned open,
                  Candidates& r) {
  const Mask sure = both(less(o.lower, all(0.0F) - line.side), less(line.side, o.upper));
  const Float slope = (o.t_b - o.t_a) / (o.side_a - o.side_b), t = o.t_a + o.side_a * slope;
  const Float error = line.time + line.side * size(slope);
  alignas(16) float low[kLanes], high[kLanes];
  store(low, choose(sure, t - error, smaller(o.t_a, o.t_b) - line.time));
  store(high, choose(sure, t + error, larger(o.t_a, o.t_b) + line.time));
  const unsigned sure_bits = bits(sure);
  for (; open != 0; open &= open - 1) {
    const int lane = __builtin_ctz(open);
    const unsigned slot = grid.slots[record + static_cast<unsigned>(lane)];
    if (high[lane] < 0 || slot == line.departed || slot == r.slot) continue;
    if ((sure_bits >> lane & 1U) != 0 && 0 < low[lane] && high[lane] < r.high) {
      r.other = r.other < r.low ? r.other : r.low;
      r.low = low[lane];
      r.high = high[lane];
      r.record = static_cast<int>(record) + lane;
      r.slot = slot;
    } else {
      r.other = r.other < low[lane] ? r.other : low[lane];
    }
  }
}

// Counts the walls of a list, from its first record.
inline void test_list(const Grid& grid, const Line& line, unsigned record, Candidates& r) {
  __builtin_prefetch(grid.slots + record);
  for (;; record += kLanes) {
    const float* const first = grid.records + 4 * static_cast<unsigned long>(record);
    const Record w = fetch([&](int lane) { return first + 4 * lane; });
    const unsigned last = bits(odd(w.by)), listed = last ^ (last - 1);
    const Float ax = w.ax - line.ox, ay = w.ay - line.oy;
    const Float bx = w.bx - line.ox, by = w.by - line.oy;
    Open o;
    o.side_a = line.dx * ay - line.dy * ax;
    o.side_b = line.dx * by - line.dy * bx;
    o.t_a = line.dx * ax + line.dy * ay;
    o.t_b = line.dx * bx + line.dy * by;
    o.lower = smaller(o.side_a, o.side_b);
    o.upper = larger(o.side_a, o.side_b);
    const Mask missed =
        either(either(less(line.side, o.lower), less(o.upper, all(0.0F) - line.side)),
               less(larger(o.t_a, o.t_b) + line.time, all(0.0F)));
    const unsigned open = ~bits(missed) & listed & ((1U << kLanes) - 1);
    if (open != 0) weigh(grid, line, o, record, open, r);
    if (last != 0) return;
  }
}
