#include <immintrin.h>

#include "image/kernels/byte_kernels.h"
#include "image/kernels/light_kernels.h"

namespace flatray::kernels {
namespace avx512 {
namespace {

typedef uint8_t Bytes __attribute__((vector_size(64)));
typedef uint16_t Halves __attribute__((vector_size(64)));
typedef uint32_t Words __attribute__((vector_size(64)));
typedef int32_t Places __attribute__((vector_size(64)));
typedef float Lanes __attribute__((vector_size(64)));
#define FLATRAY_FIRST_PAIRS 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define FLATRAY_LAST_PAIRS 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#define FLATRAY_ONE_ON 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30
static inline Words nearest(Lanes v) { return (Words)_mm512_maskz_cvtps_epi32(0xffff, (__m512)v); }
#include "image/kernels/byte_kernels.inl"
#include "image/kernels/fold_crc.inl"
#include "image/kernels/light_kernels.inl"

}  // namespace
}  // namespace avx512

const ByteKernels avx512_bytes = {&avx512::subtract, &avx512::adler, &avx512::fold_crc};
const LightKernels avx512_light = {&avx512::deposit<1>, &avx512::deposit<3>};

}  // namespace flatray::kernels
