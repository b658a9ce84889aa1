#pragma once
#include <cstdint>
#include <optional>

#include "geom/ray.h"
#include "trace/surfaces.h"

namespace flatray {

/// Reflections of a ray between two straight walls that start from one point, by unfolding:
/// ceil((pi + theta) / alpha) - 1 for walls alpha apart and a ray that comes from far away at the
/// polar angle theta, seen from the wall it meets last.
///
/// Gives   nullopt for walls that are not a wedge, or may be too short for a reflection, and for a
///         ray that does not start in it.
/// Error   a count may be 1 off where (pi + theta) / alpha is within a few ulps of a whole number.
std::optional<std::uint64_t> wedge_reflections(const Surfaces& walls, const Ray& ray);

}  // namespace flatray
