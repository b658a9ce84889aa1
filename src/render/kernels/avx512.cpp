#include <immintrin.h>

#include "render/kernels/span_kernels.h"

namespace flatray::kernels {
namespace avx512 {
namespace {

typedef float Lanes __attribute__((vector_size(64)));
typedef double Rows __attribute__((vector_size(64)));
#include "render/kernels/centre_kernel.inl"
#include "render/kernels/span_kernels.inl"

}  // namespace
}  // namespace avx512

const SpanKernels avx512_kernels = {&avx512::blend_runs, &avx512::edge_columns,
                                    &avx512::centre_runs, &avx512::fill};

}  // namespace flatray::kernels
