#include <immintrin.h>

#include "image/kernels/byte_kernels.h"

namespace flatray::kernels {
namespace avx512 {
namespace {

typedef uint8_t Bytes __attribute__((vector_size(64)));
typedef uint16_t Halves __attribute__((vector_size(64)));
typedef uint32_t Words __attribute__((vector_size(64)));
#include "image/kernels/byte_kernels.inl"
#include "image/kernels/fold_crc.inl"

}  // namespace
}  // namespace avx512

const ByteKernels avx512_bytes = {&avx512::subtract, &avx512::adler, &avx512::fold_crc};

}  // namespace flatray::kernels
