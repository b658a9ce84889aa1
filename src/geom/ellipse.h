#pragma once
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "geom/bounds.h"

namespace flatray {

/// Part of an ellipse: centre + cos t * u + sin t * v for t from `from` over `sweep`, which may
/// run backwards.
///
/// Units   radians. u and v are any two conjugate half-diameters: every affine map takes such an
///         arc to such an arc, half-diameters to half-diameters and t to itself.
/// Needs   |sweep| <= 2 pi. u = v = 0 is a point; parallel u and v are a line there and back.
struct EllipseArc {
  Vec2 centre, u, v;
  double from = 0, sweep = 2 * std::numbers::pi;

  /// Half-diameters exactly at quarter turns.
  Vec2 at(double t) const;
  Vec2 start() const { return at(from); }
  Vec2 end() const { return at(from + sweep); }
  bool is_whole() const { return std::fabs(sweep) >= 2 * std::numbers::pi; }
  bool is_circular() const { return v == Vec2(-u.y(), u.x()) || v == Vec2(u.y(), -u.x()); }
  bool operator==(const EllipseArc&) const = default;
};

/// Arcs in turn, joined by straight lines; a closed path's last to its first. A corner is an arc
/// that is a point.
struct ArcPath {
  std::vector<EllipseArc> arcs;
  bool closed = true;
  /// Of a capsule's ends, as it is given: their half-diameters are turned, and rounded. 0 of others.
  double radius = 0;

  /// Whether it is the boundary of an ellipse.
  bool is_ellipse() const { return closed && arcs.size() == 1 && arcs.front().is_whole(); }
  bool operator==(const ArcPath&) const = default;
};

inline EllipseArc corner_at(const Vec2& point) { return {point, {0, 0}, {0, 0}, 0, 0}; }

/// A part of an arc on which x and y each only rise or only fall. Neighbours share their ends.
struct MonotoneArc {
  Vec2 a, b;
};
/// The parts of an arc in its order, at most six.
std::vector<MonotoneArc> monotone_parts(const EllipseArc& arc);

/// Box around a path.
Bounds path_bounds(const ArcPath& path);

/// Chords that stay within `sagitta` of an arc, as many as `flattened` takes; none of a point.
double chord_count(const EllipseArc& arc, double sagitta);

/// Points along a path, both ends among them; a closed path's first point comes again as its last.
///
/// Gives   chords that stay within `sagitta` of the arcs they replace, if a full turn needs no more
///         than 2^17 of them (half-diameters up to 2 * 10^9 times the sagitta); larger arcs keep
///         as many. Where arcs are scaled up, the points stay at the same places of the arc.
std::vector<Vec2> flattened(const ArcPath& path, double sagitta);

/// An edge of a path: an arc, or the straight line from one point to another.
struct PathWall {
  Vec2 from, to;
  std::optional<EllipseArc> arc;
};
/// Those of a path in turn, by which its edges are numbered: arcs, and the lines that join them. A corner
/// is none.
std::vector<PathWall> walls_of(const ArcPath& path);

}  // namespace flatray
