#include "trace/surfaces.h"

namespace flatray {

std::uint32_t Surfaces::add(const Segment& wall) {
  segment_numbers.push_back(static_cast<std::uint32_t>(size()));
  slots_.push_back(static_cast<std::uint32_t>(segments.size()));
  segments.push_back(wall);
  return segment_numbers.back();
}

std::uint32_t Surfaces::add(const Arc& wall) {
  curve_numbers.push_back(static_cast<std::uint32_t>(size()));
  slots_.push_back(kCurved + static_cast<std::uint32_t>(arcs.size()));
  arcs.push_back(wall);
  return curve_numbers.back();
}

std::uint32_t Surfaces::add(const Bezier& wall) {
  curve_numbers.push_back(static_cast<std::uint32_t>(size()));
  slots_.push_back(kBezier + static_cast<std::uint32_t>(beziers.size()));
  beziers.push_back(wall);
  return curve_numbers.back();
}

Bounds bounds_of(const Surfaces& walls) {
  Bounds box;
  for (const Segment& wall : walls.segments) box.add(bounds_of(wall));
  for (const Arc& wall : walls.arcs) box.add(bounds_of(wall));
  for (const Bezier& wall : walls.beziers) box.add(bounds_of(wall));
  return box;
}

}  // namespace flatray
