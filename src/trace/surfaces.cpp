#include "trace/surfaces.h"

namespace flatray {
namespace {

std::uint32_t append(Surfaces& walls, SurfaceKind kind, std::size_t slot,
                     std::vector<std::uint32_t>& numbers) {
  const auto number = static_cast<std::uint32_t>(walls.size());
  walls.kinds.push_back(kind);
  walls.slot.push_back(static_cast<std::uint32_t>(slot));
  numbers.push_back(number);
  return number;
}

}  // namespace

std::uint32_t Surfaces::add(const Segment& segment) {
  segments.push_back(segment);
  return append(*this, SurfaceKind::segment, segments.size() - 1, segment_numbers);
}

std::uint32_t Surfaces::add(const Circle& circle) {
  circles.push_back(circle);
  return append(*this, SurfaceKind::circle, circles.size() - 1, circle_numbers);
}

std::uint32_t Surfaces::add(const Arc& arc) {
  arcs.push_back(arc);
  return append(*this, SurfaceKind::arc, arcs.size() - 1, arc_numbers);
}

Bounds bounds_of(const Surfaces& walls) {
  Bounds box;
  for (const Segment& wall : walls.segments) {
    box.add(wall.a);
    box.add(wall.b);
  }
  const auto hold = [&](const Bounds& curve) {
    box.add(curve.low);
    box.add(curve.high);
  };
  for (const Circle& wall : walls.circles) hold(curve_bounds(wall));
  for (const Arc& wall : walls.arcs) hold(curve_bounds(wall.curve));
  return box;
}

}  // namespace flatray
