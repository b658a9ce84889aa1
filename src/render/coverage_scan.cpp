#include "render/coverage_scan.h"

#include <algorithm>
#include <cmath>

#include "render/coverage_exact.h"

namespace flatray {
namespace {

// Few pieces come nearly sorted, edge after edge from left to right.
void sort_by_column(std::vector<Piece>& pieces) {
  constexpr std::size_t kFew = 24;
  const auto before = [](const Piece& a, const Piece& b) { return a.column < b.column; };
  if (pieces.size() > kFew) {
    std::sort(pieces.begin(), pieces.end(), before);
    return;
  }
  for (std::size_t i = 1; i < pieces.size(); ++i)
    for (std::size_t k = i; k > 0 && before(pieces[k], pieces[k - 1]); --k)
      std::swap(pieces[k], pieces[k - 1]);
}

}  // namespace

CoverageStats AreaScan::scan(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                             const PixelBox& box, RunList& out, CellAudit* audit) {
  box_ = box;
  audit_ = audit;
  stats_ = {};
  edges_.clear();
  if (rows_.size() < static_cast<std::size_t>(box.height))
    rows_.resize(static_cast<std::size_t>(box.height));
  cut_edges(path, chosen);
  for (int row = box.y; row < box.y + box.height; ++row) scan_row(path, row, out);
  return stats_;
}

void AreaScan::cut_edges(const FillPath& path, const std::vector<std::uint32_t>* chosen) {
  if (chosen == nullptr)
    for (const Segment& edge : path.edges) cut_edge(edge);
  else
    for (const std::uint32_t index : *chosen) cut_edge(path.edges[index]);
}

void AreaScan::cut_edge(const Segment& edge) {
  const auto [high, low] = std::minmax(edge.a.y(), edge.b.y());
  const double top = box_.y, bottom = box_.y + box_.height;
  if (low <= top || high >= bottom) return;  // a level edge on a row border changes nothing
  if (high == low && high == std::floor(high)) return;
  if (std::min(edge.a.x(), edge.b.x()) > box_.x + box_.width) return;
  const auto index = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back(scan_edge(edge, box_));
  const ScanEdge& ready = edges_.back();
  const int first = static_cast<int>(std::floor(std::max(high, top)));
  const int last = high == low ? first : static_cast<int>(std::ceil(std::min(low, bottom))) - 1;
  for (int row = first; row <= last; ++row)
    cut_row(ready, index, row, box_, rows_[static_cast<std::size_t>(row - box_.y)]);
}

void AreaScan::scan_row(const FillPath& path, int row, RunList& out) {
  PieceRow& work = rows_[static_cast<std::size_t>(row - box_.y)];
  std::vector<Piece>& pieces = work.pieces;
  sort_by_column(pieces);
  int winding = work.winding, x = box_.x;
  const auto flat = [&](int end) {
    if (covers(path.rule, winding)) out.add(row, x, end, kFullCoverage);
  };
  for (std::size_t i = 0, end; i < pieces.size(); i = end) {
    const int column = pieces[i].column;
    int entering = 0;
    for (end = i; end < pieces.size() && pieces[end].column == column; ++end)
      if (pieces[end].crosses_top) entering += pieces[end].direction;
    flat(column);
    out.add(row, column, column + 1,
            cell_steps(path, std::span(pieces).subspan(i, end - i), winding, row));
    winding += entering;
    x = column + 1;
  }
  flat(box_.x + box_.width);
  pieces.clear();
  work.winding = 0;
}

std::uint32_t AreaScan::cell_steps(const FillPath& path, std::span<const Piece> cell, int winding,
                                   int row) {
  const CellArea area =
      path.simple ? simple_area(cell, winding) : cell_area(cell, winding, path.rule, slabs_);
  ++stats_.edge_pixels;
  if (audit_ != nullptr) audit_->see(area, exact_cell(path, cell, winding, row));
  if (const auto steps = certain_steps(area)) return *steps;
  ++stats_.exact_fallbacks;
  Rational steps = exact_cell(path, cell, winding, row);
  steps *= kFullCoverage;
  return static_cast<std::uint32_t>(steps.floor().nearest());
}

Rational AreaScan::exact_cell(const FillPath& path, std::span<const Piece> cell, int winding,
                              int row) {
  const int column = cell.front().column;
  touching_.clear();
  for (const Piece& piece : cell) touching_.push_back(piece.edge);
  std::sort(touching_.begin(), touching_.end());
  touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
  exact_edges_.clear();
  for (const std::uint32_t index : touching_) {
    const ScanEdge& edge = edges_[index];
    exact_edges_.push_back(edge);
    const RowCut cut = row_cut(edge, row);
    if (cut.crosses_top && cut.first < column) winding -= edge.direction;
  }
  return exact_area(exact_edges_, winding, column, row, path.rule);
}

}  // namespace flatray
