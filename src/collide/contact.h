#pragma once
#include <cstdint>
#include <span>
#include <utility>

#include "geom/hit_interval.h"
#include "geom/ray.h"

namespace flatray {

using IndexPair = std::pair<std::uint32_t, std::uint32_t>;  ///< numbers of two, the lower first

/// All points within `radius` of a convex polygon, segment or point that moves: vertex + t *
/// velocity. A disc is a point with a radius, a capsule a segment with one.
struct MovingBody {
  std::span<const Vec2> vertices;  ///< of the core, as clip_convex needs them
  Vec2 velocity;
  double radius = 0;  ///< not negative
};

/// What of two bodies meets, as their cores: an edge of one and a vertex of the other, or a vertex of
/// each, one of them with a radius.
struct ContactFeature {
  bool edge_of_a = true;
  int edge = kNoEdge;    ///< as the core is given; kNoEdge where none of them matters
  int vertex = kNoEdge;  ///< of the other
  int corner = kNoEdge;  ///< the vertex of a that stands for an edge

  explicit operator bool() const { return edge != kNoEdge || corner != kNoEdge; }
  bool operator==(const ContactFeature&) const = default;
};

/// When two closed bodies have a point in common.
struct Contact {
  /// Units   t as velocities count it.
  /// Gives   touch for one instant, and where they touch without relative motion; along where they
  ///         touch for a while without a common inner point; through where they overlap. `start`
  ///         tells whether they are apart (outside), touch (boundary) or overlap (inside) at t = 0.
  ///         Edges are kNoEdge.
  HitInterval times;
  ContactFeature first, last;  ///< at t_enter and t_exit, where those lie within the range

  bool operator==(const Contact&) const = default;
};

/// "apart", "touching" or "overlapping".
const char* contact_name(StartPlace start);

/// First and last instant within a range at which two bodies meet, in linear motion.
///
/// Needs   finite coordinates, velocities and radii.
/// Gives   the interior of the pair is that of A - B, also for shapes without area. Without relative
///         motion the verdict is that of the start, for the whole range.
/// Error   verdict, class and start exact for the doubles given; t is the nearest double.
/// Cost    linear in the vertices: two predicates each and a division for each end, about 1 us; some
///         us where one has a radius.
/// Source  one clip of the relative velocity against the Minkowski difference of the cores, grown by both radii.
Contact contact(const MovingBody& a, const MovingBody& b, Range within = kRay);

/// Where two bodies touch, and the unit normal there, out of the first; about.
struct ContactPlace {
  Vec2 point, normal;
};

/// Where bodies meet that come to touch at t, by what of them does.
ContactPlace contact_place(const ContactFeature& feature, const MovingBody& a, const MovingBody& b,
                           double t);

/// Where bodies touch or overlap at a time, whatever way they came: the normal of the shortest way
/// apart, about; 0 for two points that coincide.
ContactPlace resting_place(const MovingBody& a, const MovingBody& b, double t);

/// That of a contact at t_enter, by the one or the other.
ContactPlace first_place(const Contact& met, const MovingBody& a, const MovingBody& b);

}  // namespace flatray
