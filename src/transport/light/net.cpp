#include "transport/light/net.h"

#include "base/check.h"

namespace flatray {
namespace {

constexpr unsigned kBits = 32;
using Directions = std::array<std::uint32_t, kBits>;

// Of a primitive polynomial of a degree with inner coefficients `a`, and the first numbers m.
constexpr Directions directions(unsigned degree, std::uint32_t a,
                                std::array<std::uint32_t, 4> first) {
  Directions v{};
  for (unsigned i = 0; i < kBits; ++i) {
    if (i < degree) {
      v[i] = first[i] << (kBits - 1 - i);
      continue;
    }
    v[i] = v[i - degree] ^ (v[i - degree] >> degree);
    for (unsigned k = 1; k < degree; ++k)
      if (((a >> (degree - 1 - k)) & 1U) != 0) v[i] ^= v[i - k];
  }
  return v;
}

constexpr Directions kDirections[kMostNetDimensions] = {{},  // van der Corput's own
                                                        directions(1, 0, {1}),
                                                        directions(2, 1, {1, 3}),
                                                        directions(3, 1, {1, 3, 1}),
                                                        directions(3, 2, {1, 1, 1})};

std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00U) >> 8) | ((x & 0x00ff00ffU) << 8);
  x = ((x & 0xf0f0f0f0U) >> 4) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x & 0xccccccccU) >> 2) | ((x & 0x33333333U) << 2);
  return ((x & 0xaaaaaaaaU) >> 1) | ((x & 0x55555555U) << 1);
}

// Of a number whose bits are reversed: each is changed by those below it alone.
std::uint32_t scrambled_bits(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return reversed_bits(x);
}

// With its bits reversed.
std::uint32_t sobol(std::uint32_t index, unsigned dimension) {
  if (dimension == 0) return index;
  std::uint32_t x = 0;
  for (const std::uint32_t v : kDirections[dimension]) {
    if (index == 0) break;
    if ((index & 1U) != 0) x ^= v;
    index >>= 1;
  }
  return reversed_bits(x);
}

}  // namespace

double net_number(std::uint32_t index, unsigned dimension, std::uint32_t seed) {
  FLATRAY_DCHECK(dimension < kMostNetDimensions);
  return static_cast<double>(scrambled_bits(sobol(index, dimension), seed)) * 0x1p-32;
}

}  // namespace flatray
