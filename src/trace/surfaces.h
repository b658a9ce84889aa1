#pragma once
#include <cstdint>
#include <vector>

#include "geom/ray.h"

namespace flatray {

enum class SurfaceKind : std::uint8_t { segment, circle };

/// Walls as flat arrays. Surface i is `kinds[i]`, stored at `slot[i]` of its kind's array.
struct Surfaces {
  std::vector<SurfaceKind> kinds;
  std::vector<std::uint32_t> slot;
  std::vector<Segment> segments;
  std::vector<Circle> circles;

  std::size_t size() const { return kinds.size(); }
  std::uint32_t add(const Segment& segment);
  std::uint32_t add(const Circle& circle);
};

}  // namespace flatray
