#pragma once
#include <span>
#include <vector>

#include "trace/kernels/lanes.h"
#include "trace/whole_nearest.h"

namespace flatray {

/// Every wall against the rays that are whole with them, in lanes that none of these has to leave.
class WholeLanes {
 public:
  /// Needs   `walls` and `whole`, which is of them, to outlive it.
  WholeLanes(const Surfaces& walls, const WholeWalls& whole, const lanes::WholeKernels& kernels)
      : walls_(walls), whole_(whole), kernels_(kernels) {}

  /// The hits of rays that are whole, and the numbers of the others after those in `others`.
  ///
  /// Gives   false, and no hit, where there may be few: less than half of the first eight.
  bool nearest(const RayBatch& rays, std::span<NearestHit> hits,
               std::vector<std::size_t>& others) const;

 private:
  bool begin_whole(const RayBatch& rays) const;
  NearestHit hit(const Ray& ray, double wall, double t, double sides) const;

  const Surfaces& walls_;
  const WholeWalls& whole_;
  const lanes::WholeKernels& kernels_;
};

}  // namespace flatray
