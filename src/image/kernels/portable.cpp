#include "image/kernels/byte_kernels.h"
#include "image/kernels/light_kernels.h"

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

// To the nearest whole number, ties to even: beyond 2^52 doubles have no others.
uint32_t total(float units, float u) {
  const float sum = units * u;
  return (uint32_t)(((double)sum + 0x1p52) - 0x1p52);
}

float smaller(float a, float b) { return a < b ? a : b; }
float larger(float a, float b) { return a > b ? a : b; }

template <int kChannels>
void deposit_piece(const LightPiece& piece, const LightLayer& layer) {
  for (int column = (int)piece.from; (float)column < piece.to; ++column) {
    const float u0 = larger((float)column, piece.from);
    const float u1 = smaller((float)(column + 1), piece.to);
    const float v = piece.minor + piece.slope * u0;
    const int row = (int)smaller(larger(v, 0.0F), layer.last_row);
    const float next = (float)(row + 1) - piece.minor;
    const float m = smaller(larger(next * piece.run, u0), u1);
    const ptrdiff_t place = (layer.first + layer.step * column) * kLightColumn + row + 1;
    uint32_t* sums = layer.sums + place * kChannels;
    for (int c = 0; c < kChannels; ++c) {
      const uint32_t middle = total(piece.units[c], m);
      sums[c] += middle - total(piece.units[c], u0);
      sums[kChannels + c] += total(piece.units[c], u1) - middle;
    }
  }
}

template <int kChannels>
void deposit(const LightPiece* pieces, size_t count, const LightLayer& layer) {
  for (size_t i = 0; i < count; ++i) deposit_piece<kChannels>(pieces[i], layer);
}

}  // namespace
}  // namespace portable

const ByteKernels portable_bytes = {&portable::subtract, &portable::adler, nullptr};
const LightKernels portable_light = {&portable::deposit<1>, &portable::deposit<3>};

}  // namespace flatray::kernels
