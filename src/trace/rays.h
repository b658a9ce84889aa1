#pragma once
#include <cstdint>
#include <vector>

#include "geom/ray.h"
#include "trace/surfaces.h"

namespace flatray {

/// The wall that a ray has just left, and so does not meet again: a segment as a whole, a curve in
/// the root in which the ray stands on it. No distance is involved.
struct DepartedSurface {
  std::uint32_t surface = kNoSurface;
  Root root = Root::none;  ///< of a curve; `both` leaves out a whole arc
};

/// Rays in flat arrays, one entry each.
struct RayBatch {
  std::vector<double> ox, oy, dx, dy;
  std::vector<DepartedSurface> departed;
  bool tangents = true;  ///< whether a curve touched in one point is hit; orbits pass it by

  std::size_t size() const { return ox.size(); }
  Ray ray(std::size_t i) const { return {{ox[i], oy[i]}, {dx[i], dy[i]}}; }
  void add(const Ray& ray, const DepartedSurface& from = {}) {
    resize(size() + 1);
    set(size() - 1, ray, from);
  }
  /// Puts another ray in the place of ray i.
  void set(std::size_t i, const Ray& ray, const DepartedSurface& from) {
    ox[i] = ray.origin.x(), oy[i] = ray.origin.y();
    dx[i] = ray.direction.x(), dy[i] = ray.direction.y();
    departed[i] = from;
  }
  /// Shortens the batch to its first `count` rays, or adds others for set().
  void resize(std::size_t count) {
    for (std::vector<double>* column : {&ox, &oy, &dx, &dy}) column->resize(count);
    departed.resize(count);
  }
};

}  // namespace flatray
