#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/vec.h"

namespace flatray {

/// Word of a cell without segments (kernels/walk.h).
inline constexpr std::uint32_t kEmptyCell = 0x80000000U;

/// A rectangle of cells, the lower left corner of the first being (0, 0).
struct Raster {
  std::int32_t columns, rows;
  double margin;  ///< in cells
};

/// Where a raster lies among the cells of a grid: its corner (0, 0), and how many of its cells are as long as one of
/// those.
struct Frame {
  Vec2 corner;
  double parts;
};

/// Rows first, ..., last; none where last < first.
struct RowRange {
  std::int32_t first, last;
};

inline std::int32_t cell_of(double x) {
  return static_cast<std::int32_t>(std::floor(std::clamp(x, -1.0, 1e6)));
}

/// Rows that a segment comes near to.
inline RowRange rows_near(const Raster& raster, const Vec2& a, const Vec2& b) {
  const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
  return {std::max(cell_of(low - raster.margin), 0),
          std::min(cell_of(high + raster.margin), raster.rows - 1)};
}

/// Cells that a segment comes near to, of the rows in `range`. Row by row: the part of the segment
/// in the row and a margin around it, and a margin beside that. A rounding moves the part up or down
/// by 2^-50 cells, the margin is 128 units and the walk needs 88.
template <class Visit>
void visit_cells(const Raster& raster, const RowRange& range, Vec2 a, Vec2 b, const Visit& visit) {
  if (a.y() > b.y()) std::swap(a, b);
  const double rise = b.y() - a.y(), run = b.x() - a.x();
  const auto x_at = [&](double y) {
    return rise > 0 ? a.x() + std::clamp((y - a.y()) / rise, 0.0, 1.0) * run : a.x();
  };
  const RowRange near = rows_near(raster, a, b);
  const std::int32_t last = std::min(near.last, range.last);
  for (auto row = std::max(near.first, range.first); row <= last; ++row) {
    double low = rise > 0 ? x_at(row - raster.margin) : a.x();
    double high = rise > 0 ? x_at(row + 1 + raster.margin) : b.x();
    if (low > high) std::swap(low, high);
    const std::int32_t end = std::min(cell_of(high + raster.margin), raster.columns - 1);
    for (auto column = std::max(cell_of(low - raster.margin), 0); column <= end; ++column)
      visit(column, row);
  }
}

/// A rectangle of cells.
struct CellRect {
  std::int32_t left, bottom, width, height;
};
/// Cells of a rectangle that a curve comes near to, by halves of it: `may_pass(middle, half)` is whether the
/// curve does to the box of half sides `half` about `middle`.
template <class MayPass, class Visit>
void visit_rect(const CellRect& rect, const MayPass& may_pass, const Visit& visit) {
  const auto [left, bottom, width, height] = rect;
  const Vec2 half(0.5 * width, 0.5 * height);
  if (width <= 0 || height <= 0 || !may_pass(Vec2(left, bottom) + half, half)) return;
  if (width == 1 && height == 1) return visit(left, bottom);
  const bool across = width >= height;
  const std::int32_t w = across ? width / 2 : width, h = across ? height : height / 2;
  visit_rect({left, bottom, w, h}, may_pass, visit);
  visit_rect(across ? CellRect{left + w, bottom, width - w, height}
                    : CellRect{left, bottom + h, width, height - h},
             may_pass, visit);
}

/// Writes into the words of empty cells the sides of the squares of empty cells that grow from
/// them in four directions. `stride` is from row to row.
void mark_empty(std::uint32_t* words, std::size_t stride, const Raster& raster, unsigned threads);

}  // namespace flatray
