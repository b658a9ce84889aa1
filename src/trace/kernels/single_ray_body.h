// The nearest segment or curve of one ray alone, whose way may branch where lanes may not. Bounds: walk.h.
//
// Cells are crossed one by one, turned as in walk_body.h. With a direction (p, q), p, q >= 0, from f,
// of the planes by which the cell at (X, Y) is left the ray meets that of x first where
//   e = (X + 1 - f_x) q - (Y + 1 - f_y) p < 0;
// crossing it adds q to e, crossing the other takes p away. e, p and q are whole numbers of 2^-40, off
// by half of one: over the 2^13 cells a ray can cross by 2^-27 cells in all, which lists allow for
// some hundred times. So a step is a few additions that wait for no memory.
//
// Directions are scaled by a power of two so that the greater component is in [1/2, 1). All bounds of
// walk.h are in proportion to the length of the direction, which |d_x| + |d_y| is not below; t counts
// cells times that length squared.
// clang-format off
#include "trace/kernels/vector.h"
#include "trace/kernels/quotient_body.h"
// clang-format on

using records::Candidates;
using records::kFar;
using records::Line;
using records::test_list;

constexpr unsigned kOutside = 0x80000000U;  // the word of a cell in the ring
constexpr double kFixed = 0x1p40;
constexpr double kEarly = 0x1p-20;  // in cells: divided cells are entered as much earlier
constexpr double kLeastSize = 0x1p-450, kLargestSize = 0x1p450;

// The cell a ray is in, and how many it has crossed in x and in y, in one word: counted by one
// addition.
constexpr int kCountX = 26, kCountY = 45;
constexpr long kCell = (1L << kCountX) - 1, kCount = (1L << (kCountY - kCountX)) - 1;

// 1 or -1, by which places are turned so that rays go up and to the right. Not by branches: which way
// a ray goes cannot be foreseen.
inline double turn_of(double along) { return with_sign_of(1, along); }
// A turned cell, by its lower corner, as it is counted in the grid.
inline double unturned(double corner, double turn) { return turn * corner + 0.5 * (turn - 1); }

inline double floor_of(double x) {  // of what an int can hold
#ifdef __SSE4_1__
  return __builtin_floor(x);
#else
  const auto down = static_cast<double>(static_cast<int>(x));
  return down - static_cast<double>(static_cast<int>(x < down));
#endif
}

// A ray as given; `departed` as walk.h has it.
struct SingleRay {
  double ox, oy, dx, dy;
  unsigned departed;
};

// A ray in cells, as it is and turned: what is known of it in doubles. `skipped`: of its way, in steps, before it
// enters the grid; a step is the direction in cells times `scale`.
struct Start {
  double x, y, from_x, from_y, step_x, step_y, turn_x, turn_y, scale, skipped;
};

enum class Fate { walks, misses, uncertain };

// Starts a ray from beyond the grid where it enters it.
inline Fate bring_in(const Grid& grid, Start& s) {
  const double x_in = (-grid.half_x - s.from_x) / s.step_x;
  const double y_in = (-grid.half_y - s.from_y) / s.step_y;
  const double x_out = (grid.half_x - s.from_x) / s.step_x;
  const double y_out = (grid.half_y - s.from_y) / s.step_y;
  const double into = larger(larger(x_in, y_in), 0);
  if (smaller(x_out, y_out) < into) return Fate::misses;
  s.skipped = into;
  const auto inside = [](double at, double half) { return larger(-half, smaller(at, half)); };
  s.from_x = inside(s.from_x + into * s.step_x, grid.half_x);
  s.from_y = inside(s.from_y + into * s.step_y, grid.half_y);
  s.x = s.turn_x * s.from_x;
  s.y = s.turn_y * s.from_y;
  return Fate::walks;
}

// Inlined, as what is known of the ray stays in registers then.
__attribute__((always_inline)) inline Fate prepare(const Grid& grid, const SingleRay& ray,
                                                   Start& s) {
  const double x = s.x = (ray.ox - grid.centre_x) * grid.scale_x;
  const double y = s.y = (ray.oy - grid.centre_y) * grid.scale_y;
  const double dx = ray.dx * grid.scale_x, dy = ray.dy * grid.scale_y;
  const double most = larger(size(dx), size(dy));
  if (!(kLeastSize < most && most < kLargestSize && size(x) < grid.far && size(y) < grid.far))
    return Fate::uncertain;
  const auto exponent = __builtin_bit_cast(unsigned long, most) >> 52;
  const double scale = s.scale = __builtin_bit_cast(double, (2045 - exponent) << 52);
  s.skipped = 0;
  s.turn_x = turn_of(dx);
  s.turn_y = turn_of(dy);
  s.step_x = larger(size(dx) * scale, kLeastStep);
  s.step_y = larger(size(dy) * scale, kLeastStep);
  s.from_x = s.turn_x * x;
  s.from_y = s.turn_y * y;
  if (size(x) < grid.half_x && size(y) < grid.half_y) return Fate::walks;
  return bring_in(grid, s);
}

// As records in the lanes of list:: or records:: take it.
template <class Line, class All>
Line line_of(const Grid& grid, const Start& s, unsigned departed, const All& all_of) {
  const auto in_all = [&](double value) { return all_of(static_cast<float>(value)); };
  const double unit = static_cast<double>(grid.unit) * (s.step_x + s.step_y);
  return {in_all(s.x),
          in_all(s.y),
          in_all(s.turn_x * s.step_x),
          in_all(s.turn_y * s.step_y),
          in_all(kSide * unit),
          in_all(kTime * unit),
          departed};
}

// Tests of what cells list: lists(record) counts the walls of a list, least() is the least t that one may have. t
// counts `per_step` for a step; what lies farther than `near` before the exit of a cell comes before all beyond.
// Whether that ends the walk is asked where may_end(), of the exit in steps.
struct SegmentTest {
  SegmentTest(const Grid& all, const Start& start, const Line& of_ray)
      : grid(all),
        line(of_ray),
        per_step(start.step_x * start.step_x + start.step_y * start.step_y),
        near(kNear * static_cast<double>(all.unit) * (start.step_x + start.step_y)) {}
  void lists(unsigned record) { test_list(grid, line, record, found); }
  bool may_end() const { return found.least() < kFar; }
  bool is_end(double exit) const {
    return static_cast<double>(found.least()) < exit * per_step - near;
  }

  const Grid& grid;
  const Line& line;
  const double per_step, near;
  Candidates found;
};

// As curves are judged in the lanes, one after the other; the direction is of unit length.
struct CurveTest {
  CurveTest(const Grid& all, const Start& start, const SingleRay& ray, unsigned left_roots,
            double up_to)
      : grid(all),
        c(single_curve::constants_of(all)),
        departed(ray.departed),
        roots(left_roots),
        per_step(root(start.step_x * start.step_x + start.step_y * start.step_y)),
        near(kNear * static_cast<double>(all.unit)) {
    found.ox = static_cast<float>(start.x);
    found.oy = static_cast<float>(start.y);
    found.dx = static_cast<float>(start.turn_x * start.step_x / per_step);
    found.dy = static_cast<float>(start.turn_y * start.step_y / per_step);
    found.best = kNoRecord;
    found.limit = single_curve::kEndless;
    found.low = found.high = single_curve::kFar;
    const double end = smaller((up_to / start.scale - start.skipped) * per_step, kLatest);
    const double off = size(end) * 0x1p-22 + 2 * static_cast<double>(all.unit);
    found.end_low = static_cast<float>(end - off);
    found.other = found.end_high = single_curve::smaller(static_cast<float>(end + off), kFar);
  }
  // A curve listed again is the one that was met, or changes nothing.
  void lists(unsigned record) {
    for (const float* at = grid.records + 4 * static_cast<unsigned long>(record);; at += 4) {
      const single_curve::Record r = single_curve::spread_record(at);
      const int slot = single_curve::slot_of(r);
      found.record = slot;
      const bool is_left = static_cast<unsigned>(slot) == departed;
      single_curve::judge_curve(
          c, r, [&] { return single_curve::spread_curve(grid.curves[slot]); },
          found.best >= 0 && (found.best & ~kSecond) == slot,
          {is_left && (roots & 1U) != 0, is_left && roots > 1}, found);
      if (single_curve::is_last(at)) return;
    }
  }
  bool may_end() const { return least() < kFar; }
  bool is_end(double exit) const { return static_cast<double>(least()) < exit * per_step - near; }
  float least() const { return single_curve::smaller(found.high, found.other); }

  const Grid& grid;
  const single_curve::Constants c;
  const unsigned departed, roots;
  const double per_step, near;
  single_curve::Asked found;
};

// Shows every list to who asks.
struct ListVisit {
  ListVisit(const Grid& all, const Start& start, const ListVisitor& visitor)
      : grid(all),
        asks(visitor),
        per_step(start.scale),
        skipped(start.skipped -
                kNear * static_cast<double>(all.unit) /
                    root(start.step_x * start.step_x + start.step_y * start.step_y)) {}
  void lists(unsigned record) const { asks.list(asks.who, record); }
  bool may_end() const { return true; }
  bool is_end(double exit) const { return asks.is_settled(asks.who, (exit + skipped) * per_step); }

  const Grid& grid;
  const ListVisitor asks;
  const double per_step, skipped;
};

template <class Test>
class Walk : public Test {
 public:
  Walk(const Start& start, const Test& test) : Test(test), start_(start) {}

  void run() {
    const double x = floor_of(start_.from_x), y = floor_of(start_.from_y);
    const double stride = static_cast<double>(this->grid.stride);
    step_[0] = start_.step_y;
    step_[1] = start_.step_x;
    gap_[0] = y + 1 - start_.from_y;
    gap_[1] = x + 1 - start_.from_x;
    const auto p = static_cast<long>(start_.step_x * kFixed + 0.5);
    const auto q = static_cast<long>(start_.step_y * kFixed + 0.5);
    auto e = static_cast<long>((gap_[1] * step_[0] - gap_[0] * step_[1]) * kFixed);
    const long up = static_cast<long>(stride * start_.turn_y) + (1L << kCountY);
    const long across = static_cast<long>(start_.turn_x) + (1L << kCountX);
    auto at = static_cast<long>(static_cast<double>(this->grid.first) +
                                stride * unturned(y, start_.turn_y) + unturned(x, start_.turn_x));
    const long turn_e = p + q, turn_at = across - up;
    const unsigned* const cells = this->grid.cells;
    for (unsigned word = cells[at & kCell];;) {
      if (word <= kOutside) {
        if (word == kOutside || visit(word, at, e < 0)) return;
      }
      do {
        const long is_across = e >> 63;  // all bits
        e += (is_across & turn_e) - p;
        at += up + (is_across & turn_at);
        word = cells[at & kCell];
      } while (word > kOutside);
    }
  }

 private:
  // Tests the walls of a cell; whether nothing can come before what was met.
  __attribute__((noinline)) bool visit(unsigned word, long at, bool is_across) {
    if ((word >> 30) != 0) return cross_divided(word, at, is_across);
    this->lists(word);
    return is_end_of_walk(way(at, true), way(at, false));
  }

  // After a box that ends at these ways in x and y: what is met before the earlier of the two planes, be it crossed
  // next or not. Along an axis, close to a border, e is too coarse to tell, and the other may be met long after.
  bool is_end_of_walk(double way_x, double way_y) const {
    return this->may_end() && this->is_end(smaller(way_x / step_[1], way_y / step_[0]));
  }

  // Cells in x (or y) between the start and the plane by which the cell is left.
  double way(long at, bool in_x) const {
    return gap_[in_x] + static_cast<double>(at >> (in_x ? kCountX : kCountY) & kCount);
  }

  // The cells of a cell. They are entered a little early and left as the cell itself is: so the way
  // has no gap, whatever rounding says of ways close to the borders. As they may be left before the cell itself, only
  // they tell whether the walk ends.
  __attribute__((noinline)) bool cross_divided(unsigned word, long at, bool leave_across) {
    const auto n = static_cast<double>(__builtin_bit_cast(float, word & 0x7f800000U));
    const unsigned* cells = this->grid.cells + 16 * static_cast<unsigned long>(word & 0x7fffffU);
    // Of the lower corner of the cell, as seen from the start.
    const double low_x = way(at, true) - 1, low_y = way(at, false) - 1, part = 1 / n;
    const double into = larger(larger((low_x - kEarly) / step_[1], (low_y - kEarly) / step_[0]), 0);
    const auto place = [&](double within) {
      return static_cast<int>(larger(0, smaller(within * n, n - 1)));
    };
    const int end = static_cast<int>(n);
    int x = place(into * step_[1] - low_x), y = place(into * step_[0] - low_y);
    const auto way_x = [&] { return low_x + (x + 1) * part; };
    const auto way_y = [&] { return low_y + (y + 1) * part; };
    const double p = step_[1] * part, q = step_[0] * part;
    for (double e = way_x() * step_[0] - way_y() * step_[1];;) {
      const int column = start_.turn_x < 0 ? end - 1 - x : x;
      const int row = start_.turn_y < 0 ? end - 1 - y : y;
      const unsigned inner = cells[row * end + column];
      const bool is_across =
          (e < 0 && (leave_across || x + 1 < end)) || (leave_across && y + 1 == end);
      if ((inner >> 31) == 0) {
        this->lists(inner);
        if (is_end_of_walk(way_x(), way_y())) return true;
      }
      e += is_across ? q : -p;
      if ((is_across ? ++x : ++y) == end) return false;
    }
  }

  const Start& start_;
  double step_[2] = {}, gap_[2] = {};  // in y, in x
};

template <class Candidates>
SingleHit answer(const Grid& grid, const SingleRay& ray, const Candidates& candidates) {
  SingleHit hit{candidates.verdict(), candidates.slot, 0};
  if (hit.found >= 0)
    hit.t = crossing_time({ray.ox, ray.oy, ray.dx, ray.dy}, fetch_ends(grid.ends, &hit.slot));
  return hit;
}

SingleHit nearest(const Grid& grid, double ox, double oy, double dx, double dy, unsigned departed) {
  const SingleRay ray{ox, oy, dx, dy, departed};
  Start start;
  const Fate fate = prepare(grid, ray, start);
  if (fate != Fate::walks) return {fate == Fate::misses ? kNoRecord : kDoubt, 0, 0};
  if (grid.cells == nullptr) {
    list::Candidates candidates;
    const auto in_all = [](float value) { return list::all(value); };
    list::test_list(grid, line_of<list::Line>(grid, start, ray.departed, in_all), 0, candidates);
    return answer(grid, ray, candidates);
  }
  const auto in_all = [](float value) { return records::all(value); };
  const Line line = line_of<Line>(grid, start, ray.departed, in_all);
  Walk<SegmentTest> walk(start, SegmentTest(grid, start, line));
  walk.run();
  return answer(grid, ray, walk.found);
}

SingleHit nearest_curve(const Grid& grid, double ox, double oy, double dx, double dy,
                        unsigned departed, unsigned roots, double up_to) {
  const SingleRay ray{ox, oy, dx, dy, departed};
  Start start;
  const Fate fate = prepare(grid, ray, start);
  if (fate != Fate::walks) return {fate == Fate::misses ? kNoRecord : kDoubt, 0, 0};
  Walk<CurveTest> walk(start, CurveTest(grid, start, ray, roots, up_to));
  if (grid.cells == nullptr)
    walk.lists(0);
  else
    walk.run();
  Walking rays{};
  rays.up_to = &up_to;
  rays.is_first = true;
  SingleHit hit{single_curve::verdict(walk.found, rays), 0, 0};
  if (hit.found < 0) return hit;
  hit.slot = static_cast<unsigned>(hit.found & ~kSecond);
  hit.t = circle_time({ox, oy, dx, dy}, fetch_ends(grid.ends, &hit.slot),
                      (hit.found & kSecond) != 0 ? 1 : -1);
  return hit;
}

bool visit_lists(const Grid& grid, double ox, double oy, double dx, double dy,
                 const ListVisitor& visitor) {
  Start start;
  const Fate fate = prepare(grid, {ox, oy, dx, dy, kNone}, start);
  if (fate == Fate::walks) Walk<ListVisit>(start, ListVisit(grid, start, visitor)).run();
  return fate != Fate::uncertain;
}
