#include "trace/kernels/tiers.h"

namespace flatray {

const lanes::Kernels& lane_kernels(Isa isa) {
#if defined(__x86_64__)
  switch (isa) {
    case Isa::avx512:
      return lanes::avx512::kKernels;
    case Isa::avx2:
      return lanes::avx2::kKernels;
    case Isa::baseline:
      return lanes::baseline::kKernels;
    case Isa::portable:
      break;
  }
#else
  static_cast<void>(isa);
#endif
  return lanes::portable::kKernels;
}

}  // namespace flatray
