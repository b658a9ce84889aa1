#pragma once
#include <array>
#include <cstdint>

namespace flatray {

/// Numbers in [0, 1) that fill it more evenly than random ones: the first 2^k of them have one in
/// each of 2^k equal parts, whatever the seed. Seeds give independent sequences.
///
/// Source  van der Corput's sequence, scrambled as by Owen 1995 by the hash of Laine and Karras 2011
///         ("Stratified sampling for stochastic transparency").
inline double net_number(std::uint32_t index, std::uint32_t seed);

/// Dimension `dimension` of Sobol's sequence, scrambled likewise; points of the first two are nets.
/// Source  direction numbers of Joe and Kuo 2008. Needs   a dimension below kMostNetDimensions.
inline constexpr unsigned kMostNetDimensions = 5;
double net_number(std::uint32_t index, unsigned dimension, std::uint32_t seed);

constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00U) >> 8) | ((x & 0x00ff00ffU) << 8);
  x = ((x & 0xf0f0f0f0U) >> 4) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x & 0xccccccccU) >> 2) | ((x & 0x33333333U) << 2);
  return ((x & 0xaaaaaaaaU) >> 1) | ((x & 0x55555555U) << 1);
}

// Of a number whose bits are reversed: each is changed by those below it alone.
constexpr std::uint32_t scrambled_bits(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return reversed_bits(x);
}

inline double net_number(std::uint32_t index, std::uint32_t seed) {
  return static_cast<double>(scrambled_bits(index, seed)) * 0x1p-32;
}

}  // namespace flatray
