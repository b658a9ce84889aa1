#pragma once
#include <atomic>

#include "trace/tracer.h"

namespace flatray {

/// What was asked of counting_tracer().
struct TracerCounts {
  std::atomic<std::size_t> builds{0}, walls{0}, nearest{0}, all{0};
};
inline TracerCounts& tracer_counts() {
  static TracerCounts counts;
  return counts;
}

/// `exact` under another name, that counts.
class CountingAccelerator : public Accelerator {
 public:
  explicit CountingAccelerator(const Surfaces& walls)
      : Accelerator(walls), inner_(find_tracer("exact")->build(walls)) {
    ++tracer_counts().builds;
    tracer_counts().walls += walls.size();
  }
  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    tracer_counts().nearest += rays.size();
    inner_->nearest(rays, hits);
  }
  std::vector<NearestHit> all_of_one(const Ray& ray, const DepartedSurface& left,
                                     bool tangents) const override {
    ++tracer_counts().all;
    return inner_->all_of_one(ray, left, tangents);
  }
  std::size_t bytes() const override { return 0; }

 private:
  const std::unique_ptr<Accelerator> inner_;
};

/// Counts from zero.
inline const Tracer* counting_tracer() {
  static const Tracer tracer = {
      "counting", "exact, counted", true, [](const Surfaces& walls, Isa, unsigned) {
        return std::unique_ptr<Accelerator>(std::make_unique<CountingAccelerator>(walls));
      }};
  TracerCounts& counts = tracer_counts();
  counts.builds = counts.walls = counts.nearest = counts.all = 0;
  return &tracer;
}

}  // namespace flatray
