#include <immintrin.h>

#include "image/kernels/byte_kernels.h"

namespace flatray::kernels {
namespace baseline {
namespace {

typedef uint8_t Bytes __attribute__((vector_size(16)));
typedef uint16_t Halves __attribute__((vector_size(16)));
typedef uint32_t Words __attribute__((vector_size(16)));
#include "image/kernels/byte_kernels.inl"

}  // namespace
}  // namespace baseline

const ByteKernels baseline_bytes = {&baseline::subtract, &baseline::adler, nullptr};

}  // namespace flatray::kernels
