#pragma once
#include <span>

#include "geom/hit_interval.h"
#include "geom/ray.h"

namespace flatray {

/// A convex polygon, segment or point that moves: vertex + t * velocity.
struct MovingPolygon {
  std::span<const Vec2> vertices;  ///< as clip_convex needs them
  Vec2 velocity;
};

/// What of two polygons meets: an edge of one, a vertex of the other.
struct ContactFeature {
  bool edge_of_a = true;
  int edge = kNoEdge;    ///< as the polygon is given; kNoEdge where none of them matters
  int vertex = kNoEdge;  ///< of the other

  bool operator==(const ContactFeature&) const = default;
};

/// When two closed polygons have a point in common.
struct Contact {
  /// Units   t as velocities count it.
  /// Gives   touch for one instant, along where they touch for a while without a common inner
  ///         point, through where they overlap; `start` tells whether they are apart (outside), touch
  ///         (boundary) or overlap (inside) at t = 0. Edges are kNoEdge.
  HitInterval times;
  ContactFeature first, last;  ///< at t_enter and t_exit, where those lie within the range

  bool operator==(const Contact&) const = default;
};

/// "apart", "touching" or "overlapping".
const char* contact_name(StartPlace start);

/// First and last instant within a range at which two polygons meet, in linear motion.
///
/// Needs   finite coordinates and velocities.
/// Gives   the interior of the pair is that of A - B, also for shapes without area. Without relative
///         motion the verdict is that of the start, for the whole range.
/// Error   verdict, class and start exact for the doubles given; t within 1 ulp.
/// Cost    linear in the vertices: two predicates each, and a division for each end.
/// Source  one clip of the relative velocity against the Minkowski difference (facts, section 7).
Contact contact(const MovingPolygon& a, const MovingPolygon& b, Range within = kRay);

}  // namespace flatray
