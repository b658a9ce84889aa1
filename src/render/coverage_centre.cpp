#include <algorithm>
#include <cmath>

#include "render/coverage_scan.h"

namespace flatray {
namespace {

// Whether the centre of a column lies on or right of an edge that spans the row of centres at y.
bool right_of(const ScanEdge& e, int column, double y) {
  const Rational dx = Rational(e.x_bottom) - Rational(e.x_top);
  const Rational dy = Rational(e.y_bottom) - Rational(e.y_top);
  const Rational along = (Rational(y) - Rational(e.y_top)) * dx;
  return (Rational(column + 0.5) - Rational(e.x_top)) * dy >= along;
}

// First column of the box, or the one past its end, whose centre is on or right of the edge.
int first_right(const ScanEdge& e, double y, const PixelBox& box, CoverageStats& stats) {
  const double x = y == e.y_top ? e.x_top : e.x_at(y);
  const double error = y == e.y_top ? 0 : e.error_x;
  const double begin = box.x, end = box.x + box.width;
  // A margin of an ulp for the sums here.
  const double slack = error > 0 ? error + 0x1p-52 * std::abs(x) : 0;
  double low = std::clamp(std::ceil(x - 0.5 - slack), begin, end);
  double high = std::clamp(std::ceil(x - 0.5 + slack), begin, end);
  if (low < high) ++stats.exact_fallbacks;
  while (low < high) {
    const double middle = std::floor(0.5 * (low + high));
    if (right_of(e, static_cast<int>(middle), y))
      high = middle;
    else
      low = middle + 1;
  }
  return static_cast<int>(low);
}

}  // namespace

void CentreScan::add_edge(const Segment& edge) {
  const auto [top, bottom] = std::minmax(edge.a.y(), edge.b.y());
  // Rows with top <= row + 1/2 < bottom; row + 1/2 is exact, the difference need not be.
  int first = std::max(floor_column(top), box_.y);
  if (first + 0.5 < top) ++first;
  int last = std::min(floor_column(bottom), box_.y + box_.height - 1);
  if (last + 0.5 >= bottom) --last;
  if (first > last || std::min(edge.a.x(), edge.b.x()) > box_.x + box_.width) return;
  const ScanEdge ready = scan_edge(edge, box_);
  kernels_.edge_columns(edge_line(ready), first + 0.5, static_cast<std::size_t>(last - first + 1),
                        0.5, x_.data(), columns_.data());
  const int end = box_.x + box_.width;
  for (int row = first; row <= last; ++row) {
    const double certain = columns_[static_cast<std::size_t>(row - first)];
    const int column = certain == kernels::kNoColumn
                           ? first_right(ready, row + 0.5, box_, stats_)
                           : static_cast<int>(std::clamp<double>(certain, box_.x, end));
    if (column < end) add_step(row, column, ready.direction);
  }
}

void CentreScan::begin_rows() {
  few_steps_ = true;
  steps_.clear();
  first_row_ = box_.y + box_.height;
  last_row_ = box_.y - 1;
  rows_.resize(static_cast<std::size_t>(box_.height));
  for (FewSteps& row : rows_) row.count = 0;
}

// Rows of convex regions have two steps, which need no sorting.
void CentreScan::add_step(int row, int column, int change) {
  ++stats_.edge_pixels;
  if (!few_steps_) return steps_.push_back({row, column, change});
  FewSteps& few = rows_[static_cast<std::size_t>(row - box_.y)];
  first_row_ = std::min(first_row_, row);
  last_row_ = std::max(last_row_, row);
  if (few.count < few.steps.size()) {
    few.steps[few.count++] = {row, column, change};
    return;
  }
  few_steps_ = false;
  for (const FewSteps& of_row : rows_)
    steps_.insert(steps_.end(), of_row.steps.begin(), of_row.steps.begin() + of_row.count);
  steps_.push_back({row, column, change});
}

void CentreScan::add_runs_of_few(FillRule rule, RunList& out) {
  const int end = box_.x + box_.width;
  for (int row = first_row_; row <= last_row_; ++row) {
    FewSteps& few = rows_[static_cast<std::size_t>(row - box_.y)];
    if (few.count == 0) continue;
    auto [first, second] = few.steps;
    if (few.count == 1) second = {row, end, 0};
    if (second.column < first.column) std::swap(first, second);
    if (covers(rule, first.change)) out.add(row, first.column, second.column, kFullCoverage);
    if (covers(rule, first.change + second.change)) out.add(row, second.column, end, kFullCoverage);
  }
}

void CentreScan::add_runs(FillRule rule, RunList& out) {
  std::sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  int winding = 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    winding += steps_[i].change;
    const bool last = i + 1 == steps_.size() || steps_[i + 1].row != steps_[i].row;
    if (covers(rule, winding))
      out.add(steps_[i].row, steps_[i].column, last ? box_.x + box_.width : steps_[i + 1].column,
              kFullCoverage);
    if (last) winding = 0;
  }
}

CoverageStats CentreScan::scan(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                               const PixelBox& box, RunList& out) {
  box_ = box;
  stats_ = {};
  begin_rows();
  x_.resize(static_cast<std::size_t>(box.height) + kernels::kSlack);
  columns_.resize(x_.size());
  if (chosen == nullptr)
    for (const Segment& edge : path.edges) add_edge(edge);
  else
    for (const std::uint32_t index : *chosen) add_edge(path.edges[index]);
  if (few_steps_)
    add_runs_of_few(path.rule, out);
  else
    add_runs(path.rule, out);
  return stats_;
}

}  // namespace flatray
