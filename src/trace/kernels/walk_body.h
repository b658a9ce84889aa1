// The walk through the grid, written once over the lanes of single_vector.h, the groups of group_body.h
// and the judge of judge_body.h.

template <bool some_departed>
inline void test(const Constants& c, const Grid& grid, Group& g) {
  alignas(64) unsigned at[kLanes];
  const Mask idle = negative(g.record);
  const Int record = choose(idle, all(0), g.record);
  store(at, sum(record, record));
  // By twice their numbers, as addresses take them without a shift.
  const Record r =
      fetch([&](int lane) { return grid.records + 2 * static_cast<unsigned long>(at[lane]); });
  Mask out = idle;
  if (some_departed)
    out = either(out, both(both(equal(r.ax, g.departed_ax), equal(r.ay, g.departed_ay)),
                           equal(r.bx, g.departed_bx)));
  judge<false>(c, r, out, g);
  const Mask last = either(idle, odd(r.by));
  g.moving = both(g.live, last);
  g.record = choose(last, all(-1), next(g.record));
}

// Stops the rays whose best is certain to come first or to be doubtful, takes the others to the
// cell behind their exit. Rounding must not take a ray back.
inline void advance(Group& g) {
  const Mask stop = both(g.moving, less(smaller(g.high, g.other), g.limit));
  g.live = but_not(g.live, stop);
  g.done = either(g.done, stop);
  g.moving = but_not(g.moving, stop);
  const Float x = larger(fused(g.exit, g.step_x, g.from_x), g.x);
  const Float y = larger(fused(g.exit, g.step_y, g.from_y), g.y);
  g.x = choose(g.moving, choose(g.across_x, g.exit_x, x), g.x);
  g.y = choose(g.moving, choose(g.across_x, y, g.exit_y), g.y);
}

// The words of the cells that rays enter, and the sides of these cells; moves the rays to their
// corners.
inline Int look_up(const unsigned* cells, Group& g, Float& cell) {
  const Float one = all(1.0F), x = floor(g.x), y = floor(g.y);
  const Int word = gather(cells, whole(fused(g.turn_y, y, fused(g.turn_x, x, g.first))));
  const Mask divided = second_bit(word);
  if (bits(divided) == 0) {
    g.x = x;
    g.y = y;
    cell = one;
    return word;
  }
  const Float n = choose(divided, exponent_of(word), one);
  // Of a place just below a whole number the difference may round to 1.
  const Float column = smaller(floor((g.x - x) * n), n - one);
  const Float row = smaller(floor((g.y - y) * n), n - one);
  const Float at_x = choose(negative(g.dx), n - one - column, column);
  const Float at_y = choose(negative(g.dy), n - one - row, row);
  const Int at = sum(sixteenfold(word), whole(at_y * n + at_x));
  cell = one / n;
  g.x = x + column * cell;
  g.y = y + row * cell;
  return choose(divided, gather(cells, choose(divided, at, all(0))), word);
}

// Looks up the cells just entered; of rays that stay in their cell the record alone is new.
inline void enter(const Constants& c, const unsigned* cells, const float* records, bool fetch_ahead,
                  Group& g) {
  Float cell;
  const Int word = look_up(cells, g, cell);
  const Mask empty = negative(word);
  const Float side = choose(empty, real(low_seven(shifted(word, g.quadrant))) * cell, cell);
  g.record = choose(g.moving, choose(empty, all(-1), word), g.record);
  g.exit_x = g.x + side;
  g.exit_y = g.y + side;
  const Float t_x = (g.exit_x - g.from_x) * g.inverse_x, t_y = (g.exit_y - g.from_y) * g.inverse_y;
  g.across_x = less(t_x, t_y);
  g.exit = smaller(t_x, t_y);
  g.limit = choose(less(all(0.0F), side), g.exit - c.near, all(kEndless));
  if (!fetch_ahead) return;
  // The records are wanted when the other groups have looked up theirs.
  alignas(64) unsigned at[kLanes];
  const Int record = choose(negative(g.record), all(0), g.record);
  store(at, sum(record, record));
  for (const unsigned twice : at)
    __builtin_prefetch(records + 2 * static_cast<unsigned long>(twice));
}

// The rays still to come, and where the answers go.
struct Queue {
  const unsigned* slots;  // by record
  const Walking& rays;
  int* found;
  int next;
};

inline void write(unsigned lanes, const Group& g, Queue& queue) {
  alignas(64) unsigned ray[kLanes], record[kLanes];
  store(ray, whole(g.ray));
  store(record, verdict(g, queue.rays));
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = __builtin_ctz(lanes);
    const auto met = static_cast<int>(record[lane]);
    queue.found[ray[lane]] =
        met < 0 ? met : static_cast<int>(queue.slots[met & ~kSecond]) | (met & kSecond);
  }
}

void take(const Constants& c, unsigned lanes, Group& g, Queue& queue) {
  while (__builtin_popcount(lanes) > queue.rays.count - queue.next) lanes &= lanes - 1;
  if (lanes == 0) return;
  const Walking& r = queue.rays;
  const int from = queue.next;
  queue.next += __builtin_popcount(lanes);
  g.ray = spread(lanes, r.number + from, g.ray);
  g.ox = spread(lanes, r.ox + from, g.ox);
  g.oy = spread(lanes, r.oy + from, g.oy);
  g.dx = spread(lanes, r.dx + from, g.dx);
  g.dy = spread(lanes, r.dy + from, g.dy);
  g.inverse_x = spread(lanes, r.inverse_x + from, g.inverse_x);
  g.inverse_y = spread(lanes, r.inverse_y + from, g.inverse_y);
  if (r.departed != nullptr) {
    g.departed_ax = spread(lanes, r.departed_ax + from, g.departed_ax);
    g.departed_ay = spread(lanes, r.departed_ay + from, g.departed_ay);
    g.departed_bx = spread(lanes, r.departed_bx + from, g.departed_bx);
  }
  Float farthest = all(kFar);
  if (r.up_to != nullptr) {
    g.end_low = spread(lanes, r.end_low + from, g.end_low);
    g.end_high = spread(lanes, r.end_high + from, g.end_high);
    farthest = g.end_high = smaller(g.end_high, farthest);
  }
  g.from_x = turned_by(g.dx, g.ox);
  g.from_y = turned_by(g.dy, g.oy);
  g.step_x = size(g.dx);
  g.step_y = size(g.dy);
  g.turn_x = with_sign_of(all(1.0F), g.dx);
  g.turn_y = with_sign_of(c.stride, g.dy);
  const Float none = all(0.0F);
  g.first =
      c.first - choose(negative(g.dx), all(1.0F), none) - choose(negative(g.dy), c.stride, none);
  const Int right = choose(negative(g.dx), all(7), all(0));
  const Int left = choose(negative(g.dx), all(21), all(14));
  g.quadrant = choose(negative(g.dy), left, right);
  const Mask fresh = lanes_of(lanes);
  g.x = choose(fresh, g.from_x, g.x);
  g.y = choose(fresh, g.from_y, g.y);
  g.low = choose(fresh, all(kFar), g.low);
  g.high = choose(fresh, all(kFar), g.high);
  g.other = choose(fresh, farthest, g.other);
  g.record = choose(fresh, all(-1), g.record);
  g.live = either(g.live, fresh);
  g.moving = either(g.moving, fresh);
}

// Writes what is finished and takes new rays, when enough lanes wait or none is busy.
inline bool settle(const Constants& c, Group& g, Queue& queue) {
  const unsigned done = bits(g.done), live = bits(g.live);
  if (__builtin_popcount(done) < kRefill && live != 0) return true;
  write(done, g, queue);
  g.done = none();
  take(c, ~live & ((1U << kLanes) - 1), g, queue);
  return bits(g.live) != 0;
}

// `test_one(c, grid, group)` counts the walls of a group's records.
template <class TestOne>
void walk_all(const Grid& grid, const Walking& rays, int* found, const TestOne& test_one) {
  const Constants c = constants_of(grid);
  Queue queue{grid.slots, rays, found, 0};
  Group groups[kGroups] = {};
  for (Group& g : groups) {
    g.record = all(-1);
    g.first = c.first;
    take(c, (1U << kLanes) - 1, g, queue);
    enter(c, grid.cells, grid.records, grid.is_large, g);
  }
  for (bool busy = true; busy;) {
    for (Group& g : groups) test_one(c, grid, g);
    for (Group& g : groups) advance(g);
    busy = false;
    for (Group& g : groups) busy = settle(c, g, queue) || busy;
    for (Group& g : groups) enter(c, grid.cells, grid.records, grid.is_large, g);
  }
}
