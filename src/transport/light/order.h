#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace flatray {

/// Where light comes to a wall, as a number that orders: the wall, then the place along it.
using WallPlace = std::uint64_t;

/// The numbers of `places` in ascending order, those of equal places in their own: by radix.
/// Cost    some 2 ns a place and byte in which they differ.
std::vector<std::uint32_t> ascending_order(std::span<const WallPlace> places);

}  // namespace flatray
