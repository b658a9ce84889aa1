#include <immintrin.h>

#include "render/kernels/span_kernels.h"

namespace flatray::kernels {
namespace avx2 {
namespace {

typedef float Lanes __attribute__((vector_size(32)));
typedef double Rows __attribute__((vector_size(32)));
#include "render/kernels/centre_kernel.inl"
#include "render/kernels/span_kernels.inl"

}  // namespace
}  // namespace avx2

const SpanKernels avx2_kernels = {&avx2::blend_runs, &avx2::edge_columns, &avx2::centre_runs,
                                  &avx2::fill};

}  // namespace flatray::kernels
