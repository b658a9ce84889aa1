#pragma once
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
PartCounts part_counts(const Shape& shape);

}  // namespace flatray
