#pragma once
#include <cstdint>
#include <vector>

#include "render/coverage/scan_edge.h"
#include "render/pixel_box.h"

namespace flatray {

/// Part of an edge inside one pixel, in coordinates of the pixel; or where it crosses a ray of the
/// pixel's row, at x = `x_top`.
struct Piece {
  std::int32_t column;
  std::uint32_t item;
  double x_top, y_top, x_bottom, y_bottom;
  const EdgeCurve* curve;      ///< null where it is straight
  std::int8_t direction;       ///< that of the edge
  bool crosses_top;            ///< the edge comes in by the row's upper border, in this pixel
  bool left_top, left_bottom;  ///< this end is where the edge crosses the pixel's left border
  std::int8_t ray;             ///< of the row
};

/// A change of an item's winding number left of all pixels: along the row's upper border, or along
/// one of its rays.
struct LeftOfRow {
  std::uint32_t item;
  std::int8_t direction, ray;
};

struct RowPieces {
  std::vector<Piece> pieces;
  std::vector<LeftOfRow> left;

  void clear() { pieces.clear(), left.clear(); }
};

/// Cuts edges by the rows and columns of a box of pixels. What it gives for a pixel does not depend
/// on the box.
class RowCutter {
 public:
  /// Rows of the box, each with `rays` rays; 0 to cut by areas.
  void begin(const PixelBox& box, Coverage coverage, int rays);
  /// Adds the pieces of an edge.
  void cut(const ScanEdge& edge, std::uint32_t item);
  RowPieces& row(int y) { return rows_[static_cast<std::size_t>(y - box_.y)]; }
  std::size_t pieces() const { return pieces_; }  ///< since begin()

 private:
  void cut_area(const ScanEdge& edge, std::uint32_t item);
  void cut_rays(const ScanEdge& edge, std::uint32_t item);
  int first_centre(const ScanEdge& edge, double y, bool near_film) const;

  PixelBox box_;
  Coverage coverage_ = Coverage::area;
  int rays_ = 0;
  std::size_t pieces_ = 0;
  std::vector<RowPieces> rows_;
};

}  // namespace flatray
