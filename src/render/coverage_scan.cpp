#include "render/coverage_scan.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "render/coverage_crowded.h"
#include "render/coverage_exact.h"

namespace flatray {
namespace {

// Few entries come nearly sorted, edge after edge.
template <class Entry>
void sort_by_column(std::vector<Entry>& entries) {
  constexpr std::size_t kFew = 24;
  const auto before = [](const Entry& a, const Entry& b) { return a.column < b.column; };
  if (entries.size() > kFew) {
    std::sort(entries.begin(), entries.end(), before);
    return;
  }
  for (std::size_t i = 1; i < entries.size(); ++i)
    for (std::size_t k = i; k > 0 && before(entries[k], entries[k - 1]); --k)
      std::swap(entries[k], entries[k - 1]);
}

int entering(const Piece& piece) { return piece.crosses_top ? piece.direction : 0; }
int entering(const SimpleCell& cell) { return cell.entering; }

void keep(const Piece& piece, std::vector<Piece>& entries) { entries.push_back(piece); }
void keep(const Piece& piece, std::vector<SimpleCell>& entries) {
  entries.push_back({piece.column, entering(piece), share_of(piece)});
}

// Rows [first, last] of a box an edge meets inside; none for a level edge on a row border, which
// changes nothing.
struct Rows {
  int first, last;
};
Rows rows_of(double top, double bottom, const PixelBox& box) {
  const int first = std::max(floor_column(top), box.y);
  const int end = std::min(ceil_column(bottom), box.y + box.height);
  return {first, end - 1};
}

}  // namespace

CoverageStats AreaScan::scan(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                             const PixelBox& box, RunList& out, CellAudit* audit) {
  box_ = box;
  audit_ = audit;
  stats_ = {};
  edges_.clear();
  const auto height = static_cast<std::size_t>(box.height);
  if (rows_.size() < height) rows_.resize(height);
  if (simple_rows_.size() < height) simple_rows_.resize(height);
  x_.resize(height + 1 + kernels::kSlack);
  columns_.resize(height + 1 + kernels::kSlack);
  first_row_ = box.y + box.height;
  last_row_ = box.y - 1;
  cut_edges(path, chosen);
  for (int row = first_row_; row <= last_row_; ++row) {
    const auto i = static_cast<std::size_t>(row - box.y);
    if (stop_ != nullptr && stop_()) {
      rows_[i].drop();
      simple_rows_[i].drop();
      continue;
    }
    if (path.simple)
      scan_row(path, row, simple_rows_[i], out);
    else
      scan_row(path, row, rows_[i], out);
  }
  return stats_;
}

void AreaScan::cut_edges(const FillPath& path, const std::vector<std::uint32_t>* chosen) {
  if (chosen == nullptr)
    for (const Segment& edge : path.edges) cut_edge(edge, path.simple);
  else
    for (const std::uint32_t index : *chosen) cut_edge(path.edges[index], path.simple);
}

void AreaScan::cut_edge(const Segment& edge, bool simple) {
  const auto [top, bottom] = std::minmax(edge.a.y(), edge.b.y());
  const Rows rows = rows_of(top, bottom, box_);
  if (rows.first > rows.last) return;
  if (std::min(edge.a.x(), edge.b.x()) > box_.x + box_.width) return;
  const auto index = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back(scan_edge(edge, box_));
  first_row_ = std::min(first_row_, rows.first);
  last_row_ = std::max(last_row_, rows.last);
  if (simple)
    cut_rows(index, rows.first, rows.last, simple_rows_);
  else
    cut_rows(index, rows.first, rows.last, rows_);
}

// Rows the edge crosses from border to border come in a batch.
template <class Entry>
void AreaScan::cut_rows(std::uint32_t index, int first, int last,
                        std::vector<ScanRow<Entry>>& rows) {
  constexpr int kWorthABatch = 4;
  const ScanEdge& edge = edges_[index];
  const int whole_first = edge.y_top > first ? first + 1 : first;
  const int whole_last = edge.y_bottom < last + 1 ? last - 1 : last;
  if (whole_last - whole_first + 1 < kWorthABatch) {
    for (int row = first; row <= last; ++row) cut_row(index, row, rows);
    return;
  }
  if (first < whole_first) cut_row(index, first, rows);
  cut_whole_rows(index, whole_first, whole_last, rows);
  if (last > whole_last) cut_row(index, last, rows);
}

template <class Entry>
void AreaScan::cut_row(std::uint32_t index, int row, std::vector<ScanRow<Entry>>& rows) {
  ScanRow<Entry>& work = rows[static_cast<std::size_t>(row - box_.y)];
  const ScanEdge& edge = edges_[index];
  const RowCut cut = row_cut(edge, row);
  if (cut.low >= box_.x + box_.width) return;
  if (cut.crosses_top && cut.first < box_.x) work.winding += edge.direction;
  if (cut.high < box_.x) return;
  walk_row(edge, index, cut, row, box_, [&](const Piece& piece) { keep(piece, work.entries); });
}

// In most rows a steep edge stays in one column for certain; the others are cut one by one.
template <class Entry>
void AreaScan::cut_whole_rows(std::uint32_t index, int first, int last,
                              std::vector<ScanRow<Entry>>& rows) {
  const ScanEdge& edge = edges_[index];
  kernels_.edge_columns(edge_line(edge), first, static_cast<std::size_t>(last - first + 2), 0,
                        x_.data(), columns_.data());
  Piece piece = whole_piece(edge, index);
  for (int row = first; row <= last; ++row) {
    const auto i = static_cast<std::size_t>(row - first);
    const double column = columns_[i];
    if (column != columns_[i + 1] || column == kernels::kNoColumn) {
      cut_row(index, row, rows);
      continue;
    }
    ScanRow<Entry>& work = rows[static_cast<std::size_t>(row - box_.y)];
    if (column < box_.x) work.winding += edge.direction;
    if (column < box_.x || column >= box_.x + box_.width) continue;
    piece.column = static_cast<int>(column);
    piece.x_top = x_[i] - column;
    piece.x_bottom = x_[i + 1] - column;
    keep(piece, work.entries);
  }
}

template <class Entry>
void AreaScan::scan_row(const FillPath& path, int row, ScanRow<Entry>& work, RunList& out) {
  std::vector<Entry>& entries = work.entries;
  sort_by_column(entries);
  int winding = work.winding, x = box_.x;
  for (std::size_t i = 0, end; i < entries.size(); i = end) {
    const int column = entries[i].column;
    int change = 0;
    for (end = i; end < entries.size() && entries[end].column == column; ++end)
      change += entering(entries[end]);
    if (covers(path.rule, winding)) out.add(row, x, column, kFullCoverage);
    const std::span<const Entry> cell(&entries[i], end - i);
    out.add(row, column, column + 1, steps(path, cell, winding, row));
    winding += change;
    x = column + 1;
  }
  if (covers(path.rule, winding)) out.add(row, x, box_.x + box_.width, kFullCoverage);
  work.drop();
}

std::uint32_t AreaScan::steps(const FillPath& path, std::span<const SimpleCell> cell, int winding,
                              int row) {
  ShareSum sum;
  for (const SimpleCell& one : cell) sum.add(one.share);
  const int column = cell.front().column;
  return decide(
      simple_area(sum, winding), [&] { gather(column, row); }, path.rule, winding, column, row);
}

std::uint32_t AreaScan::steps(const FillPath& path, std::span<const Piece> cell, int winding,
                              int row) {
  const int column = cell.front().column;
  if (cell.size() > kCrowd && audit_ == nullptr) {
    if (path.rule == FillRule::nonzero && certainly_full(cell, winding)) {
      ++stats_.edge_pixels;
      return kFullCoverage;
    }
    gather(cell);
    const int outer = without_touching(winding, column, row);
    join_equal();
    const bool crowded = is_crowded(exact_edges_, column, row);
    if (crowded || exact_edges_.size() <= kCrowd) {
      ++stats_.edge_pixels;
      stats_.exact_fallbacks += crowded ? 0 : 1;
      return (crowded ? &crowded_steps : &exact_steps)(exact_edges_, outer, column, row, path.rule);
    }
  }
  return decide(
      cell_area(cell, winding, path.rule, slabs_), [&] { gather(cell); }, path.rule, winding,
      column, row);
}

template <class Touching>
std::uint32_t AreaScan::decide(const CellArea& area, const Touching& touching, FillRule rule,
                               int winding, int column, int row) {
  ++stats_.edge_pixels;
  const std::optional<std::uint32_t> certain = certain_steps(area);
  if (certain && audit_ == nullptr) return *certain;
  touching();
  winding = without_touching(winding, column, row);
  if (audit_ != nullptr) audit_->see(area, exact_area(exact_edges_, winding, column, row, rule));
  if (certain) return *certain;
  if (is_crowded(exact_edges_, column, row))  // of a simple path: within a step
    return static_cast<std::uint32_t>(kFullCoverage * area.area);
  ++stats_.exact_fallbacks;
  return exact_steps(exact_edges_, winding, column, row, rule);
}

void AreaScan::gather(std::span<const Piece> cell) {
  touching_.clear();
  for (const Piece& piece : cell) touching_.push_back(piece.edge);
  std::sort(touching_.begin(), touching_.end());
  touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
}

void AreaScan::gather(int column, int row) {
  touching_.clear();
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Rows rows = rows_of(edges_[i].y_top, edges_[i].y_bottom, box_);
    if (row < rows.first || row > rows.last) continue;
    const RowCut cut = row_cut(edges_[i], row);
    if (cut.low <= column && column <= cut.high) touching_.push_back(i);
  }
}

// The winding as counted has the touching edges in it where they passed left of the pixel.
int AreaScan::without_touching(int winding, int column, int row) {
  exact_edges_.clear();
  for (const std::uint32_t index : touching_) {
    const ScanEdge& edge = edges_[index];
    exact_edges_.push_back(edge);
    const RowCut cut = row_cut(edge, row);
    if (cut.crosses_top && cut.first < column) winding -= edge.direction;
  }
  return winding;
}

// Edges that lie on one another become one of all their directions.
void AreaScan::join_equal() {
  const auto ends = [](const ScanEdge& e) {
    return std::tie(e.x_top, e.y_top, e.x_bottom, e.y_bottom);
  };
  std::sort(exact_edges_.begin(), exact_edges_.end(),
            [&](const ScanEdge& a, const ScanEdge& b) { return ends(a) < ends(b); });
  auto last = exact_edges_.begin();
  for (auto edge = last; ++edge != exact_edges_.end();) {
    if (ends(*last) == ends(*edge))
      last->direction += edge->direction;
    else
      *++last = *edge;
  }
  exact_edges_.erase(last + 1, exact_edges_.end());
}

}  // namespace flatray
