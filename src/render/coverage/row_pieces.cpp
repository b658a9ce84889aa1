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

// The columns right and left of x: one unless it is their border.
struct Columns {
  int right, left;

  explicit Columns(double x) : right(floor_column(x)), left(right - (x > right ? 0 : 1)) {}
};

// Whether x is right to 2^-28 but near the upper and lower end of a curve.
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
  rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(box.height)));
}

// Written in place, as all cuts: a copy of what was just written waits for it.
inline RowCut& RowCutter::add_cut(const ScanEdge& e, int row, int low, int high) {
  RowCut& cut = this->row(row).emplace_back();
  cut.edge = &e;
  cut.low = low, cut.high = high;
  cut.first = cut.last = high;
  cut.ray_begin = 0, cut.ray_end = 1;
  cut.winds = true;
  return cut;
}

void RowCutter::cut(const ScanEdge& edge, const PixelBox& rows) {
  const double rounding = edge.curve == nullptr ? 0 : edge.curve->rounding;
  if (std::min(edge.x_top, edge.x_bottom) - rounding >= box_.right() ||
      edge.y_top - rounding >= rows.bottom() || edge.y_bottom + rounding <= rows.y)
    return;
  if (coverage_ == Coverage::area)
    cut_area(edge, rows);
  else if (coverage_ == Coverage::rows)
    cut_rays(edge, rows);
  else
    cut_centres(edge, rows);
}

// A column border belongs to the pixel right of it: an edge that ends on it inside the row crosses
// it or not by that. On the row's own borders nothing is lost by staying in the pixel the edge comes
// through.
void RowCutter::cut_area(const ScanEdge& e, const PixelBox& rows) {
  const int begin = std::max(floor_column(e.y_top), rows.y);
  const int end = std::min(ceil_column(e.y_bottom), rows.bottom());
  const int left = box_.x, right = box_.right();
  double x_in = e.y_top >= begin ? e.x_top : e.x_at(begin);
  Columns in(x_in);
  for (int row = begin; row < end; ++row) {
    const double top = row, bottom = row + 1.0;
    const bool crosses_top = e.y_top <= top, crosses_bottom = e.y_bottom >= bottom;
    const double x_out = e.y_bottom <= bottom ? e.x_bottom : e.x_at(bottom);
    const Columns out(x_out);
    const int first = x_out < x_in && crosses_top ? in.left : in.right;
    const int last = x_in < x_out && crosses_bottom ? out.left : out.right;
    const int low = std::max(std::min(first, last), left);
    const int high = std::min(std::max(first, last), right - 1);
    if (crosses_top && crosses_bottom && x_in == first && x_out == first && low <= high) {
      add_cut(e, row, first, first - 1);
    } else {
      if (crosses_top && first < left) add_cut(e, row, left, left - 1);
      if (low <= high) {
        RowCut& cut = add_cut(e, row, low, high);
        cut.x_in = x_in, cut.y_in = crosses_top ? top : e.y_top;
        cut.x_out = x_out, cut.y_out = crosses_bottom ? bottom : e.y_bottom;
        cut.first = first, cut.last = last;
        cut.winds = crosses_top && first >= left;
      }
    }
    x_in = x_out;
    in = out;
  }
}

void RowCutter::cut_centres(const ScanEdge& e, const PixelBox& rows) {
  constexpr double kDoubt = 0x1p-20, kLevel = 0x1p-10;
  const bool near_film = is_near_film(e);
  const double above = e.curve == nullptr ? 0 : e.curve->above;
  const double below = e.curve == nullptr ? 0 : e.curve->below;
  const int begin = std::max(ceil_column(e.y_top - above - 0.5), rows.y);
  const int end = std::min(ceil_column(e.y_bottom + below - 0.5), rows.bottom());
  for (int row = begin; row < end; ++row) {
    const double y = row + 0.5, x = e.x_at(y) - 0.5;
    int column = ceil_column(x);
    const double beyond = column - x;
    const bool level = e.curve != nullptr && !(e.curve->x.inside(y - e.y_ref) > kLevel);
    if (!near_film || level || !(beyond > kDoubt && beyond < 1 - kDoubt))
      column = first_centre(e, x, y, near_film);
    column = std::max(column, box_.x);
    if (column < box_.right()) add_cut(e, row, column, column - 1);
  }
}

// An edge that crosses several rays in few columns has pieces in all of them; else each ray is cut
// by itself.
void RowCutter::cut_rays(const ScanEdge& e, const PixelBox& rows) {
  constexpr int kFew = 8;
  const int begin = std::max(floor_column(e.y_top), rows.y);
  const int end = std::min(ceil_column(e.y_bottom), rows.bottom());
  for (int row = begin; row < end; ++row) {
    int ray = 0, ray_end = rays_;
    while (ray < ray_end && ray_y(row, ray) < e.y_top) ++ray;
    while (ray < ray_end && ray_y(row, ray_end - 1) >= e.y_bottom) --ray_end;
    if (ray == ray_end) continue;
    const int one = floor_column(e.x_at(ray_y(row, ray)));
    const int other = floor_column(e.x_at(ray_y(row, ray_end - 1)));
    const int each = std::abs(one - other) > kFew ? 1 : ray_end - ray;
    for (; ray < ray_end; ray += each) add_rays(e, row, ray, ray + each);
  }
}

void RowCutter::add_rays(const ScanEdge& e, int row, int ray_begin, int ray_end) {
  const double x_in = e.x_at(ray_y(row, ray_begin)), x_out = e.x_at(ray_y(row, ray_end - 1));
  const int low = std::max(floor_column(std::min(x_in, x_out)), box_.x);
  const int high = std::min(floor_column(std::max(x_in, x_out)), box_.right() - 1);
  if (low >= box_.right()) return;
  const bool border = std::max(x_in, x_out) <= low;
  RowCut& cut = add_cut(e, row, low, border ? low - 1 : high);
  cut.ray_begin = static_cast<std::int16_t>(ray_begin);
  cut.ray_end = static_cast<std::int16_t>(ray_end);
}

void RowCutter::add_pieces(const RowCut& cut, int row, int column, std::vector<Piece>& out) const {
  const ScanEdge& e = *cut.edge;
  if (rays_ > 0) {
    for (int ray = cut.ray_begin; ray < cut.ray_end; ++ray) {
      const double x = e.x_at(ray_y(row, ray)) - column;
      if (x >= 1) continue;
      Piece& piece = out.emplace_back();
      piece.x_top = std::max(x, 0.0);
      piece.direction = e.direction;
      piece.ray = static_cast<std::int8_t>(ray);
    }
    return;
  }
  const bool rightward = cut.first <= cut.last;
  const bool is_first = column == cut.first, is_last = column == cut.last;
  const double top = row;
  const auto border = [&](int x) { return clamp_to(e.y_at(x), cut.y_in, cut.y_out) - top; };
  Piece& piece = out.emplace_back();
  piece.column = column;
  piece.direction = e.direction;
  piece.x_top = is_first ? cut.x_in - column : rightward ? 0 : 1;
  piece.x_bottom = is_last ? cut.x_out - column : rightward ? 1 : 0;
  piece.y_top = is_first ? cut.y_in - top : border(rightward ? column : column + 1);
  piece.y_bottom = is_last ? cut.y_out - top : border(rightward ? column + 1 : column);
  piece.curve = e.curve;
  piece.left_top = rightward && !is_first;
  piece.left_bottom = !rightward && !is_last;
}

// The first column, from the one left of the box to the one right of it, whose centre lies on the
// edge or right of it. Needs   x, the edge there, from centres, near the film right to 2^-8.
int RowCutter::first_centre(const ScanEdge& e, double x, double y, bool near_film) const {
  const double nearest = std::nearbyint(x);
  int low = box_.x - 1, high = box_.right();
  if (near_film) {
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
