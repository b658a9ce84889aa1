#include "render/coverage_monotone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flatray {
namespace {

constexpr double kHalfUlp = 0x1p-53;  // u: half an ulp of 1

// Needs |x| far below 2^31.
int floor_of(double x) {
  const int cut = static_cast<int>(x);
  return cut - (cut > x ? 1 : 0);
}

}  // namespace

// Steps of an area where the bound decides them.
struct MonotoneScan::Decider {
  double slack;
  bool open = false;

  std::uint32_t operator()(double area) {
    const double steps = kFullCoverage * area;
    const int low = static_cast<int>(std::max(steps - slack, 0.0));
    const int high = static_cast<int>(std::min<double>(steps + slack, kFullCoverage));
    open |= low != high;
    return static_cast<std::uint32_t>(low);
  }
};

// A straight cut across a row or a part of it, from column to column.
struct MonotoneScan::Cut {
  double x0, x1, height, scale = 0;
  int first, last;  ///< columns it may touch

  Cut(double x_a, double x_b, double height_, double error)
      : x0(std::min(x_a, x_b)),
        x1(std::max(x_a, x_b)),
        height(height_),
        first(floor_of(x0 - error)),
        last(floor_of(x1 + error)) {
    constexpr double kNarrow = 0x1p-100;
    if (first < last && x1 - x0 > kNarrow) scale = 0.5 * height / (x1 - x0);
  }
  // Area between the cut and a column's border, where that lies right of some of it.
  double left_of(int border) const {
    const double t = clamp_to(border - x0, 0, x1 - x0);
    return t * scale * t;
  }
  double left_of_last() const { return height * (last + 1 - 0.5 * (x0 + x1)); }
};

// One way down the ring, edge after edge.
struct MonotoneScan::Side {
  MonotoneRing ring;
  bool forward;                    ///< along the ring
  Corner upper{}, lower{};         ///< ends of the edge
  double slope = 0, x = 0, y = 0;  ///< where the last cut ended
  std::size_t corner = 0;
  int first = 0, last = 0;  ///< columns it may touch in the row
  double sign;              ///< of the area right of it

  Side(MonotoneRing ring_, bool forward_)
      : ring(ring_), forward(forward_), lower(ring_[0]), y(lower.y), sign(forward_ ? 1 : -1) {}

  void next_edge() {
    upper = lower;
    corner = forward ? corner + 1 : (corner == 0 ? ring.size() : corner) - 1;
    lower = ring[corner];
    x = upper.x;
    slope = (lower.x - upper.x) / (lower.y - upper.y);
  }
  double x_at(double at) const {
    const double along = upper.x + (at - upper.y) * slope;
    return upper.x < lower.x ? clamp_to(along, upper.x, lower.x)
                             : clamp_to(along, lower.x, upper.x);
  }
};

std::optional<CoverageStats> MonotoneScan::scan(MonotoneRing ring, Coverage mode,
                                                const PixelBox& box, RunList& out) {
  box_ = box;
  stats_ = {};
  const bool done = mode == Coverage::centre ? scan_centres(ring, out) : scan_area(ring, out);
  if (!done) return std::nullopt;
  return stats_;
}

bool MonotoneScan::scan_centres(MonotoneRing ring, RunList& out) {
  const auto height = static_cast<std::size_t>(box_.height);
  if (room_.size() < 2 * height + 4 * kernels::kSlack)
    room_.resize(2 * height + 4 * kernels::kSlack);
  Run* const runs = out.room(height);
  const std::size_t count = kernels_.centre_runs(
      ring.data(), ring.size(), {box_.x, box_.y, box_.width, box_.height}, room_.data(), runs);
  if (count == kernels::kUndecided) return false;
  out.keep(count);
  stats_.edge_pixels += 2 * count;
  return true;
}

// The bounds hold for all edges of the ring at once (docs/NUMERICS.md, coverage).
void MonotoneScan::measure(MonotoneRing ring) {
  double low = ring[0].x, high = low;
  top_ = bottom_ = ring[0].y;
  for (const Corner& corner : ring) {
    low = std::min(low, corner.x);
    high = std::max(high, corner.x);
    bottom_ = std::max(bottom_, corner.y);
  }
  const double width = high - low, far = std::max(-low, high);
  error_x_ = kHalfUlp * (6 * width + 2 * far + 8);
  slack_ = kFullCoverage * kHalfUlp *
               (64 * (width + 1) + 8 * far + 8 * static_cast<double>(ring.size()) * (width + 4)) +
           0x1p-36;
}

bool MonotoneScan::scan_area(MonotoneRing ring, RunList& out) {
  measure(ring);
  const int first = std::max(floor_column(top_), box_.y);
  const int end = std::min(ceil_column(bottom_), box_.y + box_.height);
  if (top_ == bottom_ || first >= end) return true;
  changes_.resize(static_cast<std::size_t>(box_.width) + 2);
  doubt_ = false;
  Side down(ring, true), up(ring, false);
  enter(down);
  enter(up);
  for (int row = first; row < end && !doubt_; ++row) {
    if (add_whole_row(row, down, up, out)) continue;
    const double row_end = std::min(row + 1.0, bottom_);
    cut_row(down, row_end);
    cut_row(up, row_end);
    if (down.first < up.first)
      add_row(row, down, up, out);
    else
      add_row(row, up, down, out);
  }
  if (doubt_) out.drop();
  return !doubt_;
}

void MonotoneScan::enter(Side& side) {
  const double top = box_.y;
  if (!(side.y < top)) return;
  while (side.lower.y <= top) next_edge(side);
  if (side.upper.y < top) side.x = side.x_at(top);
  side.y = top;
}

void MonotoneScan::next_edge(Side& side) {
  side.next_edge();
  doubt_ |= std::isinf(side.slope) && side.lower.y > side.upper.y;
}

void MonotoneScan::cut_row(Side& side, double end) {
  side.first = std::numeric_limits<int>::max();
  side.last = std::numeric_limits<int>::min();
  while (side.y < end) {
    if (side.lower.y <= side.y) {
      next_edge(side);
    } else if (side.lower.y <= end) {
      cut(side, side.lower.x, side.lower.y);
    } else {
      cut(side, side.x_at(end), end);
    }
  }
}

// From the side's last cut to (x, y), in one row.
void MonotoneScan::cut(Side& side, double x, double y) {
  const Cut cut(side.x, x, y - side.y, error_x_);
  side.x = x;
  side.y = y;
  side.first = std::min(side.first, cut.first);
  side.last = std::max(side.last, cut.last);
  const int left = box_.x, right = left + box_.width;
  if (cut.first >= right) return;
  if (cut.last < left) {
    changes_[0] += side.sign * cut.height;
    return;
  }
  if (cut.first == cut.last) {
    const double area = cut.left_of_last();
    double* const change = &changes_[static_cast<std::size_t>(cut.first - left)];
    change[0] += side.sign * area;
    change[1] += side.sign * (cut.height - area);
    return;
  }
  int column = std::max(cut.first, left);
  double* change = &changes_[static_cast<std::size_t>(column - left)];
  double total = column > cut.first ? cut.left_of(column) : 0, area = 0;
  const auto take = [&](double next_total) {
    const double next_area = next_total - total;
    *change++ += side.sign * (next_area - area);
    total = next_total;
    area = next_area;
  };
  for (; column < std::min(cut.last, right); ++column) take(cut.left_of(column + 1));
  if (cut.last >= right) return;
  take(cut.left_of_last());
  *change += side.sign * (cut.height - area);
}

// Most rows: one edge on each side, from border to border, and pixels between them. Their areas
// need no sums.
bool MonotoneScan::add_whole_row(int row, Side& a, Side& b, RunList& out) {
  const double end = row + 1.0;
  if (a.y > row || b.y > row || !(a.lower.y > end) || !(b.lower.y > end)) return false;
  const double a_x = a.x_at(end), b_x = b.x_at(end);
  const Cut a_cut(a.x, a_x, 1, error_x_), b_cut(b.x, b_x, 1, error_x_);
  const bool swapped = b_cut.first < a_cut.first;
  const Cut &left = swapped ? b_cut : a_cut, &right = swapped ? a_cut : b_cut;
  if (left.last >= right.first) return false;
  a.x = a_x, a.y = end;
  b.x = b_x, b.y = end;
  const int begin = box_.x, box_end = begin + box_.width;
  Run* const runs = out.room(static_cast<std::size_t>(box_.width) + 1);
  Run* run = put_side<true>(row, left, runs);
  const int from = std::max(left.last + 1, begin), to = std::min(right.first, box_end);
  *run = {row, from, to, kFullCoverage};
  run = put_side<false>(row, right, run + (from < to ? 1 : 0));
  out.keep(static_cast<std::size_t>(run - runs));
  stats_.edge_pixels += static_cast<std::uint64_t>(run - runs);
  return true;
}

// The pixels a side touches, in a row it crosses from border to border.
template <bool kLeft>
Run* MonotoneScan::put_side(int row, const Cut& cut, Run* run) {
  const int begin = box_.x, stop = std::min(cut.last + 1, begin + box_.width);
  int column = std::max(cut.first, begin);
  double total = column > cut.first ? cut.left_of(column) : 0;
  Decider decide{slack_};
  for (; column < stop; ++column) {
    const double next = column < cut.last ? cut.left_of(column + 1) : cut.left_of_last();
    const double right_of = next - total;
    const std::uint32_t steps = decide(kLeft ? right_of : 1 - right_of);
    *run = {row, column, column + 1, steps};
    run += steps != 0 ? 1 : 0;
    total = next;
  }
  doubt_ |= decide.open;
  return run;
}

// Between the sides all pixels are alike: no edge but a level one touches them.
void MonotoneScan::add_row(int row, const Side& left, const Side& right, RunList& out) {
  const auto within = [&](int column) { return std::clamp(column - box_.x, 0, box_.width); };
  const int middle = within(left.last + 1), right_first = within(right.first);
  const int end = within(std::max(left.last, right.last) + 1);
  area_ = 0;
  int column = within(left.first);
  Run* const runs = out.room(static_cast<std::size_t>(box_.width) + 1);
  Run* run = put_pixels(row, column, middle, runs);
  column = std::max(column, middle);
  if (column < right_first) {
    area_ += std::exchange(changes_[static_cast<std::size_t>(column)], 0.0);
    Decider decide{slack_};
    const bool whole = top_ <= row && row + 1.0 <= bottom_;
    const std::uint32_t steps = whole ? kFullCoverage : decide(std::abs(area_));
    *run = {row, box_.x + column, box_.x + right_first, steps};
    run += steps != 0 ? 1 : 0;
    doubt_ |= decide.open;
    column = right_first;
  }
  run = put_pixels(row, column, end, run);
  changes_[static_cast<std::size_t>(end)] = 0;
  out.keep(static_cast<std::size_t>(run - runs));
  stats_.edge_pixels += static_cast<std::uint64_t>(run - runs);
}

Run* MonotoneScan::put_pixels(int row, int column, int end, Run* run) {
  Decider decide{slack_};
  double area = area_, *change = changes_.data() + column;
  for (; column < end; ++column, ++change) {
    area += *change;
    *change = 0;
    const std::uint32_t steps = decide(std::abs(area));
    *run = {row, box_.x + column, box_.x + column + 1, steps};
    run += steps != 0 ? 1 : 0;
  }
  area_ = area;
  doubt_ |= decide.open;
  return run;
}

}  // namespace flatray
