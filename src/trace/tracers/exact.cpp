#include "trace/exact_nearest.h"
#include "trace/tracer.h"

namespace flatray::exact_tracer {
namespace {

class Exact : public Accelerator {
 public:
  using Accelerator::Accelerator;
  NearestHit nearest_of_one(const Ray& ray, const DepartedSurface& departed,
                            bool tangents) const override {
    ExactNearest search(walls_, ray, departed, tangents);
    for (std::uint32_t surface = 0; surface < walls_.size(); ++surface) search.offer(surface);
    return search.hit();
  }
  std::size_t bytes() const override { return 0; }
};

std::unique_ptr<Accelerator> build(const Surfaces& walls, Isa, unsigned) {
  return std::make_unique<Exact>(walls);
}

}  // namespace

extern const Tracer entry = {
    "exact", "every wall against every ray by exact comparisons alone: slow, for checking", true,
    &build};

}  // namespace flatray::exact_tracer
