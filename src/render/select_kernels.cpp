#include "render/select_kernels.h"

namespace flatray {

const kernels::SpanKernels& span_kernels([[maybe_unused]] Isa isa) {
#if defined(__x86_64__)
  switch (isa) {
    case Isa::avx512:
      return kernels::avx512_kernels;
    case Isa::avx2:
      return kernels::avx2_kernels;
    case Isa::baseline:
      return kernels::baseline_kernels;
    case Isa::portable:
      break;
  }
#endif
  return kernels::portable_kernels;
}

}  // namespace flatray
