#include <immintrin.h>

#include "image/kernels/byte_kernels.h"
#include "image/kernels/light_kernels.h"

namespace flatray::kernels {
namespace baseline {
namespace {

typedef uint8_t Bytes __attribute__((vector_size(16)));
typedef uint16_t Halves __attribute__((vector_size(16)));
typedef uint32_t Words __attribute__((vector_size(16)));
typedef int32_t Places __attribute__((vector_size(16)));
typedef float Lanes __attribute__((vector_size(16)));
#define FLATRAY_FIRST_PAIRS 0, 4, 1, 5
#define FLATRAY_LAST_PAIRS 2, 6, 3, 7
#define FLATRAY_ONE_ON 3, 4, 5, 6
static inline Words nearest(Lanes v) { return (Words)_mm_cvtps_epi32((__m128)v); }
#include "image/kernels/byte_kernels.inl"
#include "image/kernels/light_kernels.inl"

}  // namespace
}  // namespace baseline

const ByteKernels baseline_bytes = {&baseline::subtract, &baseline::adler, nullptr};
const LightKernels baseline_light = {&baseline::deposit<1>, &baseline::deposit<3>};

}  // namespace flatray::kernels
