#pragma once
#include <vector>

#include "geom/exact_hit.h"
#include "geom/hit_interval.h"
#include "geom/primitives/arc.h"

// What a wall is asked, of each kind of primitive: all that trace, transport, precise and collide
// need of one. Sides are positive to the left of a segment or Bezier curve and outside an arc.
namespace flatray {

/// Box of all that belongs to the wall, rounded outward; of an arc it holds the whole curve, too.
Bounds bounds_of(const Segment& wall);
Bounds bounds_of(const Arc& wall);
Bounds bounds_of(const Bezier& wall);

/// The side of a wall on which the body lies that the wall borders.
constexpr Sign inside_of(const Segment&) { return Sign::positive; }
constexpr Sign inside_of(const Arc& wall) {
  return wall.is_hollow ? Sign::positive : Sign::negative;
}
inline Sign inside_of(const Bezier&) { return Sign::positive; }

/// Side of the wall's whole line or curve on which a point lies. Exact.
inline Sign side_of(const Segment& wall, const Vec2& point) {
  return orientation(wall.a, wall.b, point);
}
inline Sign side_of(const Arc& wall, const Vec2& point) { return curve_side(point, wall.curve); }
/// Needs   a point whose distance from the curve is far less than the curve's bends are wide.
Sign side_of(const Bezier& wall, const Vec2& point);

/// Whether a point lies on the wall, and where. Exact.
PlaceOn place_on(const Segment& wall, const Vec2& point);
PlaceOn place_on(const Arc& wall, const Vec2& point);
PlaceOn place_on(const Bezier& wall, const Vec2& point);

/// Place of a point in the cone in which an arc lies. Segments and Bezier curves have no cone: of
/// these every point counts as at an end.
inline PlaceOn place_in_cone(const Segment&, const Vec2&) { return PlaceOn::at_end; }
inline PlaceOn place_in_cone(const Bezier&, const Vec2&) { return PlaceOn::at_end; }

/// Whether the wall may come into the box of half sides `reach` about a point. Doubles with bounds.
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
  bool at_end;  ///< of the wall; or in a cusp of a Bezier curve, or where that crosses itself
};
/// What counts as meeting a wall.
struct MeetingRules {
  Root stood_on =
      Root::none;        ///< where the ray starts on the wall's curve: in which root, which is left
                         ///< out; of a Bezier curve any but none leaves out what is met at t = 0
  bool tangents = true;  ///< whether a curve touched in one point is met
  bool every = false;    ///< also later roots than the first
};
/// Adds the points in which a ray meets a wall; some of these may lie at t < 0. Exact.
/// Needs   a direction that is not zero.
void meet(const Segment& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met);
void meet(const Arc& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met);
void meet(const Bezier& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met);
/// Whether a ray that has left a wall in a root cannot meet that wall again.
constexpr bool is_departed_for_good(const Segment&, Root) { return true; }
constexpr bool is_departed_for_good(const Arc& wall, Root left) {
  return left == Root::both && wall.extent != Arc::Extent::between;  // what joins its ends is met
}
inline bool is_departed_for_good(const Bezier&, Root) { return false; }
/// Whether the line of a ray crosses the wall's line, or the wall's curve in two points. Exact.
bool is_crossed(const Segment& wall, const Ray& ray);
bool is_crossed(const Arc& wall, const Ray& ray);
bool is_crossed(const Bezier& wall, const Ray& ray);

/// The time at which a ray crosses a wall in a root.
inline HitTime time_met(const Segment& wall, const Ray& ray, Root) {
  return HitTime::on_line(ray, wall);
}
inline HitTime time_met(const Arc& wall, const Ray& ray, Root root) {
  return HitTime::on_curve(ray, wall.curve, root);
}
HitTime time_met(const Bezier& wall, const Ray& ray, Root root);

/// The end of a wall that a ray meets; where it meets both, as those of a segment along the ray,
/// the first. Of an arc that ends off its curve by more than rounding the nearest doubles of the point met.
///
/// Needs   a ray that is known to meet an end.
Vec2 end_met(const Segment& wall, const Ray& ray, Root root);
Vec2 end_met(const Arc& wall, const Ray& ray, Root root);
Vec2 end_met(const Bezier& wall, const Ray& ray, Root root);
/// That point without rounding; nullopt where it is a double that end_met() gives.
inline std::optional<ExactHit> exact_end(const Segment& wall, const Ray& ray, Root) {
  return is_crossed(wall, ray) ? std::optional(ExactHit(ray, wall)) : std::nullopt;
}
std::optional<ExactHit> exact_end(const Arc& wall, const Ray& ray, Root root);
inline std::optional<ExactHit> exact_end(const Bezier& wall, const Ray& ray, Root root) {
  return root == Root::none || is_zero(ray.direction) ? std::nullopt
                                                      : std::optional(ExactHit(ray, wall, root));
}
/// Nearest doubles of the point in which a ray meets a wall between its ends.
inline Vec2 point_met(const Segment& wall, const Ray& ray, Root) {
  return ExactHit(ray, wall).nearest();
}
Vec2 point_met(const Arc& wall, const Ray& ray, Root root);
Vec2 point_met(const Bezier& wall, const Ray& ray, Root root);

/// The side from which a ray comes that crosses a wall in a root. Exact.
Sign side_met(const Segment& wall, const Ray& ray, Root root);
template <class Curve>
constexpr Sign side_met(const Curve&, const Ray&, Root root) {
  return enters(root) ? Sign::positive : Sign::negative;
}
/// Whether a ray that starts on a wall stays on a side of it at first; along a segment counts, too.
/// Exact for segments and arcs; of a Bezier curve by its tangent at the double s nearest to the point.
bool leads_away(const Segment& wall, Sign side, const Ray& ray);
bool leads_away(const Arc& wall, Sign side, const Ray& ray);
bool leads_away(const Bezier& wall, Sign side, const Ray& ray);
/// Whether a direction runs along the wall everywhere. Exact.
bool runs_along(const Segment& wall, const Vec2& direction);
constexpr bool runs_along(const Arc&, const Vec2&) { return false; }
inline bool runs_along(const Bezier&, const Vec2&) { return false; }
/// The root in which a ray leaves a wall when it sets off to a side, and which it does not meet
/// again.
constexpr Root root_departed(const Segment&, Sign) { return Root::none; }
template <class Curve>
constexpr Root root_departed(const Curve&, Sign side) {
  return side == Sign::negative ? Root::first : Root::second;
}

/// A normal of the wall near a point, towards the positive side, in plain doubles; half as long of a
/// segment that is longer than they reach.
inline Vec2 normal_near(const Segment& wall, const Vec2&) {
  Vec2 way = wall.b - wall.a;
  if (!way.allFinite()) way = 0.5 * wall.b - 0.5 * wall.a;
  return {-way.y(), way.x()};
}
Vec2 normal_near(const Arc& wall, const Vec2& point);
Vec2 normal_near(const Bezier& wall, const Vec2& point);

/// Whether one segment lies on the line of the other. Exact.
bool lies_along(const Segment& one, const Segment& other);
/// Whether two walls have more than points in common. Exact for segments and arcs; Bezier curves are
/// compared by their control points.
template <class One, class Other>
constexpr bool overlap(const One&, const Other&) {
  return false;
}
bool overlap(const Segment& one, const Segment& other);
bool overlap(const Arc& one, const Arc& other);
bool overlap(const Bezier& one, const Bezier& other);

/// The circle of which a wall is a part or the whole; nullopt where there is none.
inline std::optional<Circle> circle_along(const Arc& wall) {
  return wall.curve.is_circle() ? std::optional(circle_of(wall.curve)) : std::nullopt;
}
template <class Wall>
std::optional<Circle> circle_along(const Wall&) {
  return std::nullopt;
}
/// The circle of which a wall is the whole; nullopt where there is none.
inline std::optional<Circle> whole_circle(const Arc& wall) {
  return wall.extent == Arc::Extent::whole ? circle_along(wall) : std::nullopt;
}
template <class Wall>
std::optional<Circle> whole_circle(const Wall&) {
  return std::nullopt;
}

/// Whether the half line to the right of a point crosses a wall an odd number of times, as the
/// border of a body; where it runs through an end, as if it lay higher by less than anything. Exact.
/// Needs   a point that is not on the wall, and of arcs none that is half a curve.
bool crosses_to_right(const Segment& wall, const Vec2& point);
bool crosses_to_right(const Arc& wall, const Vec2& point);
bool crosses_to_right(const Bezier& wall, const Vec2& point);

}  // namespace flatray
