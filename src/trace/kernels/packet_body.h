// Rays that go together: those of a vector walk as one, column by column of the axis they go along
// most, through all cells between the outermost of them. A record is tested against all at once, so
// that nothing is gathered. Over the judge of judge_body.h.
//
// Columns are counted along u, rows along v, turned so that rays go up in both, by at most kSteepest rows a
// column. Where a ray crosses the plane of a column is off by 3 u M for its start, 12 u M for its slope, which has
// an error of 3 u, and less than 30 u M for roundings of numbers below 5 M: below 64 u M, which lists allow for.

constexpr float kSteepest = 2;

// Between which v the rays cross a column, at its lower and its upper plane, and how that rises.
struct Wedge {
  float low, low_rise, high, high_rise;
};

// What is the same for all rays of a packet.
struct Course {
  const unsigned* cells;
  int at, along, up;  // cell of column and row 0, from column to column, from row to row
  int columns, rows;  // half of them: from -columns to columns - 1
  int quadrant;       // shift of the word of an empty cell
  bool is_across;     // u is x
  bool left, down;
};

template <bool some_departed>
class Packet {
 public:
  Packet(const Grid& grid, const Walking& rays, int first) : grid_(grid), c_(constants_of(grid)) {
    load_rays(rays, first, g_);
    if (some_departed) departed_ = load(rays.departed + first);
    const Mask in_ring = less(g_.ox, all(static_cast<float>(0 - grid.half_x)));
    const int count = rays.count - first;
    open_ = but_not(lanes_of(count < kLanes ? (1U << count) - 1 : kEveryLane), in_ring);
    inverse_x_ = load(rays.inverse_x + first);
    inverse_y_ = load(rays.inverse_y + first);
  }

  const Asked& run() {
    while (bits(open_) != 0) {
      steer(__builtin_ctz(bits(open_)));
      walk();
    }
    return g_;
  }

 private:
  // Takes the rays that go about where ray `lane` goes.
  void steer(int lane) {
    alignas(64) float dx[kLanes], dy[kLanes];
    store(dx, g_.dx);
    store(dy, g_.dy);
    Course& w = course_;
    w.left = __builtin_signbit(dx[lane]) != 0;
    w.down = __builtin_signbit(dy[lane]) != 0;
    w.is_across = __builtin_fabsf(dx[lane]) >= __builtin_fabsf(dy[lane]);
    w.quadrant = (w.left ? 7 : 0) + (w.down ? 14 : 0);
    const auto stride = static_cast<int>(grid_.stride);
    const int by_x = w.left ? -1 : 1, by_y = w.down ? -stride : stride;
    w.cells = grid_.cells;
    w.at = static_cast<int>(grid_.first) - (w.left ? 1 : 0) - (w.down ? stride : 0);
    w.along = w.is_across ? by_x : by_y;
    w.up = w.is_across ? by_y : by_x;
    const auto half_x = static_cast<int>(0 - grid_.ring_x),
               half_y = static_cast<int>(0 - grid_.ring_y);
    w.columns = w.is_across ? half_x : half_y;
    w.rows = w.is_across ? half_y : half_x;
    const Float x = turned_by(g_.dx, g_.ox), y = turned_by(g_.dy, g_.oy);
    from_ = w.is_across ? x : y;
    inverse_ = w.is_across ? inverse_x_ : inverse_y_;
    const Float slope = (w.is_across ? size(g_.dy) : size(g_.dx)) * inverse_;
    const Mask left = negative(g_.dx), down = negative(g_.dy);
    Mask others = w.left ? but_not(open_, left) : both(open_, left);
    others = either(others, w.down ? but_not(open_, down) : both(open_, down));
    others = either(others, both(open_, less(all(kSteepest), slope)));
    live_ = but_not(open_, others);
    open_ = others;
    for (unsigned& slot : recent_) slot = kNone;  // others were tested against these
    spread_wedge(w.is_across ? y : x, slope);
  }

  void spread_wedge(Float v, Float slope) {
    const Float far = all(kFar);
    column_ = floor_of(least(choose(live_, from_, far)));
    const Float here = fused(all(static_cast<float>(column_)) - from_, slope, v);
    wedge_.low = least(choose(live_, here, far));
    wedge_.low_rise = least(choose(live_, slope, far));
    wedge_.high_rise = most(choose(live_, slope, all(0 - kFar)));
    wedge_.high = most(choose(live_, here, all(0 - kFar))) + wedge_.high_rise;
  }

  static int floor_of(float x) {  // of what an int can hold
    const int down = static_cast<int>(x);
    return down - (x < static_cast<float>(down) ? 1 : 0);
  }

  void walk() {
    const int first = column_;
    for (;;) {
      const auto gone = static_cast<float>(column_ - first);
      const float low = wedge_.low + gone * wedge_.low_rise;
      const float high = wedge_.high + gone * wedge_.high_rise;
      const int bottom = floor_of(low) < -course_.rows ? -course_.rows : floor_of(low);
      const int top = floor_of(high) < course_.rows ? floor_of(high) : course_.rows - 1;
      if (bottom >= course_.rows) return;
      column_ += bottom <= top ? cross_column(bottom, top, low, high) : 1;
      if (column_ >= course_.columns || !any_live(static_cast<float>(column_))) return;
    }
  }

  // Tests the walls of a column; gives how many columns that is, as those that follow may be empty.
  int cross_column(int bottom, int top, float low, float high) {
    const unsigned* cell =
        course_.cells + (course_.at + column_ * course_.along + bottom * course_.up);
    if ((*cell >> 31) != 0) {
      const int side = static_cast<int>(*cell >> course_.quadrant & 127U);
      if (bottom + side > top) {
        int columns = 1;
        const auto end = static_cast<float>(bottom + side);
        while (columns < side && high + static_cast<float>(columns) * wedge_.high_rise < end)
          ++columns;
        return columns;
      }
    }
    for (int row = bottom; row <= top; ++row, cell += course_.up) {
      const unsigned word = *cell;
      if ((word >> 31) != 0) continue;
      if ((word >> 30) == 0)
        test_list(word);
      else
        cross_divided(word, static_cast<float>(row), low, high, bottom == top);
    }
    return 1;
  }

  // The cells of a crowded cell, in the same way. Where others are in its column, what they hold may be met
  // before what it does.
  void cross_divided(unsigned word, float row, float low, float high, bool is_alone) {
    const auto parts = __builtin_bit_cast(float, word & 0x7f800000U);
    const int n = static_cast<int>(parts);
    const unsigned* cells = course_.cells + 16 * static_cast<unsigned long>(word & 0x7fffffU);
    const auto place = [&](float v) {
      const float within = (v - row) * parts;
      return within < 0 ? 0 : within < parts ? static_cast<int>(within) : n - 1;
    };
    for (int k = 0; k < n; ++k) {
      const float share = static_cast<float>(k) / parts,
                  rest = static_cast<float>(n - 1 - k) / parts;
      // Of rays within a rounding of each other what comes up from the lower plane may lie above what comes
      // down from the upper one: either is within the bound, and the lowest cell is always looked at.
      const int first = place(low + share * wedge_.low_rise);
      const int last = place(high - rest * wedge_.high_rise);
      for (int m = first; m <= (last < first ? first : last); ++m) {
        const int column = course_.is_across ? k : m, line = course_.is_across ? m : k;
        const unsigned inner = cells[(course_.down ? n - 1 - line : line) * n +
                                     (course_.left ? n - 1 - column : column)];
        if ((inner >> 31) == 0) test_list(inner);
      }
      if (is_alone && !any_live(static_cast<float>(column_) + share + 1 / parts)) return;
    }
  }

  // A wall listed again is the one that was met, or changes nothing.
  void test_list(unsigned record) {
    const unsigned* slot = grid_.slots + record;
    for (const float* at = grid_.records + 4 * static_cast<unsigned long>(record);;
         at += 4, ++slot) {
      if (!is_recent(*slot)) {
        g_.record = all(static_cast<int>(*slot));
        Mask out = either(but_not(lanes_of(kEveryLane), live_), equal(g_.best, g_.record));
        if (some_departed) out = either(out, equal(departed_, g_.record));
        judge<true>(c_, spread_record(at), out, g_);
      }
      if (is_last(at)) return;
    }
  }

  bool is_recent(unsigned slot) {
    for (const unsigned each : recent_)
      if (each == slot) return true;
    recent_[3] = recent_[2];
    recent_[2] = recent_[1];
    recent_[1] = recent_[0];
    recent_[0] = slot;
    return false;
  }

  // Leaves out rays of which nothing that comes behind the plane at u matters.
  bool any_live(float u) {
    const Float exit = (all(u) - from_) * inverse_;
    live_ = but_not(live_, less(smaller(g_.high, g_.other), exit - c_.near));
    return bits(live_) != 0;
  }

  const Grid& grid_;
  const Constants c_;
  Asked g_;
  Int departed_{};
  Float inverse_x_, inverse_y_;
  Mask open_, live_{};  // rays still to go; those of them under way
  Course course_{};
  Wedge wedge_{};
  Float from_{}, inverse_{};  // along u
  int column_ = 0;
  unsigned recent_[4];  // walls tested last
};

template <bool some_departed>
void walk_together(const Grid& grid, const Walking& rays, int* found) {
  for (int i = 0; i < rays.count; i += kLanes)
    write_verdicts(Packet<some_departed>(grid, rays, i).run(), rays, found + i);
}

template <bool some_departed>
void walk_apart(const Grid& grid, const Walking& rays, int* found) {
  if (grid.curves == nullptr)
    walk_all(grid, rays, found, [](const Constants& c, const Grid& walls, Group& g) {
      test<some_departed>(c, walls, g);
    });
  else
    walk_all(grid, rays, found, [](const Constants& c, const Grid& curves, Group& g) {
      test_curves<some_departed>(c, curves, g);
    });
}

void walk(const Grid& grid, const Walking& rays, int* found) {
  const bool together = grid.curves == nullptr && go_together(rays, 3);
  if (rays.departed != nullptr)
    (together ? walk_together<true> : walk_apart<true>)(grid, rays, found);
  else
    (together ? walk_together<false> : walk_apart<false>)(grid, rays, found);
}
