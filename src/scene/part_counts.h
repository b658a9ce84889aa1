#pragma once
#include <algorithm>

#include "scene/scene.h"

namespace flatray {

/// How many parts of each kind a shape has. Every kind is told here, so that what asks whether a shape
/// is one disc, or only lines, leaves none out.
struct PartCounts {
  std::size_t pieces = 0, crossing_rings = 0, circles = 0, closed_paths = 0;  ///< with an inside
  std::size_t segments = 0, open_paths = 0, beziers = 0;                      ///< lines

  std::size_t areas() const { return pieces + crossing_rings + circles + closed_paths; }
  std::size_t lines() const { return segments + open_paths + beziers; }
  /// Curves that are no circles: ellipses, arcs and Bezier curves.
  std::size_t other_curves() const { return closed_paths + open_paths + beziers; }
  bool operator==(const PartCounts&) const = default;
};
inline PartCounts part_counts(const Shape& shape) {
  const auto closed = static_cast<std::size_t>(
      std::ranges::count_if(shape.arc_paths, [](const ArcPath& path) { return path.closed; }));
  return {shape.piece_count(),   shape.crossing_rings.size(),     shape.circles.size(), closed,
          shape.segments.size(), shape.arc_paths.size() - closed, shape.beziers.size()};
}

}  // namespace flatray
