#pragma once
#include <span>
#include <vector>

#include "geom/hit_interval.h"
#include "geom/primitives/arc.h"

namespace flatray {

/// Part of `ray` inside a closed convex polygon: the answer of Cyrus-Beck clipping. The edges are
/// found by the sides of the vertices (geom/sides.h), not by comparing t as the paper does; the
/// paper's loop, edge by edge, is clip_steps() below and, in plain numbers, trace/plain_polygons.h.
///
/// Units   t counts lengths of `ray.direction`: t = 1 is its tip.
/// Needs   `vertices` convex, finite, in either orientation; repeated and collinear vertices are
///         passed over. A polygon without area is the segment or point it is.
/// Gives   the closed interval clipped to `within`, the edges it enters and leaves by, its class,
///         and where the origin lies. A corner touched gives t_enter == t_exit; along an edge is
///         inside. Edges that tie at a vertex: the lower number of the list as given.
/// Error   verdict, edges and class exact for the doubles given; t_enter and t_exit are the nearest
///         doubles.
/// Cost    one predicate a vertex, by exact rationals only where error bounds cannot decide; one
///         division for each end of the interval.
/// Source  the paper's table 1 and eq. 3, as corrected in docs/DEVIATIONS.md; docs/NUMERICS.md
///         proves it.
///
/// The polygon may move with `velocity`, its t being those of the ray: so may what follows.
HitInterval clip_convex(const Ray& ray, std::span<const Vec2> vertices, Range within = kRay,
                        const Vec2& velocity = {0, 0});

/// Part of `ray` inside a closed ellipse. Error as above; edges are kNoEdge.
HitInterval clip_ellipse(const Ray& ray, const Ellipse& ellipse, Range within = kRay,
                         const Vec2& velocity = {0, 0});
/// The same inside a closed disc. Radius 0 is a point.
inline HitInterval clip_circle(const Ray& ray, const Circle& circle, Range within = kRay) {
  return clip_ellipse(ray, circle, within);
}

/// Part of `ray` on a closed segment: touch where they cross, along where they overlap.
HitInterval clip_segment(const Ray& ray, const Segment& segment, Range within = kRay,
                         const Vec2& velocity = {0, 0});

/// Part of an edge inside a closed convex polygon, an ellipse, or on a segment, t from 0 at its first point
/// to 1 at its second. It is clipped as it is, whose direction may be no double: a ray to the second point
/// against a shape that moves there from the origin. Error as above.
inline HitInterval clip_edge(const Segment& edge, std::span<const Vec2> vertices,
                             Range within = kSegment) {
  return clip_convex({edge.a, edge.b}, vertices, within, edge.a);
}
inline HitInterval clip_edge(const Segment& edge, const Ellipse& ellipse, Range within = kSegment) {
  return clip_ellipse({edge.a, edge.b}, ellipse, within, edge.a);
}
inline HitInterval clip_edge(const Segment& edge, const Segment& segment, Range within = kSegment) {
  return clip_segment({edge.a, edge.b}, segment, within, edge.a);
}

/// One edge of a clip as the paper's table 3 shows it, for people: see `flatray hit`.
struct ClipStep {
  int edge;
  double numerator, denominator;  ///< n.(P_i - A) and n.c of the outward normal n, rounded once
  int kind;                       ///< -1 entering, 0 parallel, 1 exiting
  double t;                       ///< numerator / denominator rounded once; 0 where parallel
  HitInterval candidate;          ///< the interval after this edge, clipped to the range
};

/// The same clip edge by edge. Stops after the edge that makes it a miss.
std::vector<ClipStep> clip_steps(const Ray& ray, std::span<const Vec2> vertices,
                                 Range within = kRay, const Vec2& velocity = {0, 0});

}  // namespace flatray
