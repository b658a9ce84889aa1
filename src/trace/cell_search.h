#pragma once
#include "trace/candidates.h"
#include "trace/cells.h"
#include "trace/hits.h"
#include "trace/rays.h"
#include "trace/wall_cells.h"

namespace flatray {

/// The nearest hit of one ray at a time, by the cells of a grid in double precision, or by all walls
/// where there are no cells: what certain bounds leave open is decided exactly.
///
/// Cost    about 1 us, some more where bounds do not decide; 15 ns a wall without cells.
class CellSearch {
 public:
  /// Needs   `walls`, `curves` and `grid`, which may be null, to outlive it.
  CellSearch(const Surfaces& walls, const CellGrid* grid, const WallCells& curves)
      : walls_(walls),
        curves_(curves),
        listed_(grid),
        grid_(grid != nullptr && grid->has_cells() ? grid : nullptr) {}
  NearestHit nearest(const Ray& ray, const DepartedSurface& departed, bool tangents) const;
  /// Walls that it looks at for that, those in several cells once for each.
  std::size_t tested(const Ray& ray, const DepartedSurface& departed) const;
  /// Every hit, in order (Accelerator::all_of_one).
  std::vector<NearestHit> all(const Ray& ray, const DepartedSurface& departed, bool tangents) const;

 private:
  Candidates candidates(const Ray& ray, const DepartedSurface& departed) const;
  std::vector<std::uint32_t> segments_near(const Ray& ray) const;

  const Surfaces& walls_;
  const WallCells& curves_;
  const CellGrid* listed_;  // what knows copies
  const CellGrid* grid_;
};

}  // namespace flatray
