#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "render/coverage.h"

namespace flatray {

/// An edge of a path from its upper to its lower end (of a level edge: from the left to the right
/// one), ready to be cut by rows and columns of pixels.
struct ScanEdge {
  double x_top, y_top, x_bottom, y_bottom;
  double x_ref, y_ref;    ///< point on the edge's line
  double slope, inverse;  ///< dx / dy and dy / dx
  double error_x;         ///< of `x_at` within the box
  double error;           ///< distance of what is computed from the true line
  int direction;          ///< +1 where the path runs from top to bottom
  bool exact;             ///< the cuts and all areas made of them are exact doubles

  /// Needs a level edge or y between its ends.
  double x_at(double y) const;
  double y_at(double x) const {
    return x == x_top ? y_top : x == x_bottom ? y_bottom : y_ref + (x - x_ref) * inverse;
  }
};

/// Makes an edge ready for the rows and columns of `box`.
/// Error   `error` and `error_x` are bounds, derived in coverage_edges.cpp; both 0 where nothing is
///         rounded.
ScanEdge scan_edge(const Segment& edge, const PixelBox& box);

/// Part of an edge inside one pixel, in coordinates of the pixel.
struct Piece {
  int column;
  std::uint32_t edge;  ///< index into the edges of the scan
  double x_top, y_top, x_bottom, y_bottom;
  double error;                    ///< of the ends
  std::int8_t direction;           ///< that of the edge
  bool crosses_top;                ///< the edge comes in by the row's upper border, in this pixel
  bool left_top, left_bottom;      ///< this end is where the edge crosses the pixel's left border
  bool vertex_top, vertex_bottom;  ///< this end is an end of the edge
  bool ghost;                      ///< no piece: the edge may or may not touch this pixel
  bool exact;
};

/// An edge in one row: where it comes in and leaves, and the columns it comes through, from the
/// upper to the lower one; `low` to `high` are those it may touch.
struct RowCut {
  double x_in, y_in, x_out, y_out;
  int first, last, low, high;
  bool crosses_top, starts, ends;
};
/// Written so that a NaN gives `low`: an infinite slope times nothing.
inline double clamp_to(double v, double low, double high) {
  return v > low ? (v < high ? v : high) : low;
}

inline double ScanEdge::x_at(double y) const {
  const double x = x_ref + (y - y_ref) * slope;
  return x_top < x_bottom ? clamp_to(x, x_top, x_bottom) : clamp_to(x, x_bottom, x_top);
}

/// floor and ceil for columns, beyond all boxes the nearest integer that is beyond all boxes.
inline int floor_column(double x) {
  const double safe = clamp_to(x, -0x1p30, 0x1p30);
  const int cut = static_cast<int>(safe);
  return cut - (cut > safe ? 1 : 0);
}
inline int ceil_column(double x) { return -floor_column(-x); }

/// Needs   an edge that meets the row's inside.
// A column border belongs to the pixel right of it: an edge that ends on it inside the row crosses
// it or not by that. On the row's own borders nothing is lost by staying in the pixel the edge
// comes through.
inline RowCut row_cut(const ScanEdge& e, int row) {
  const double top = row, bottom = row + 1.0;
  RowCut cut;
  cut.starts = e.y_top >= top;
  cut.ends = e.y_bottom <= bottom;
  cut.crosses_top = e.y_top <= top;
  cut.y_in = cut.starts ? e.y_top : top;
  cut.y_out = cut.ends ? e.y_bottom : bottom;
  cut.x_in = cut.starts ? e.x_top : e.x_at(top);
  cut.x_out = cut.ends ? e.x_bottom : e.x_at(bottom);
  const double error_in = cut.starts ? 0 : e.error_x, error_out = cut.ends ? 0 : e.error_x;
  if (cut.x_in < cut.x_out) {
    cut.first = floor_column(cut.x_in);
    cut.last = cut.y_out < bottom ? floor_column(cut.x_out) : ceil_column(cut.x_out) - 1;
    cut.low = error_in > 0 ? floor_column(cut.x_in - error_in) : cut.first;
    cut.high = error_out > 0 ? floor_column(cut.x_out + error_out) : cut.last;
  } else if (cut.x_out < cut.x_in) {
    cut.first = cut.y_in > top ? floor_column(cut.x_in) : ceil_column(cut.x_in) - 1;
    cut.last = floor_column(cut.x_out);
    cut.low = error_out > 0 ? floor_column(cut.x_out - error_out) : cut.last;
    cut.high = error_in > 0 ? floor_column(cut.x_in + error_in) : cut.first;
  } else {
    cut.first = cut.last = floor_column(cut.x_in);
    const double error = std::max(error_in, error_out);
    cut.low = floor_column(cut.x_in - error);
    cut.high = floor_column(cut.x_in + error);
  }
  return cut;
}

/// A piece of the edge from border to border of a row; `column` and both x are still to be filled
/// in.
inline Piece whole_piece(const ScanEdge& e, std::uint32_t index) {
  Piece piece{};
  piece.edge = index;
  piece.y_bottom = 1;
  piece.error = e.error;
  piece.direction = static_cast<std::int8_t>(e.direction);
  piece.crosses_top = true;
  piece.exact = e.exact;
  return piece;
}

/// The edge as the kernels take it; the error holds the sum with an offset of half a pixel too.
inline kernels::EdgeLine edge_line(const ScanEdge& e) {
  const auto [low, high] = std::minmax(e.x_top, e.x_bottom);
  const double error = e.error_x + 0x1p-52 * (e.exact ? 0 : std::max(-low, high));
  return {e.x_ref, e.y_ref, e.slope, low, high, error};
}

/// Calls `take` with each piece of an edge in one row within the columns of `box`, ghosts last.
template <class Take>
void walk_row(const ScanEdge& e, std::uint32_t index, const RowCut& cut, int row,
              const PixelBox& box, const Take& take) {
  const int left = box.x, right = box.x + box.width - 1;
  const double top = row;
  const bool rightward = cut.first <= cut.last;
  const int low = std::min(cut.first, cut.last), high = std::max(cut.first, cut.last);
  Piece piece = whole_piece(e, index);
  for (int c = std::max(low, left); c <= std::min(high, right); ++c) {
    const bool is_first = c == cut.first, is_last = c == cut.last;
    const auto border = [&](int column) {
      return clamp_to(e.y_at(column), cut.y_in, cut.y_out) - top;
    };
    piece.column = c;
    piece.x_top = is_first ? cut.x_in - c : rightward ? 0 : 1;
    piece.x_bottom = is_last ? cut.x_out - c : rightward ? 1 : 0;
    piece.y_top = is_first ? cut.y_in - top : border(rightward ? c : c + 1);
    piece.y_bottom = is_last ? cut.y_out - top : border(rightward ? c + 1 : c);
    piece.crosses_top = is_first && cut.crosses_top;
    piece.left_top = rightward && !is_first;
    piece.left_bottom = !rightward && !is_last;
    piece.vertex_top = is_first && cut.starts;
    piece.vertex_bottom = is_last && cut.ends;
    take(piece);
  }
  if (cut.low == low && cut.high == high) return;
  piece.ghost = true;
  piece.crosses_top = piece.left_top = piece.left_bottom = false;
  for (int c = std::max(cut.low, left); c <= std::min(cut.high, right); ++c) {
    if (c >= low && c <= high) continue;
    piece.column = c;
    take(piece);
  }
}

}  // namespace flatray
