#include "render/coverage_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geom/exact.h"

namespace flatray {
namespace {

constexpr double kUnit = 0x1p-53;  // u: half an ulp of 1
constexpr double kNear = 0x1p16;   // beyond this many pixels an edge is anchored near the box
constexpr double kGrid =
    0x1p8;  // ends on multiples of 1 / kGrid and slopes of a small power of two
constexpr double kSteepest = 0x1p4;  // give exact cuts: multiples of 2^-12, areas of 2^-29

// Written so that a NaN gives `low`: an infinite slope times nothing.
double clamp_to(double v, double low, double high) { return v > low ? (v < high ? v : high) : low; }

bool on_grid(double v) { return v * kGrid == std::floor(v * kGrid); }

// dx / dy is +-2^k with |k| small, or the edge lies along an axis.
bool exact_slope(double dx, double dy, double slope) {
  if (dx == 0 || dy == 0) return true;
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  const double steep = std::abs(slope);
  return (std::bit_cast<std::uint64_t>(slope) & kFraction) == 0 && slope * dy == dx &&
         steep <= kSteepest && steep >= 1 / kSteepest;
}

// x_at: the difference, the slope (of two rounded differences and a quotient) and the product make
// a relative error below 5.1 u of a term not larger than |dx|; the sum adds u |x|. y_at likewise.
void bound_near(ScanEdge& e, double dx, double dy) {
  const double x = std::max(std::abs(e.x_top), std::abs(e.x_bottom));
  const double y = std::max(std::abs(e.y_top), std::abs(e.y_bottom));
  const bool along_axis =
      dx == 0 || dy == 0;  // the one coordinate is copied, the other one is a border
  e.error_x = along_axis ? 0 : kUnit * (6 * std::abs(dx) + x);
  e.error = along_axis ? 0 : std::max(e.error_x, kUnit * (6 * std::abs(dy) + y));
}

// A long edge: a point of it near the box, rounded once from the exact one, so that errors are
// those of the box and not of the edge. `error` is measured along the axis the edge is steep
// against.
void anchor(ScanEdge& e, const PixelBox& box) {
  const Rational dx = Rational(e.x_bottom) - Rational(e.x_top);
  const Rational dy = Rational(e.y_bottom) - Rational(e.y_top);
  if (dx == 0 || dy == 0) return;
  const Rational slope = dx / dy, inverse = dy / dx;
  e.slope = slope.nearest();
  e.inverse = inverse.nearest();
  const double middle_x = box.x + 0.5 * box.width, middle_y = box.y + 0.5 * box.height;
  const double reach = std::abs(box.x) + std::abs(box.y) + box.width + box.height + 2.0;
  if (std::abs(e.slope) <= 1) {
    e.y_ref = std::clamp(middle_y, e.y_top, e.y_bottom);
    e.x_ref = (Rational(e.x_top) + (Rational(e.y_ref) - Rational(e.y_top)) * slope).nearest();
    e.error = e.error_x = kUnit * (3 * std::abs(e.x_ref) + 6 * reach);
  } else {
    e.x_ref = std::clamp(middle_x, std::min(e.x_top, e.x_bottom), std::max(e.x_top, e.x_bottom));
    e.y_ref = (Rational(e.y_top) + (Rational(e.x_ref) - Rational(e.x_top)) * inverse).nearest();
    e.error = kUnit * (3 * std::abs(e.y_ref) + 6 * reach);
    e.error_x = 2 * kUnit * std::abs(e.y_ref) * std::abs(e.slope) +
                kUnit * (6 * reach + 3 * std::abs(e.x_ref));
    if (!std::isfinite(e.error_x)) e.error_x = kInfinity;
  }
}

}  // namespace

double ScanEdge::x_at(double y) const {
  const double x = x_ref + (y - y_ref) * slope;
  return x_top < x_bottom ? clamp_to(x, x_top, x_bottom) : clamp_to(x, x_bottom, x_top);
}

ScanEdge scan_edge(const Segment& edge, const PixelBox& box) {
  const bool down =
      edge.a.y() < edge.b.y() || (edge.a.y() == edge.b.y() && edge.a.x() < edge.b.x());
  const Vec2& top = down ? edge.a : edge.b;
  const Vec2& bottom = down ? edge.b : edge.a;
  ScanEdge e{top.x(), top.y(), bottom.x(), bottom.y(), top.x(),       top.y(),
             0,       0,       0,          0,          down ? 1 : -1, false};
  const double far = std::max(std::max(std::abs(e.x_top), std::abs(e.x_bottom)),
                              std::max(std::abs(e.y_top), std::abs(e.y_bottom)));
  if (far > kNear) {
    const bool beside =
        std::max(e.x_top, e.x_bottom) < box.x || std::min(e.x_top, e.x_bottom) > box.x + box.width;
    if (!beside) anchor(e, box);  // beside the box only its winding counts
    return e;
  }
  const double dx = e.x_bottom - e.x_top, dy = e.y_bottom - e.y_top;
  if (dy != 0) e.slope = dx / dy;
  if (dx != 0) e.inverse = dy / dx;
  e.exact = exact_slope(dx, dy, e.slope) && on_grid(e.x_top) && on_grid(e.y_top) &&
            on_grid(e.x_bottom) && on_grid(e.y_bottom);
  if (!e.exact) bound_near(e, dx, dy);
  return e;
}

// A column border belongs to the pixel right of it: an edge that ends on it inside the row crosses
// it or not by that. On the row's own borders nothing is lost by staying in the pixel the edge
// comes through.
RowCut row_cut(const ScanEdge& e, int row) {
  const double top = row, bottom = row + 1.0;
  const bool starts = e.y_top >= top, ends = e.y_bottom <= bottom;
  RowCut cut;
  cut.crosses_top = e.y_top <= top;
  cut.y_in = starts ? e.y_top : top;
  cut.y_out = ends ? e.y_bottom : bottom;
  cut.x_in = starts ? e.x_top : e.x_at(top);
  cut.x_out = ends ? e.x_bottom : e.x_at(bottom);
  const double error_in = starts ? 0 : e.error_x, error_out = ends ? 0 : e.error_x;
  if (cut.x_in < cut.x_out) {
    cut.first = std::floor(cut.x_in);
    cut.last = cut.y_out < bottom ? std::floor(cut.x_out) : std::ceil(cut.x_out) - 1;
    cut.low = error_in > 0 ? std::floor(cut.x_in - error_in) : cut.first;
    cut.high = error_out > 0 ? std::floor(cut.x_out + error_out) : cut.last;
  } else if (cut.x_out < cut.x_in) {
    cut.first = cut.y_in > top ? std::floor(cut.x_in) : std::ceil(cut.x_in) - 1;
    cut.last = std::floor(cut.x_out);
    cut.low = error_out > 0 ? std::floor(cut.x_out - error_out) : cut.last;
    cut.high = error_in > 0 ? std::floor(cut.x_in + error_in) : cut.first;
  } else {
    cut.first = cut.last = std::floor(cut.x_in);
    const double error = std::max(error_in, error_out);
    cut.low = std::floor(cut.x_in - error);
    cut.high = std::floor(cut.x_in + error);
  }
  return cut;
}

void cut_row(const ScanEdge& e, std::uint32_t index, int row, const PixelBox& box, PieceRow& out) {
  const RowCut cut = row_cut(e, row);
  const double left = box.x, right = box.x + box.width - 1.0;
  if (cut.low > right) return;
  if (cut.crosses_top && cut.first < left) out.winding += e.direction;
  if (cut.high < left) return;
  const double top = row;
  Piece piece{
      0,     index, 0,     0,     0,     0,     e.error, static_cast<std::int8_t>(e.direction),
      false, false, false, false, false, false, e.exact};
  const bool starts = e.y_top >= top, ends = e.y_bottom <= top + 1;
  const bool rightward = cut.first <= cut.last;
  const double low = std::min(cut.first, cut.last), high = std::max(cut.first, cut.last);
  for (double c = std::max(low, left); c <= std::min(high, right); ++c) {
    const bool is_first = c == cut.first, is_last = c == cut.last;
    const double border_in = rightward ? c : c + 1, border_out = rightward ? c + 1 : c;
    piece.column = static_cast<int>(c);
    piece.x_top = (is_first ? cut.x_in : border_in) - c;
    piece.x_bottom = (is_last ? cut.x_out : border_out) - c;
    piece.y_top = (is_first ? cut.y_in : clamp_to(e.y_at(border_in), cut.y_in, cut.y_out)) - top;
    piece.y_bottom =
        (is_last ? cut.y_out : clamp_to(e.y_at(border_out), cut.y_in, cut.y_out)) - top;
    piece.crosses_top = is_first && cut.crosses_top;
    piece.left_top = rightward && !is_first;
    piece.left_bottom = !rightward && !is_last;
    piece.vertex_top = is_first && starts;
    piece.vertex_bottom = is_last && ends;
    out.pieces.push_back(piece);
  }
  if (cut.low == low && cut.high == high) return;
  piece.ghost = true;
  piece.crosses_top = piece.left_top = piece.left_bottom = false;
  for (double c = std::max(cut.low, left); c <= std::min(cut.high, right); ++c) {
    if (c >= low && c <= high) continue;
    piece.column = static_cast<int>(c);
    out.pieces.push_back(piece);
  }
}

}  // namespace flatray
