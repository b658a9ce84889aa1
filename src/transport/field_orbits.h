#pragma once
#include <span>
#include <vector>

#include "transport/orbit_tracer.h"

namespace flatray {

/// A room in a magnetic field across it.
struct FieldRoom {
  const Surfaces& walls;
  std::span<const Material> materials;  ///< by surface
  const ExactOrigins& origins;
  double field;  ///< as OrbitRules has it, not 0
};

/// Follows orbit `number` along arcs of circles, as OrbitTracer::follow.
void follow_in_field(const FieldRoom& room, const OrbitStart& start, std::uint64_t bounces,
                     std::size_t number, OrbitSink& sink);

/// Points of a flight in a field up to another of its points, to draw it, without the first and the last:
/// 256 to a full turn. Where both are one it is the full turn.
std::vector<Vec2> points_between(double field, const Ray& flight, const Vec2& to);

}  // namespace flatray
