#pragma once
#include <stddef.h>
#include <stdint.h>

/// Kernels of the PNG writer over rows of bytes, one table for each instruction-set tier. Plain
/// types only: what a tier compiles must not leave its file. All tiers give the same bytes.
namespace flatray::kernels {

/// The two sums of Adler-32, each below kAdlerModulus.
struct AdlerSums {
  uint32_t a, b;
};
constexpr uint32_t kAdlerModulus = 65521;

struct ByteKernels {
  /// out[i] = row[i] - before[i], modulo 256.
  void (*subtract)(uint8_t* out, const uint8_t* row, const uint8_t* before, size_t count);
  AdlerSums (*adler)(AdlerSums sums, const uint8_t* bytes, size_t count);
  /// Folds blocks of 64 bytes after a CRC-32 register into 16 bytes with the same remainder (the
  /// register 0 before them). Null where the tier does not multiply without carry.
  void (*fold_crc)(uint32_t crc, const uint8_t* bytes, size_t blocks, uint8_t* folded);
};

extern const ByteKernels portable_bytes, baseline_bytes, avx2_bytes, avx512_bytes;

}  // namespace flatray::kernels
