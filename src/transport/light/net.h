#pragma once
#include <array>
#include <cstdint>

namespace flatray {

/// Numbers in [0, 1) that fill it more evenly than random ones: the first 2^k of them have one in
/// each of 2^k equal parts, whatever the seed. Seeds give independent sequences.
///
/// Source  van der Corput's sequence, scrambled as by Owen 1995 by the hash of Laine and Karras 2011
///         ("Stratified sampling for stochastic transparency").
double net_number(std::uint32_t index, std::uint32_t seed);

/// Dimension `dimension` of Sobol's sequence, scrambled likewise; points of the first two are nets.
/// Source  direction numbers of Joe and Kuo 2008. Needs   a dimension below kMostNetDimensions.
inline constexpr unsigned kMostNetDimensions = 5;
double net_number(std::uint32_t index, unsigned dimension, std::uint32_t seed);

}  // namespace flatray
