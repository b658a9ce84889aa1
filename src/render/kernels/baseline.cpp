#include <immintrin.h>

#include "render/kernels/span_kernels.h"

namespace flatray::kernels {
namespace baseline {
namespace {

typedef float Lanes __attribute__((vector_size(16)));
typedef double Rows __attribute__((vector_size(16)));
#include "render/kernels/centre_kernel.inl"
#include "render/kernels/span_kernels.inl"

}  // namespace
}  // namespace baseline

const SpanKernels baseline_kernels = {&baseline::blend_runs, &baseline::edge_columns,
                                      &baseline::centre_runs, &baseline::fill};

}  // namespace flatray::kernels
