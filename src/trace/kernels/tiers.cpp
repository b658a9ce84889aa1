#include "trace/kernels/tiers.h"

namespace flatray {

const lanes::Kernels& lane_kernels(Isa isa) {
  static constexpr const lanes::Kernels* kTiers[] = {
    &lanes::portable::kKernels,
#if defined(__x86_64__)
    &lanes::baseline::kKernels,
    &lanes::avx2::kKernels,
    &lanes::avx512::kKernels
#endif
  };
  return *of_tier(kTiers, isa);
}

}  // namespace flatray
