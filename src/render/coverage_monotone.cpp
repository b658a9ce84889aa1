#include "render/coverage_monotone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flatray {
namespace {

constexpr double kUnit = 0x1p-53;  // u: half an ulp of 1

}  // namespace

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
  error_x_ = kUnit * (6 * width + 2 * far + 8);
  slack_ = kFullCoverage * kUnit *
               (64 * (width + 1) + 8 * far + 8 * static_cast<double>(ring.size()) * (width + 4)) +
           0x1p-36;
}

bool MonotoneScan::scan_area(MonotoneRing ring, RunList& out) {
  measure(ring);
  const int first = std::max(floor_column(top_), box_.y);
  const int end = std::min(ceil_column(bottom_), box_.y + box_.height);
  if (first >= end) return true;
  changes_.resize(static_cast<std::size_t>(box_.width) + 2);
  doubt_ = false;
  Side down(ring, true), up(ring, false);
  enter(down);
  enter(up);
  for (int row = first; row < end && !doubt_; ++row) {
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
  const double height = y - side.y;
  const auto [x0, x1] = std::minmax(side.x, x);
  const int first = floor_column(x0 - error_x_), last = floor_column(x1 + error_x_);
  side.first = std::min(side.first, first);
  side.last = std::max(side.last, last);
  if (last < box_.x) {
    changes_[0] += side.sign * height;
  } else if (first == last && first < box_.x + box_.width) {
    const double area = height * (first + 1 - 0.5 * (x0 + x1));
    double* const change = &changes_[static_cast<std::size_t>(first - box_.x)];
    change[0] += side.sign * area;
    change[1] += side.sign * (height - area);
  } else if (first < box_.x + box_.width) {
    cut_columns(side, x0, x1, height, first, last);
  }
  side.x = x;
  side.y = y;
}

// The area right of the cut and left of the border at x0 + t is height t^2 / 2 (x1 - x0).
void MonotoneScan::cut_columns(const Side& side, double x0, double x1, double height, int first,
                               int last) {
  constexpr double kNarrow = 0x1p-100;
  const double width = x1 - x0, scale = width > kNarrow ? 0.5 * height / width : 0;
  const auto left_of = [&](int border) {
    const double t = clamp_to(border - x0, 0, width);
    return t * scale * t;
  };
  const int left = box_.x, right = left + box_.width;
  int column = std::max(first, left);
  double* change = &changes_[static_cast<std::size_t>(column - left)];
  double total = column > first ? left_of(column) : 0, area = 0;
  const auto take = [&](double next_total) {
    const double next_area = next_total - total;
    *change++ += side.sign * (next_area - area);
    total = next_total;
    area = next_area;
  };
  for (; column < std::min(last, right); ++column) take(left_of(column + 1));
  if (last >= right) return;
  take(height * (last + 1 - 0.5 * (x0 + x1)));
  *change += side.sign * (height - area);
}

// Between the sides all pixels are alike: no edge but a level one touches them.
void MonotoneScan::add_row(int row, const Side& left, const Side& right, RunList& out) {
  const auto within = [&](int column) { return std::clamp(column - box_.x, 0, box_.width); };
  const int middle = within(left.last + 1), right_first = within(right.first);
  const int end = within(std::max(left.last, right.last) + 1);
  area_ = 0;
  int column = add_pixels(row, within(left.first), middle, out);
  if (column < right_first) {
    area_ += std::exchange(changes_[static_cast<std::size_t>(column)], 0.0);
    const bool whole = top_ <= row && row + 1.0 <= bottom_;
    out.add(row, box_.x + column, box_.x + right_first, whole ? kFullCoverage : decided_steps());
    column = right_first;
  }
  add_pixels(row, column, end, out);
  changes_[static_cast<std::size_t>(end)] = 0;
}

int MonotoneScan::add_pixels(int row, int column, int end, RunList& out) {
  for (; column < end; ++column) {
    area_ += std::exchange(changes_[static_cast<std::size_t>(column)], 0.0);
    out.add(row, box_.x + column, box_.x + column + 1, decided_steps());
    ++stats_.edge_pixels;
  }
  return column;
}

std::uint32_t MonotoneScan::decided_steps() {
  const double steps = kFullCoverage * std::abs(area_);
  const int low = static_cast<int>(std::max(steps - slack_, 0.0));
  const int high = static_cast<int>(std::min<double>(steps + slack_, kFullCoverage));
  doubt_ |= low != high;
  return static_cast<std::uint32_t>(low);
}

}  // namespace flatray
