#pragma once
#include "geom/exact_hit.h"
#include "geom/quick_hit.h"
#include "trace/hits.h"
#include "trace/surfaces.h"

namespace flatray {

/// The exact point of a hit. Needs   a hit that is neither along a segment nor a tangent,
/// nor of what joins an arc to its end.
ExactHit exact_hit(const Surfaces& walls, const Ray& ray, const NearestHit& hit);

/// Nearest double to each coordinate of the point hit; any hit. The end itself where a ray meets
/// the end of a wall, and the first end ahead where it comes along it.
Vec2 hit_point(const Surfaces& walls, const Ray& ray, const NearestHit& hit);

}  // namespace flatray
