#pragma once
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
/// rounded.
ScanEdge scan_edge(const Segment& edge, const PixelBox& box);

/// Part of an edge inside one pixel, in coordinates of the pixel.
struct Piece {
  int column;
  std::uint32_t edge;  ///< index into the edges of the scan
  double x_top, y_top, x_bottom, y_bottom;
  double error;                ///< of the ends
  std::int8_t direction;       ///< that of the edge
  bool crosses_top;            ///< the edge comes in by the upper border of the row, in this pixel
  bool left_top, left_bottom;  ///< the end is where the edge crosses the pixel's left border
  bool vertex_top, vertex_bottom;  ///< the end is an end of the edge
  bool ghost;                      ///< no piece: the edge may or may not touch this pixel
  bool exact;
};

/// Pieces of one row of a box, and the edges that pass left of it.
struct PieceRow {
  std::vector<Piece> pieces;
  int winding = 0;  ///< of the row's upper left corner, just inside
};

/// Columns of a row an edge comes through, as `cut_row` takes them: from the upper to the lower
/// one.
struct RowCut {
  double x_in, y_in, x_out, y_out;
  double first, last;  ///< columns
  double low, high;    ///< columns it may touch, outward
  bool crosses_top;
};
RowCut row_cut(const ScanEdge& edge, int row);

/// Adds the pieces of an edge in one row, restricted to the columns of `box`.
void cut_row(const ScanEdge& edge, std::uint32_t index, int row, const PixelBox& box,
             PieceRow& out);

}  // namespace flatray
