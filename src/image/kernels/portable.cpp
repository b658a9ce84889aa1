#include "image/kernels/byte_kernels.h"

namespace flatray::kernels {
namespace portable {
namespace {

void subtract(uint8_t* out, const uint8_t* row, const uint8_t* before, size_t count) {
  for (size_t i = 0; i < count; ++i) out[i] = (uint8_t)(row[i] - before[i]);
}

AdlerSums adler(AdlerSums sums, const uint8_t* bytes, size_t count) {
  // So many bytes of 255 after sums below the modulus fit 32 bits.
  constexpr size_t kAtOnce = 5552;
  while (count > 0) {
    const size_t now = count < kAtOnce ? count : kAtOnce;
    for (size_t i = 0; i < now; ++i) {
      sums.a += bytes[i];
      sums.b += sums.a;
    }
    sums = {sums.a % kAdlerModulus, sums.b % kAdlerModulus};
    bytes += now, count -= now;
  }
  return sums;
}

}  // namespace
}  // namespace portable

const ByteKernels portable_bytes = {&portable::subtract, &portable::adler, nullptr};

}  // namespace flatray::kernels
