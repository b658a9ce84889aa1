#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "render/coverage_edges.h"

namespace flatray {

/// Whether a fill rule takes the points of a winding number.
inline bool covers(FillRule rule, int winding) {
  return rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
}

/// Area of a region inside one pixel in doubles.
///
/// Error   at most `bound`; 0 where every step is exact. `full`: certainly the whole pixel.
struct CellArea {
  double area = 0, bound = 0;
  bool full = false;
};

/// One piece within a slab: its x at the slab's upper and lower border.
struct Strand {
  const Piece* piece;
  double upper, lower;
};

/// Room for `slab_area`, kept from pixel to pixel.
struct SlabWork {
  std::vector<double> cuts, crossings;
  std::vector<Strand> strands;
};

/// What a piece adds to the integral of the winding number over its pixel. It raises the winding on
/// its right; where the edge crosses the left border, the winding along that border changes from
/// there down.
/// Error   at most `bound`: each end moves the sum by at most half its own error, and a corner cut
///         by the clamping by as much again; each term is rounded a few times.
struct Share {
  double area, bound;
};
inline Share share_of(const Piece& p) {
  const double bound = 4 * p.error + (p.exact ? 0 : 0x1p-49);
  if (p.ghost) return {0, bound};
  double area = (p.y_bottom - p.y_top) * (1 - 0.5 * (p.x_top + p.x_bottom));
  if (p.left_top) area -= 1 - p.y_top;
  if (p.left_bottom) area += 1 - p.y_bottom;
  return {p.direction * area, bound};
}

/// Sum of the shares of one pixel.
struct ShareSum {
  double area = 0, bound = 0;
  int pieces = 0;  ///< with the ghosts

  void add(const Share& share) {
    area += share.area;
    bound += share.bound;
    ++pieces;
  }
  /// With the rounding of the sum itself.
  double total_bound() const { return bound > 0 ? bound + 0x1p-52 * (1 + pieces * pieces) : 0; }
};

/// Needs   the pieces of one pixel with the ghosts; `winding` at its upper left corner, just
///         inside.
inline CellArea simple_area(const ShareSum& sum, int winding) {
  return {std::min(std::abs(winding + sum.area), 1.0), sum.total_bound(), false};
}
CellArea cell_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work);
/// Whether nonzero winding certainly covers the whole pixel, by bounds in blocks of it: finds most
/// pixels many pieces overlap in. Cost O(n).
bool certainly_full(std::span<const Piece> pieces, int winding);

/// The general case: horizontal slabs between the ends and crossings of the pieces.
/// Cost    for n pieces O(n^2) where they cross, else O(n log n) a slab.
CellArea slab_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work);

/// The step of an area, if its bound decides it.
inline std::optional<std::uint32_t> certain_steps(const CellArea& area) {
  if (area.full) return kFullCoverage;
  const double steps = kFullCoverage * area.area;
  if (area.bound == 0) return static_cast<std::uint32_t>(steps);
  const double slack = kFullCoverage * area.bound + 0x1p-36;  // and half an ulp of `steps`
  const auto low = static_cast<std::uint32_t>(std::max(steps - slack, 0.0));
  const auto high = static_cast<std::uint32_t>(std::min<double>(steps + slack, kFullCoverage));
  if (low != high) return std::nullopt;
  return low;
}

}  // namespace flatray
