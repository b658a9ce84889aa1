#include "trace/surfaces.h"

namespace flatray {

template <class Wall>
std::uint32_t Surfaces::put(const Wall& wall, std::vector<Wall>& kind, std::uint32_t which,
                            std::vector<std::uint32_t>& numbers) {
  numbers.push_back(static_cast<std::uint32_t>(size()));
  slots_.push_back(which + static_cast<std::uint32_t>(kind.size()));
  kind.push_back(wall);
  return numbers.back();
}

std::uint32_t Surfaces::add(const Segment& wall) { return put(wall, segments, 0, segment_numbers); }
std::uint32_t Surfaces::add(const Arc& wall) { return put(wall, arcs, kCurved, curve_numbers); }
std::uint32_t Surfaces::add(const Bezier& wall) {
  return put(wall, beziers, kBezier, curve_numbers);
}

Bounds bounds_of(const Surfaces& walls) {
  Bounds box;
  for (const Segment& wall : walls.segments) box.add(bounds_of(wall));
  for (const Arc& wall : walls.arcs) box.add(bounds_of(wall));
  for (const Bezier& wall : walls.beziers) box.add(bounds_of(wall));
  return box;
}

}  // namespace flatray
