#pragma once
#include <span>
#include <vector>

#include "geom/bounds.h"
#include "image/image.h"

namespace flatray {

/// How much of some paths lies in each cell of a grid, rows top-down.
class LineDensity {
 public:
  LineDensity(const Bounds& window, int width, int height);

  /// Adds the part of a segment that lies in the window: its length in each cell, in cells.
  void add(const Vec2& from, const Vec2& to);

  /// Adds what another of the same size has.
  void add_cells(std::span<const double> cells);

  const std::vector<double>& cells() const { return cells_; }
  /// The light of the density on black, the mean of what is lit at half.
  Image picture() const;
  /// There heat(1 - e^(-scale cell)) of a cell.
  double scale() const;

 private:
  Bounds window_;
  int width_, height_;
  std::vector<double> cells_;
};

}  // namespace flatray
