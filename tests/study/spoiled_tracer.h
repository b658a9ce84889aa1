#pragma once
#include <memory>

#include "trace/tracer.h"

namespace flatray::testing {

/// Answers as `brute` does, but for what is done to the hits of a batch.
template <void (*spoil)(std::span<NearestHit>)>
class Spoiled final : public Accelerator {
 public:
  explicit Spoiled(const Surfaces& walls)
      : Accelerator(walls), right_(find_tracer("brute")->build(walls)) {}
  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    right_->nearest(rays, hits);
    spoil(hits);
  }
  std::size_t bytes() const override { return right_->bytes(); }

 private:
  std::unique_ptr<Accelerator> right_;
};

/// Such a tracer, which says that it is exact.
template <void (*spoil)(std::span<NearestHit>)>
Tracer spoiled_by() {
  return {"spoiled", "", true, [](const Surfaces& walls, Isa, unsigned) {
            return std::unique_ptr<Accelerator>(std::make_unique<Spoiled<spoil>>(walls));
          }};
}

}  // namespace flatray::testing
