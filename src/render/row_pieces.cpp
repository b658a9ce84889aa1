#include "render/row_pieces.h"

#include <cmath>

namespace flatray {
namespace {

// floor and ceil for columns, beyond all boxes the nearest integer that is beyond all boxes.
int floor_column(double x) {
  const double safe = clamp_to(x, -0x1p30, 0x1p30);
  const int cut = static_cast<int>(safe);
  return cut - (cut > safe ? 1 : 0);
}
int ceil_column(double x) { return -floor_column(-x); }

// Columns an edge comes through in one row, from the upper to the lower one.
struct Columns {
  int first, last;
};

// A column border belongs to the pixel right of it: an edge that ends on it inside the row crosses
// it or not by that. On the row's own borders nothing is lost by staying in the pixel the edge comes
// through.
Columns columns_of(double x_in, double x_out, bool from_border, bool to_border) {
  if (x_in < x_out)
    return {floor_column(x_in), to_border ? ceil_column(x_out) - 1 : floor_column(x_out)};
  if (x_out < x_in)
    return {from_border ? ceil_column(x_in) - 1 : floor_column(x_in), floor_column(x_out)};
  const int column = floor_column(x_in);
  return {column, column};
}

// Whether x is right to 2^-32.
bool is_near_film(const ScanEdge& e) {
  const auto near = [](double v) { return std::abs(v) <= 0x1p16; };
  return near(e.x_top) && near(e.x_bottom) && near(e.y_top) && near(e.y_bottom) &&
         (e.curve == nullptr || (near(e.curve->x.half) && near(e.curve->y.half)));
}

}  // namespace

void RowCutter::begin(const PixelBox& box, Coverage coverage, int rays) {
  box_ = box;
  coverage_ = coverage;
  rays_ = rays;
  heights_.clear(), middles_.clear();
  for (int ray = 0; rays > 0 && ray <= rays; ++ray) {
    heights_.push_back(static_cast<double>(ray) / rays);
    middles_.push_back((ray + 0.5) / rays);
  }
  rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(box.height)));
}

void RowCutter::add_upright(int column, int ray, double x, int winding,
                            std::vector<Piece>& out) const {
  const auto i = static_cast<std::size_t>(ray);
  Piece& piece = out.emplace_back();
  piece.column = column;
  piece.direction = winding;
  piece.x_top = piece.x_bottom = x;
  piece.y_top = heights_[i], piece.y_bottom = heights_[i + 1];
}

void RowCutter::cut(const ScanEdge& edge) {
  if (std::min(edge.x_top, edge.x_bottom) >= box_.right() || edge.y_top >= box_.bottom() ||
      edge.y_bottom <= box_.y)
    return;
  if (coverage_ == Coverage::area)
    cut_area(edge);
  else if (coverage_ == Coverage::rows)
    cut_rays(edge);
  else
    cut_centres(edge);
}

// The last cut of a row is kept as far as it is in the box.
inline void RowCutter::clip(RowCuts& row) {
  RowCut& cut = row.cuts.back();
  if (cut.low >= box_.x && cut.high < box_.right()) return;
  const bool left = rays_ == 0 ? cut.y_in == 0 && cut.first < box_.x : cut.high < box_.x;
  if (left) row.left.push_back({cut.edge->direction, cut.ray_begin, cut.ray_end});
  if (cut.high < box_.x || cut.low >= box_.right()) return row.cuts.pop_back();
  cut.low = std::max(cut.low, box_.x);
  cut.high = std::min(cut.high, box_.right() - 1);
}

// Cuts are written where they stay: copies of what was just written wait for it.
void RowCutter::cut_area(const ScanEdge& e) {
  const int begin = std::max(floor_column(e.y_top), box_.y);
  const int end = std::min(ceil_column(e.y_bottom), box_.bottom());
  const RowCut of_edge{&e, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, false, false};
  double x_in = e.y_top >= begin ? e.x_top : e.x_at(begin);
  for (int row = begin; row < end; ++row) {
    const double top = row, bottom = row + 1.0;
    const bool ends = e.y_bottom <= bottom, crosses_top = e.y_top <= top;
    const double x_out = ends ? e.x_bottom : e.x_at(bottom);
    const auto [first, last] = columns_of(x_in, x_out, crosses_top, e.y_bottom >= bottom);
    RowCuts& out = this->row(row);
    RowCut& cut = out.cuts.emplace_back(of_edge);
    cut.x_in = x_in, cut.x_out = x_out;
    cut.y_in = crosses_top ? 0 : e.y_top - top;
    cut.y_out = ends ? e.y_bottom - top : 1;
    cut.first = first, cut.last = last;
    cut.low = std::min(first, last), cut.high = std::max(first, last);
    cut.whole = crosses_top && e.y_bottom >= bottom;
    cut.border = cut.whole && x_in == first && x_out == first;
    clip(out);
    x_in = x_out;
  }
}

void RowCutter::cut_rays(const ScanEdge& e) {
  const int begin = std::max(floor_column(e.y_top), box_.y);
  const int end = std::min(ceil_column(e.y_bottom), box_.bottom());
  const RowCut of_edge{&e, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, false, false};
  for (int row = begin; row < end; ++row) {
    int ray = 0, ray_end = rays_;
    while (ray < ray_end && ray_y(row, ray) < e.y_top) ++ray;
    while (ray < ray_end && ray_y(row, ray_end - 1) >= e.y_bottom) --ray_end;
    if (ray == ray_end) continue;
    const double x_in = e.x_at(ray_y(row, ray)), x_out = e.x_at(ray_y(row, ray_end - 1));
    RowCuts& out = this->row(row);
    RowCut& cut = out.cuts.emplace_back(of_edge);
    cut.low = floor_column(std::min(x_in, x_out));
    cut.high = floor_column(std::max(x_in, x_out));
    cut.ray_begin = static_cast<std::int16_t>(ray);
    cut.ray_end = static_cast<std::int16_t>(ray_end);
    cut.whole = ray == 0 && ray_end == rays_;
    cut.border = cut.low == x_in && cut.low == x_out;
    clip(out);
  }
}

void RowCutter::cut_centres(const ScanEdge& e) {
  const bool near_film = is_near_film(e);
  const int begin = std::max(ceil_column(e.y_top - 0.5), box_.y);
  const int end = std::min(ceil_column(e.y_bottom - 0.5), box_.bottom());
  const RowCut of_edge{&e, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, true, true};
  for (int row = begin; row < end; ++row) {
    RowCuts& out = this->row(row);
    RowCut& cut = out.cuts.emplace_back(of_edge);
    cut.low = cut.high = first_centre(e, row + 0.5, near_film);
    clip(out);
  }
}

void RowCutter::add_pieces(const RowCut& cut, int row, int column, std::vector<Piece>& out) const {
  const ScanEdge& e = *cut.edge;
  if (rays_ > 0) {
    for (int ray = cut.ray_begin; ray < cut.ray_end; ++ray) {
      const double x = e.x_at(ray_y(row, ray)) - column;
      if (x < 1) add_upright(column, ray, std::max(x, 0.0), e.direction, out);
    }
    return;
  }
  const bool rightward = cut.first <= cut.last;
  const bool is_first = column == cut.first, is_last = column == cut.last;
  const double top = row;
  const auto border = [&](int x) { return clamp_to(e.y_at(x) - top, cut.y_in, cut.y_out); };
  Piece& piece = out.emplace_back();
  piece.column = column;
  piece.direction = e.direction;
  piece.x_top = is_first ? cut.x_in - column : rightward ? 0 : 1;
  piece.x_bottom = is_last ? cut.x_out - column : rightward ? 1 : 0;
  piece.y_top = is_first ? cut.y_in : border(rightward ? column : column + 1);
  piece.y_bottom = is_last ? cut.y_out : border(rightward ? column + 1 : column);
  piece.curve = e.curve;
  piece.left_top = rightward && !is_first;
  piece.left_bottom = !rightward && !is_last;
}

// The first column, from the one left of the box to the one right of it, whose centre lies on the
// edge or right of it.
int RowCutter::first_centre(const ScanEdge& e, double y, bool near_film) const {
  constexpr double kDoubt = 0x1p-20;
  const double x = e.x_at(y) - 0.5;
  if (near_film) {  // without a call in what nearly all take
    const int column = ceil_column(x);
    const double beyond = column - x;
    if (beyond > kDoubt && beyond < 1 - kDoubt) return column;
  }
  const double nearest = std::nearbyint(x);
  int low = box_.x - 1, high = box_.right();
  if (e.curve != nullptr || near_film) {
    low = std::clamp(floor_column(nearest) - 1, low, high);
    high = std::clamp(floor_column(nearest) + 1, low, high);
  }
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (e.has_on_right(middle + 0.5, y))
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace flatray
