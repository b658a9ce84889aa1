#pragma once
#include <optional>
#include <vector>

#include "geom/hit_interval.h"
#include "geom/primitives/arc.h"

namespace flatray {

/// A wall of a path: the straight edge from one point to another, or an arc between them.
struct PathEdge {
  Vec2 from, to;
  std::optional<Arc> arc;         ///< whole, or `between` the two in either order
  bool counter_clockwise = true;  ///< along the arc as the path goes
  int number = 0;
};

/// Walls in turn, each from where the one before it ends; of a closed path the first from where the
/// last ends.
struct CurvedPath {
  std::vector<PathEdge> edges;
  bool closed = true;
};

/// Parts of a ray within what a closed path encloses, its boundary and joints (see Arc) with it; of
/// an open path the points and stretches it has in common with the ray.
///
/// Units   t counts lengths of the ray's direction.
/// Needs   a closed path that does not cross itself, in either direction.
/// Gives   intervals clipped to `within`, ascending and apart: `through` where a part has inner
///         points, `along` where all of it is boundary, `touch` for one point. Edges by their
///         numbers, the lowest where several meet; `start` is the place of the origin in all of it.
/// Error   verdict, class, edges exact; t is the nearest double.
/// Cost    linear in the edges, some us each that is met; rationals where bounds leave a doubt.
std::vector<HitInterval> clip_path(const Ray& ray, const CurvedPath& path, Range within = kRay);

/// A box that holds the path, its joints with it.
Bounds bounds_of(const CurvedPath& path);

}  // namespace flatray
