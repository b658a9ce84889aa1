#pragma once
#include <vector>

#include "geom/exact_hit.h"
#include "geom/hit_interval.h"
#include "geom/primitives/arc.h"

// What a wall is asked, of each kind of primitive: all that trace, transport, precise and collide
// need of one. Sides are positive to the left of a segment or Bezier curve and outside an arc.
namespace flatray {

/// Box of all that belongs to it, rounded outward; of an arc that of its whole curve too.
Bounds bounds_of(const Segment& wall);
Bounds bounds_of(const Arc& wall);
Bounds bounds_of(const Bezier& wall);

/// The side on which a body that it borders lies.
constexpr Sign inside_of(const Segment&) { return Sign::positive; }
constexpr Sign inside_of(const Arc& wall) {
  return wall.is_hollow ? Sign::positive : Sign::negative;
}
inline Sign inside_of(const Bezier&) { return Sign::positive; }

/// Side of its whole line or curve on which a point lies. Exact.
inline Sign side_of(const Segment& wall, const Vec2& point) {
  return orientation(wall.a, wall.b, point);
}
inline Sign side_of(const Arc& wall, const Vec2& point) { return curve_side(point, wall.curve); }
/// Needs   a point near the curve, far less than its bends are wide.
Sign side_of(const Bezier& wall, const Vec2& point);

/// Whether a point lies on the wall, and where. Exact.
PlaceOn place_on(const Segment& wall, const Vec2& point);
PlaceOn place_on(const Arc& wall, const Vec2& point);
PlaceOn place_on(const Bezier& wall, const Vec2& point);

/// Place of a point in the cone in which the wall lies. A segment has none: every point is at its
/// end; nor has a Bezier curve.
inline PlaceOn place_in_cone(const Segment&, const Vec2&) { return PlaceOn::at_end; }
inline PlaceOn place_in_cone(const Bezier&, const Vec2&) { return PlaceOn::at_end; }

/// Whether it may come into the box of half sides `reach` about a point. Doubles with bounds.
bool passes_near(const Segment& wall, const Vec2& point, const Vec2& reach);
bool passes_near(const Arc& wall, const Vec2& point, const Vec2& reach);
bool passes_near(const Bezier& wall, const Vec2& point, const Vec2& reach);
/// Whether the line through a segment surely passes outside that box.
bool line_passes_far(const Segment& wall, const Vec2& point, const Vec2& reach);

/// Where a ray meets a wall, by the rules of NearestHit (trace/hits.h).
struct WallMeeting {
  HitTime time;
  HitClass kind;
  Root root;
  bool at_end;  ///< of it, or in a cusp or where it crosses itself
};
/// What counts as meeting it.
struct MeetingRules {
  Root stood_on =
      Root::none;        ///< of its curve, where the ray starts on it; of a Bezier curve any but
                         ///< none leaves out what is met at t = 0
  bool tangents = true;  ///< whether a curve touched in one point is met
  bool every = false;    ///< also later roots than the first
};
/// Adds where a ray meets a wall, some at t < 0. Exact. Needs   a direction that is not zero.
void meet(const Segment& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met);
void meet(const Arc& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met);
void meet(const Bezier& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met);
/// Whether a ray that has left it by a root cannot meet it again.
constexpr bool is_departed_for_good(const Segment&, Root) { return true; }
constexpr bool is_departed_for_good(const Arc&, Root left) { return left == Root::both; }
inline bool is_departed_for_good(const Bezier&, Root) { return false; }
/// Whether the line of a ray crosses its line, or its curve in two points. Exact.
bool is_crossed(const Segment& wall, const Ray& ray);
bool is_crossed(const Arc& wall, const Ray& ray);
bool is_crossed(const Bezier& wall, const Ray& ray);

/// When a ray crosses it, in a root.
inline HitTime time_met(const Segment& wall, const Ray& ray, Root) {
  return HitTime::on_line(ray, wall);
}
inline HitTime time_met(const Arc& wall, const Ray& ray, Root root) {
  return HitTime::on_curve(ray, wall.curve, root);
}
HitTime time_met(const Bezier& wall, const Ray& ray, Root root);

/// The end that a ray meets that is known to meet one; of two at once the first, as of those of a
/// segment along the ray.
Vec2 end_met(const Segment& wall, const Ray& ray, Root root);
Vec2 end_met(const Arc& wall, const Ray& ray, Root root);
Vec2 end_met(const Bezier& wall, const Ray& ray, Root root);
/// Nearest doubles of the point met, between the ends.
inline Vec2 point_met(const Segment& wall, const Ray& ray, Root) {
  return ExactHit(ray, wall).nearest();
}
Vec2 point_met(const Arc& wall, const Ray& ray, Root root);
Vec2 point_met(const Bezier& wall, const Ray& ray, Root root);

/// The side from which a ray comes that crosses it in a root. Exact.
Sign side_met(const Segment& wall, const Ray& ray, Root root);
constexpr Sign side_met(const Arc&, const Ray&, Root root) {
  return enters(root) ? Sign::positive : Sign::negative;
}
inline Sign side_met(const Bezier&, const Ray&, Root root) {
  return enters(root) ? Sign::positive : Sign::negative;
}
/// Whether a ray leads from a point of the wall away on a side: of a segment along it will do too.
/// Exact for segments and arcs; of a Bezier curve by its tangent at the double s nearest to the point.
bool leads_away(const Segment& wall, Sign side, const Ray& ray);
bool leads_away(const Arc& wall, Sign side, const Ray& ray);
bool leads_away(const Bezier& wall, Sign side, const Ray& ray);
/// Whether a direction runs along the wall everywhere. Exact.
bool runs_along(const Segment& wall, const Vec2& direction);
constexpr bool runs_along(const Arc&, const Vec2&) { return false; }
inline bool runs_along(const Bezier&, const Vec2&) { return false; }
/// The root that a ray has left that sets off to a side, and does not meet again.
constexpr Root root_departed(const Segment&, Sign) { return Root::none; }
constexpr Root root_departed(const Arc&, Sign side) {
  return side == Sign::negative ? Root::first : Root::second;
}
inline Root root_departed(const Bezier&, Sign side) {
  return side == Sign::negative ? Root::first : Root::second;
}

/// A normal near a point of the wall, to the positive side, in plain doubles.
inline Vec2 normal_near(const Segment& wall, const Vec2&) {
  return {-(wall.b.y() - wall.a.y()), wall.b.x() - wall.a.x()};
}
Vec2 normal_near(const Arc& wall, const Vec2& point);
Vec2 normal_near(const Bezier& wall, const Vec2& point);

/// Whether one lies on the line or curve of the other. Exact for segments and circles; Bezier curves
/// are told by their control points.
template <class One, class Other>
constexpr bool lies_along(const One&, const Other&) {
  return false;
}
bool lies_along(const Segment& one, const Segment& other);
bool lies_along(const Arc& one, const Arc& other);
bool lies_along(const Bezier& one, const Bezier& other);

/// The circle that it is a part of, or all of, if it is.
inline std::optional<Circle> circle_along(const Arc& wall) {
  return wall.curve.is_circle() ? std::optional(circle_of(wall.curve)) : std::nullopt;
}
template <class Wall>
std::optional<Circle> circle_along(const Wall&) {
  return std::nullopt;
}
/// The circle that it is all of, if it is.
inline std::optional<Circle> whole_circle(const Arc& wall) {
  return wall.extent == Arc::Extent::whole ? circle_along(wall) : std::nullopt;
}
template <class Wall>
std::optional<Circle> whole_circle(const Wall&) {
  return std::nullopt;
}

/// Whether a body that it borders changes between inside and outside, of a curve for all of it, on the
/// half line to the right of a point that is not on it. Exact.
bool crosses_to_right(const Segment& wall, const Vec2& point);
inline bool crosses_to_right(const Arc& wall, const Vec2& point) {
  return side_of(wall, point) == Sign::negative;
}
bool crosses_to_right(const Bezier& wall, const Vec2& point);

}  // namespace flatray
