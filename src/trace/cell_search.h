#pragma once
#include "trace/candidates.h"
#include "trace/cells.h"
#include "trace/hits.h"
#include "trace/rays.h"

namespace flatray {

/// The nearest hit of one ray at a time, by the cells of a grid in double precision, or by all walls
/// where there are no cells: what certain bounds leave open is decided exactly.
///
/// Cost    about 1 us, some more where bounds do not decide; 15 ns a wall without cells.
class CellSearch {
 public:
  /// Needs   `walls` and the cells of segments and of curves, which may be null, to outlive it.
  CellSearch(const Surfaces& walls, const CellGrid* segments, const CellGrid* curves,
             const lanes::WalkKernels& kernels)
      : walls_(walls), segments_(segments), curves_(curves), kernels_(kernels) {
    if (segments != nullptr) segment_view_ = segments->view();
    if (curves != nullptr) curve_view_ = curves->view();
  }
  NearestHit nearest(const Ray& ray, const DepartedSurface& departed, bool tangents) const;
  /// The same where it is known what is the first of the segments, or that there is none.
  NearestHit nearest_beside(const NearestHit& segment, const Ray& ray,
                            const DepartedSurface& departed, bool tangents) const;
  /// Walls that it looks at for that, those in several cells once for each.
  std::size_t tested(const Ray& ray, const DepartedSurface& departed) const;
  /// Every hit, in order (Accelerator::all_of_one).
  std::vector<NearestHit> all(const Ray& ray, const DepartedSurface& departed, bool tangents) const;

 private:
  Candidates candidates(const Ray& ray, const DepartedSurface& departed) const;
  void offer_curves(Candidates& found, const Ray& ray) const;
  std::vector<std::uint32_t> segments_near(const Ray& ray) const;
  std::vector<std::uint32_t> curves_near(const Ray& ray) const;

  const Surfaces& walls_;
  const CellGrid *segments_, *curves_;
  lanes::Grid segment_view_{}, curve_view_{};
  const lanes::WalkKernels& kernels_;
};

}  // namespace flatray
