#include <immintrin.h>

#include "image/kernels/byte_kernels.h"
#include "image/kernels/light_kernels.h"

namespace flatray::kernels {
namespace avx2 {
namespace {

typedef uint8_t Bytes __attribute__((vector_size(32)));
typedef uint16_t Halves __attribute__((vector_size(32)));
typedef uint32_t Words __attribute__((vector_size(32)));
typedef int32_t Places __attribute__((vector_size(32)));
typedef float Lanes __attribute__((vector_size(32)));
#define FLATRAY_FIRST_PAIRS 0, 8, 1, 9, 2, 10, 3, 11
#define FLATRAY_LAST_PAIRS 4, 12, 5, 13, 6, 14, 7, 15
#define FLATRAY_ONE_ON 7, 8, 9, 10, 11, 12, 13, 14
static inline Words nearest(Lanes v) { return (Words)_mm256_cvtps_epi32((__m256)v); }
#include "image/kernels/byte_kernels.inl"
#include "image/kernels/fold_crc.inl"
#include "image/kernels/light_kernels.inl"

}  // namespace
}  // namespace avx2

const ByteKernels avx2_bytes = {&avx2::subtract, &avx2::adler, &avx2::fold_crc};
const LightKernels avx2_light = {&avx2::deposit<1>, &avx2::deposit<3>};

}  // namespace flatray::kernels
