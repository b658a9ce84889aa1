#pragma once
#include <cstdint>
#include <vector>

#include "render/coverage/scan_edge.h"
#include "render/pixel_box.h"

namespace flatray {

/// Part of an edge inside one pixel, in coordinates of the pixel; or where it crosses a ray of the
/// pixel's row, at x = `x_top`.
struct Piece {
  double x_top, y_top, x_bottom, y_bottom;
  const EdgeCurve* curve;  ///< null where it is straight
  std::int32_t column;
  std::int32_t direction;      ///< that of the edge
  std::int8_t ray;             ///< of the row
  bool left_top, left_bottom;  ///< this end is where the edge crosses the pixel's left border
};

/// Passage of an edge through a row of pixels, or through rays of it.
struct RowCut {
  const ScanEdge* edge;
  double x_in, y_in, x_out, y_out;  ///< where it comes in and goes out, film
  std::int32_t first, last;         ///< columns it comes in and goes out by
  /// Columns of the box it has pieces in; with none, high < low, all right of low's left border is
  /// right of it.
  std::int32_t low, high;
  std::int16_t ray_begin, ray_end;  ///< rays it crosses
  /// Changes the winding number right of `first` along the row's upper border or these rays.
  bool winds;
};

/// Cuts edges by the rows and columns of a box of pixels. What it gives for a pixel does not depend
/// on the box.
class RowCutter {
 public:
  /// Rows of the box, each with `rays` rays; 0 to cut by areas.
  void begin(const PixelBox& box, Coverage coverage, int rays);
  /// Adds the passages of an edge, which must stay where it is, through some rows of the box.
  void cut(const ScanEdge& edge, const PixelBox& rows);
  std::vector<RowCut>& row(int y) { return rows_[static_cast<std::size_t>(y - box_.y)]; }
  /// Adds what an edge has in a pixel; of a ray that it crosses left of it, at its left border.
  void add_pieces(const RowCut& cut, int row, int column, std::vector<Piece>& out) const;

 private:
  void cut_area(const ScanEdge& edge, const PixelBox& rows);
  void cut_rays(const ScanEdge& edge, const PixelBox& rows);
  void cut_centres(const ScanEdge& edge, const PixelBox& rows);
  RowCut& add_cut(const ScanEdge& edge, int row, int low, int high);
  void add_rays(const ScanEdge& edge, int row, int ray_begin, int ray_end);
  double ray_y(int row, int ray) const {
    return (static_cast<double>(row) * rays_ + ray + 0.5) / rays_;
  }
  int first_centre(const ScanEdge& edge, double x, double y, bool near_film) const;

  PixelBox box_;
  Coverage coverage_ = Coverage::area;
  int rays_ = 0;
  std::vector<std::vector<RowCut>> rows_;
};

}  // namespace flatray
