#include "render/coverage/row_pieces.h"

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
  pieces_ = 0;
  rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(box.height)));
  for (RowPieces& row : rows_) row.clear();
}

void RowCutter::cut(const ScanEdge& edge, std::uint32_t item) {
  if (std::min(edge.x_top, edge.x_bottom) >= box_.right() || edge.y_top >= box_.bottom() ||
      edge.y_bottom <= box_.y)
    return;
  if (rays_ == 0)
    cut_area(edge, item);
  else
    cut_rays(edge, item);
}

void RowCutter::cut_area(const ScanEdge& e, std::uint32_t item) {
  const int begin = std::max(floor_column(e.y_top), box_.y);
  const int end = std::min(ceil_column(e.y_bottom), box_.bottom());
  const int left = box_.x, right = box_.right();
  Piece piece{};
  piece.item = item;
  piece.curve = e.curve;
  piece.direction = static_cast<std::int8_t>(e.direction);
  double x_in = e.y_top >= begin ? e.x_top : e.x_at(begin);
  for (int row = begin; row < end; ++row) {
    const double top = row, bottom = row + 1.0;
    const bool ends = e.y_bottom <= bottom, crosses_top = e.y_top <= top;
    const double y_in = crosses_top ? top : e.y_top, y_out = ends ? e.y_bottom : bottom;
    const double x_out = ends ? e.x_bottom : e.x_at(bottom);
    const auto [first, last] = columns_of(x_in, x_out, crosses_top, y_out >= bottom);
    const bool rightward = first <= last;
    RowPieces& out = rows_[static_cast<std::size_t>(row - box_.y)];
    if (crosses_top && first < left) out.left.push_back({item, piece.direction, 0});
    const int low = std::max(rightward ? first : last, left);
    const int high = std::min(rightward ? last : first, right - 1);
    const auto border = [&](int column) { return clamp_to(e.y_at(column), y_in, y_out) - top; };
    for (int c = low; c <= high; ++c) {
      const bool is_first = c == first, is_last = c == last;
      piece.column = c;
      piece.x_top = is_first ? x_in - c : rightward ? 0 : 1;
      piece.x_bottom = is_last ? x_out - c : rightward ? 1 : 0;
      piece.y_top = is_first ? y_in - top : border(rightward ? c : c + 1);
      piece.y_bottom = is_last ? y_out - top : border(rightward ? c + 1 : c);
      piece.crosses_top = is_first && crosses_top;
      piece.left_top = rightward && !is_first;
      piece.left_bottom = !rightward && !is_last;
      out.pieces.push_back(piece);
    }
    pieces_ += low <= high ? 1 : 0;
    x_in = x_out;
  }
}

void RowCutter::cut_rays(const ScanEdge& e, std::uint32_t item) {
  const auto ray_y = [this](int ray) { return (ray + 0.5) / rays_; };
  int ray = std::max(floor_column(e.y_top * rays_ - 0.5) - 1, box_.y * rays_);
  while (ray_y(ray) < e.y_top) ++ray;
  const bool centre = coverage_ == Coverage::centre, near_film = centre && is_near_film(e);
  int row = ray / rays_, of_row = ray % rays_;
  Piece piece{};
  piece.item = item;
  piece.direction = static_cast<std::int8_t>(e.direction);
  for (double y; row < box_.bottom() && (y = ray_y(ray)) < e.y_bottom; ++ray) {
    const double x = centre ? first_centre(e, y, near_film) : e.x_at(y);
    piece.column = floor_column(x);
    piece.ray = static_cast<std::int8_t>(of_row);
    RowPieces& out = rows_[static_cast<std::size_t>(row - box_.y)];
    if (++of_row == rays_) of_row = 0, ++row;
    if (piece.column >= box_.right()) continue;
    if (piece.column < box_.x) {
      out.left.push_back({item, piece.direction, piece.ray});
      continue;
    }
    piece.x_top = x - piece.column;
    out.pieces.push_back(piece);
    ++pieces_;
  }
}

// The first column, from the one left of the box to the one right of it, whose centre lies on the
// edge or right of it.
int RowCutter::first_centre(const ScanEdge& e, double y, bool near_film) const {
  constexpr double kDoubt = 0x1p-20;
  const double x = e.x_at(y) - 0.5, nearest = std::nearbyint(x);
  if (near_film && std::abs(x - nearest) > kDoubt) return ceil_column(x);
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
