#pragma once
#include <algorithm>
#include <array>

#include "trace/kernels/lanes.h"
#include "trace/rays.h"

namespace flatray {

/// Rays a kernel call takes at most: their columns and results stay in the first cache.
inline constexpr std::size_t kRayBlock = 256;
static_assert(kRayBlock % lanes::kWidest == 0);

/// Some rays of a batch as a kernel takes them, the last one again up to a multiple of the widest
/// tier's lanes.
struct RayBlock {
  std::array<double, kRayBlock> ox, oy, dx, dy;
  int padded = 0;

  /// Takes the rays from `begin` on, at most kRayBlock. Gives how many.
  std::size_t load(const RayBatch& rays, std::size_t begin) {
    const auto wide = static_cast<std::size_t>(lanes::kWidest);
    const std::size_t count = std::min(kRayBlock, rays.size() - begin);
    const std::size_t whole = (count + wide - 1) / wide * wide;
    for (std::size_t i = 0; i < whole; ++i) {
      const std::size_t from = begin + std::min(i, count - 1);
      ox[i] = rays.ox[from];
      oy[i] = rays.oy[from];
      dx[i] = rays.dx[from];
      dy[i] = rays.dy[from];
    }
    padded = static_cast<int>(whole);
    return count;
  }
  lanes::Rays lanes() const { return {ox.data(), oy.data(), dx.data(), dy.data(), padded}; }
};

}  // namespace flatray
