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
    search.offer_all();
    return search.hit();
  }
  std::size_t bytes() const override { return 0; }
};

}  // namespace

extern const Tracer entry = {
    "exact", "every wall against every ray by exact comparisons alone: slow, for checking", true,
    [](const Surfaces& walls, Isa, unsigned) -> std::unique_ptr<Accelerator> {
      return std::make_unique<Exact>(walls);
    }};

}  // namespace flatray::exact_tracer
