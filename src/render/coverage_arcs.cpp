#include "render/coverage_arcs.h"

namespace flatray {
namespace {

// As row_cut of straight edges: a column border belongs to the pixel right of it, and where an edge
// leaves by a row border it stays in the pixel it comes through.
RowCut row_cut(const ArcEdge& e, int row) {
  const double top = row, bottom = row + 1.0;
  RowCut cut{};
  cut.starts = e.y_top >= top;
  cut.ends = e.y_bottom <= bottom;
  cut.crosses_top = e.y_top <= top;
  cut.y_in = cut.starts ? e.y_top : top;
  cut.y_out = cut.ends ? e.y_bottom : bottom;
  cut.x_in = cut.starts ? e.x_top : e.x_at(top);
  cut.x_out = cut.ends ? e.x_bottom : e.x_at(bottom);
  const bool from_border = cut.y_in <= top, to_border = cut.y_out >= bottom;
  cut.first = floor_column(cut.x_in);
  cut.last = floor_column(cut.x_out);
  if (cut.x_in < cut.x_out && to_border) cut.last = ceil_column(cut.x_out) - 1;
  if (cut.x_out < cut.x_in && from_border) cut.first = ceil_column(cut.x_in) - 1;
  if (cut.x_in == cut.x_out) cut.last = cut.first;
  return cut;
}

}  // namespace

CoverageStats ArcScan::scan(const FillArcs& arcs, Coverage mode, const PixelBox& box,
                            RunList& out) {
  box_ = box;
  mode_ = mode;
  stats_ = {};
  const auto height = static_cast<std::size_t>(box.height);
  if (rows_.size() < height) rows_.resize(height);
  add_path(arcs.path);
  for (int y = 0; y < box.height; ++y) {
    ScanRow<SimpleCell>& work = rows_[static_cast<std::size_t>(y)];
    std::sort(work.entries.begin(), work.entries.end(),
              [](const SimpleCell& a, const SimpleCell& b) { return a.column < b.column; });
    if (mode == Coverage::area)
      scan_row(box.y + y, work, out);
    else
      centre_row(box.y + y, work, out);
    work.entries.clear();
    work.winding = 0;
  }
  return stats_;
}

void ArcScan::add_path(const ArcPath& path) {
  const std::size_t count = path.arcs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const EllipseArc &arc = path.arcs[i], &next = path.arcs[(i + 1) % count];
    for (const MonotoneArc& part : monotone_parts(arc)) add({arc, part});
    add({arc.end(), next.start()});
  }
}

void ArcScan::add(const ArcEdge& edge) {
  if (std::min(edge.x_top, edge.x_bottom) > box_.x + box_.width) return;
  if (mode_ == Coverage::centre) return cut_centres(edge);
  const int first = std::max(floor_column(edge.y_top), box_.y);
  const int end = std::min(ceil_column(edge.y_bottom), box_.y + box_.height);
  for (int row = first; row < end; ++row) cut_row(edge, row);
}

void ArcScan::cut_row(const ArcEdge& edge, int row) {
  ScanRow<SimpleCell>& work = rows_[static_cast<std::size_t>(row - box_.y)];
  const RowCut cut = row_cut(edge, row);
  if (std::min(cut.first, cut.last) >= box_.x + box_.width) return;
  if (cut.crosses_top && cut.first < box_.x) work.winding += edge.direction;
  if (std::max(cut.first, cut.last) >= box_.x) walk(edge, cut, row, work);
}

void ArcScan::walk(const ArcEdge& edge, const RowCut& cut, int row, ScanRow<SimpleCell>& work) {
  const bool rightward = cut.first <= cut.last;
  const double top = row;
  const auto border = [&](int column) {
    return clamp_to(edge.y_at(column), cut.y_in, cut.y_out) - top;
  };
  Piece piece{};
  piece.direction = static_cast<std::int8_t>(edge.direction);
  piece.exact = true;  // no bound is kept of what follows
  const int low = std::max(std::min(cut.first, cut.last), box_.x);
  const int high = std::min(std::max(cut.first, cut.last), box_.x + box_.width - 1);
  for (int c = low; c <= high; ++c) {
    const bool is_first = c == cut.first, is_last = c == cut.last;
    piece.x_top = is_first ? cut.x_in - c : rightward ? 0 : 1;
    piece.x_bottom = is_last ? cut.x_out - c : rightward ? 1 : 0;
    piece.y_top = is_first ? cut.y_in - top : border(rightward ? c : c + 1);
    piece.y_bottom = is_last ? cut.y_out - top : border(rightward ? c + 1 : c);
    piece.left_top = rightward && !is_first;
    piece.left_bottom = !rightward && !is_last;
    Share share = share_of(piece);
    share.area +=
        edge.direction * edge.bow({piece.x_bottom - piece.x_top, piece.y_bottom - piece.y_top});
    work.entries.push_back({c, is_first && cut.crosses_top ? edge.direction : 0, share});
  }
}

void ArcScan::scan_row(int row, ScanRow<SimpleCell>& work, RunList& out) {
  const std::vector<SimpleCell>& entries = work.entries;
  int winding = work.winding, x = box_.x;
  for (std::size_t i = 0, end; i < entries.size(); i = end) {
    const int column = entries[i].column;
    int change = 0;
    ShareSum sum;
    for (end = i; end < entries.size() && entries[end].column == column; ++end) {
      change += entries[end].entering;
      sum.add(entries[end].share);
    }
    if (winding != 0) out.add(row, x, column, kFullCoverage);
    const double area = simple_area(sum, winding).area;
    out.add(row, column, column + 1, static_cast<std::uint32_t>(kFullCoverage * area));
    ++stats_.edge_pixels;
    winding += change;
    x = column + 1;
  }
  if (winding != 0) out.add(row, x, box_.x + box_.width, kFullCoverage);
}

// The winding changes from the first centre on or right of the edge.
void ArcScan::cut_centres(const ArcEdge& edge) {
  int first = std::max(floor_column(edge.y_top), box_.y);
  if (first + 0.5 < edge.y_top) ++first;
  for (int row = first; row < box_.y + box_.height && row + 0.5 < edge.y_bottom; ++row) {
    const int column = std::max(ceil_column(edge.x_at(row + 0.5) - 0.5), box_.x);
    if (column < box_.x + box_.width)
      rows_[static_cast<std::size_t>(row - box_.y)].entries.push_back({column, edge.direction, {}});
  }
}

void ArcScan::centre_row(int row, ScanRow<SimpleCell>& work, RunList& out) {
  const std::vector<SimpleCell>& entries = work.entries;
  int winding = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    winding += entries[i].entering;
    const bool last = i + 1 == entries.size();
    if (winding != 0)
      out.add(row, entries[i].column, last ? box_.x + box_.width : entries[i + 1].column,
              kFullCoverage);
  }
  stats_.edge_pixels += entries.size();
}

}  // namespace flatray
