#pragma once
#include <cstdint>
#include <vector>

#include "render/pixel_box.h"
#include "render/scan_edge.h"

namespace flatray {

/// Part of an edge inside one pixel, in coordinates of the pixel. Of an edge that crosses one of n
/// rays of the pixel's row: upright where it crosses it, through the nth of the pixel round the ray.
struct Piece {
  std::int32_t column;
  std::int32_t direction;  ///< that of the edge; or a winding number
  double x_top, y_top, x_bottom, y_bottom;
  const EdgeCurve* curve;      ///< null where it is straight
  bool left_top, left_bottom;  ///< this end is where the edge crosses the pixel's left border
};

/// Passage of an edge through a row of pixels, or through rays of it.
struct RowCut {
  const ScanEdge* edge;
  double x_in, x_out;               ///< where it comes in and goes out, film
  double y_in, y_out;               ///< likewise, from the row's upper border
  std::int32_t low, high;           ///< columns of the box it has pieces in
  std::int32_t first, last;         ///< columns it comes in and goes out by
  std::int16_t ray_begin, ray_end;  ///< rays it crosses
  bool whole;                       ///< it crosses all of the row
  bool border;  ///< it runs along the left border of its pixel: changes what is in it, cuts nothing
};

/// Changes of the winding number left of all pixels: along the row's upper border (ray 0), or along
/// some of its rays.
struct LeftOfRow {
  int direction;
  std::int16_t ray_begin, ray_end;
};

struct RowCuts {
  std::vector<RowCut> cuts;
  std::vector<LeftOfRow> left;

  void clear() { cuts.clear(), left.clear(); }
};

/// Cuts edges by the rows and columns of a box of pixels. What it gives for a pixel does not depend
/// on the box.
class RowCutter {
 public:
  /// Rows of the box, each with `rays` rays; 0 to cut by areas.
  void begin(const PixelBox& box, Coverage coverage, int rays);
  /// Adds the passages of an edge, which must stay where it is.
  void cut(const ScanEdge& edge);
  RowCuts& row(int y) { return rows_[static_cast<std::size_t>(y - box_.y)]; }
  /// Adds what an edge has in a pixel.
  void add_pieces(const RowCut& cut, int row, int column, std::vector<Piece>& out) const;
  /// Adds the piece of a pixel in which a ray has a winding number from `x` on.
  void add_upright(int column, int ray, double x, int winding, std::vector<Piece>& out) const;

 private:
  void cut_area(const ScanEdge& edge);
  void cut_rays(const ScanEdge& edge);
  void cut_centres(const ScanEdge& edge);
  void clip(RowCuts& row);
  int first_centre(const ScanEdge& edge, double y, bool near_film) const;
  double ray_y(int row, int ray) const { return row + middles_[static_cast<std::size_t>(ray)]; }

  PixelBox box_;
  Coverage coverage_ = Coverage::area;
  int rays_ = 0;
  std::vector<double> heights_;  ///< where the part of each ray begins
  std::vector<double> middles_;  ///< where each ray is
  std::vector<RowCuts> rows_;
};

}  // namespace flatray
