#pragma once
#include <cstdint>
#include <vector>

#include "geom/arc.h"
#include "geom/bounds.h"

namespace flatray {

enum class SurfaceKind : std::uint8_t { segment, circle, arc };

/// No surface: a ray that hits nothing, or has left none.
inline constexpr std::uint32_t kNoSurface = 0xffffffffU;

/// Walls as flat arrays. Surface i is `kinds[i]`, stored at `slot[i]` of its kind's array; the
/// numbers lead back.
struct Surfaces {
  std::vector<SurfaceKind> kinds;
  std::vector<std::uint32_t> slot;
  std::vector<Segment> segments;
  std::vector<Circle> circles;
  std::vector<Arc> arcs;  ///< of ellipses and circles, and whole ellipses
  std::vector<std::uint32_t> segment_numbers, circle_numbers,
      arc_numbers;  ///< surface by slot, ascending

  std::size_t size() const { return kinds.size(); }
  /// Puts a wall at the end and gives its number. Needs finite coordinates, radius >= 0, and
  /// what Arc needs.
  std::uint32_t add(const Segment& segment);
  std::uint32_t add(const Circle& circle);
  std::uint32_t add(const Arc& arc);

  bool is_straight(std::uint32_t surface) const { return kinds[surface] == SurfaceKind::segment; }
  /// Whether there is any other kind.
  bool any_curves() const { return !circles.empty() || !arcs.empty(); }
  /// A curved wall as an arc: of a circle, the whole.
  Arc arc(std::uint32_t surface) const {
    return kinds[surface] == SurfaceKind::circle
               ? Arc{circles[slot[surface]], Arc::Extent::whole, {0, 0}, {0, 0}}
               : arcs[slot[surface]];
  }
  /// The whole curve of a curved wall.
  Ellipse curve(std::uint32_t surface) const {
    return kinds[surface] == SurfaceKind::circle ? Ellipse(circles[slot[surface]])
                                                 : arcs[slot[surface]].curve;
  }
};

/// A box that holds all walls.
Bounds bounds_of(const Surfaces& walls);

}  // namespace flatray
