#pragma once
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

/// Needs   the pieces of one pixel with the ghosts; `winding` at its upper left corner, just
/// inside.
CellArea simple_area(std::span<const Piece> pieces, int winding);
CellArea cell_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work);
/// The general case: horizontal slabs between the ends and crossings of the pieces.
/// Cost    for n pieces O(n^2) where they cross, else O(n log n) a slab.
CellArea slab_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work);

/// The step of an area, if its bound decides it.
std::optional<std::uint32_t> certain_steps(const CellArea& area);

}  // namespace flatray
