#pragma once
#include "transport/orbit.h"

namespace flatray {

inline Surfaces ring(const std::vector<Vec2>& vertices) {
  Surfaces walls;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    walls.add(Segment{vertices[i], vertices[(i + 1) % vertices.size()]});
  return walls;
}

inline std::vector<Material> all_mirrors(const Surfaces& walls) {
  return std::vector<Material>(walls.size(), Material::mirror);
}

inline Orbit in_mirrors(const Surfaces& walls, const Ray& start, std::uint64_t bounces) {
  return trace_orbit(walls, all_mirrors(walls), start, bounces);
}

}  // namespace flatray
