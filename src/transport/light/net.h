#pragma once
#include <array>
#include <cstdint>

namespace flatray {

/// Numbers in [0, 1) that fill it more evenly than random ones: the first 2^k of them have one in
/// each of 2^k equal parts, whatever the seed. Seeds give independent sequences. Points of the first
/// two dimensions are nets.
///
/// Needs   a dimension below kMostNetDimensions.
/// Source  Sobol's sequence, with direction numbers of Joe and Kuo 2008; its first dimension is van der
///         Corput's. Scrambled as by Owen 1995 by the hash of Laine and Karras 2011 ("Stratified
///         sampling for stochastic transparency").
inline constexpr unsigned kMostNetDimensions = 5;
double net_number(std::uint32_t index, unsigned dimension, std::uint32_t seed);

}  // namespace flatray
