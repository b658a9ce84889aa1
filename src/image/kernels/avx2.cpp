#include <immintrin.h>

#include "image/kernels/byte_kernels.h"

namespace flatray::kernels {
namespace avx2 {
namespace {

typedef uint8_t Bytes __attribute__((vector_size(32)));
typedef uint16_t Halves __attribute__((vector_size(32)));
typedef uint32_t Words __attribute__((vector_size(32)));
#include "image/kernels/byte_kernels.inl"
#include "image/kernels/fold_crc.inl"

}  // namespace
}  // namespace avx2

const ByteKernels avx2_bytes = {&avx2::subtract, &avx2::adler, &avx2::fold_crc};

}  // namespace flatray::kernels
