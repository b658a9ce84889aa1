#pragma once
#include "trace/rays.h"

namespace flatray {

/// So many rays or fewer may be asked one by one even in one call: what is to be said of lanes needs
/// more.
inline constexpr std::size_t kMostRaysOneByOne = 16;

/// The rays, over and over where they are too few for lanes: ray i is ray i % rays.size().
inline RayBatch many_of(const RayBatch& rays) {
  RayBatch many = rays;
  for (std::size_t i = 0; rays.size() > 0 && many.size() <= kMostRaysOneByOne; ++i)
    many.add(rays.ray(i % rays.size()), rays.departed[i % rays.size()]);
  return many;
}

}  // namespace flatray
