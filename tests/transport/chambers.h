#pragma once
#include <functional>

#include "transport/orbit_tracer.h"

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

/// Follows one ray among mirrors without keeping its bounces; gives how it ended.
inline OrbitStop watch(const Surfaces& walls, const Ray& start, std::uint64_t bounces,
                       const std::function<void(const Bounce&)>& see) {
  struct Watcher : OrbitSink {
    const std::function<void(const Bounce&)>& see;
    OrbitStop stop{};
    explicit Watcher(const std::function<void(const Bounce&)>& see_) : see(see_) {}
    void bounce(std::size_t, const Bounce& bounce) override { see(bounce); }
    void end(std::size_t, const OrbitStop& how) override { stop = how; }
  } watcher(see);
  const std::vector<Material> mirrors = all_mirrors(walls);
  const OrbitStart from{start};
  OrbitTracer(walls, mirrors).follow(std::span(&from, 1), bounces, watcher);
  return watcher.stop;
}

}  // namespace flatray
