#pragma once
#include <cstdint>
#include <vector>

#include "geom/ray.h"

namespace flatray {

enum class SurfaceKind : std::uint8_t { segment, circle };

/// No surface: a ray that hits nothing, or has left none.
inline constexpr std::uint32_t kNoSurface = 0xffffffffU;

/// Walls as flat arrays. Surface i is `kinds[i]`, stored at `slot[i]` of its kind's array; the
/// numbers lead back.
struct Surfaces {
  std::vector<SurfaceKind> kinds;
  std::vector<std::uint32_t> slot;
  std::vector<Segment> segments;
  std::vector<Circle> circles;
  std::vector<std::uint32_t> segment_numbers, circle_numbers;  ///< surface by slot, ascending

  std::size_t size() const { return kinds.size(); }
  /// Puts a wall at the end and gives its number. Needs finite coordinates, radius >= 0.
  std::uint32_t add(const Segment& segment);
  std::uint32_t add(const Circle& circle);
};

}  // namespace flatray
