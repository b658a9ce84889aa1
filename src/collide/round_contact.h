#pragma once
#include <optional>

#include "collide/contact.h"
#include "collide/minkowski.h"

namespace flatray {

/// All points within `radius` of a convex polygon, segment or point that moves: a disc is a point,
/// a capsule a segment so grown.
struct RoundBody {
  MovingPolygon core;
  double radius = 0;  ///< not negative
};

/// What of two bodies meets, as their cores: a vertex of each, or the edge that begins there.
struct RoundFeature {
  DifferenceCorner corner;
  bool on_edge;
};

/// When two closed bodies have a point in common, and what meets at t_enter and t_exit, where those
/// lie within the range.
struct RoundContact {
  HitInterval times;  ///< as in Contact
  std::optional<RoundFeature> first, last;
};

/// What contact() has told of two bodies without radius.
RoundContact round_contact(const Contact& met, const RoundBody& a, const RoundBody& b);

/// First and last instant within a range at which two bodies meet, in linear motion.
///
/// Needs   as contact() does; radii finite.
/// Error   verdict, class and start exact for the doubles given; t within 1 ulp.
/// Cost    linear in the vertices, some us; where neither has a radius that of contact().
/// Source  one clip of the relative velocity against the Minkowski difference of the cores, grown
///         by both radii: the first of its discs and sides that the origin comes into.
RoundContact round_contact(const RoundBody& a, const RoundBody& b, Range within = kRay);

/// Where the bodies first touch, and the unit normal there, out of the first; about.
struct RoundPlace {
  Vec2 point, normal;
};
RoundPlace place_at(const RoundFeature& feature, const RoundBody& a, const RoundBody& b, double t);

/// Where bodies touch or overlap at a time, whatever way they came: the normal of the shortest way
/// apart, about; 0 for two points that coincide.
RoundPlace resting_place(const RoundBody& a, const RoundBody& b, double t);

}  // namespace flatray
