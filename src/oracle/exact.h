#pragma once
#include <optional>
#include <span>

#include "geom/cyrus_beck.h"
#include "geom/exact.h"

namespace flatray::oracle {

/// Side of `c` seen from a to b, by rational slopes: above or below the line's height at c.x.
/// Exact.
Sign side_of_line(const Vec2& a, const Vec2& b, const Vec2& c);

/// A clip with its ends as exact numbers; nullopt where the range has no end there, or it is a
/// miss.
struct Clip {
  HitClass kind = HitClass::miss;
  StartPlace start = StartPlace::outside;
  std::optional<Rational> t_enter, t_exit;
  int edge_enter = kNoEdge, edge_exit = kNoEdge;
};

/// What clip_convex must answer, by other means: every edge as a parametric segment is met with the
/// ray in rationals, and the middle of what lies between the first and the last meeting is put to a
/// point-in-polygon test that counts crossings. Needs a convex polygon, as clip_convex does.
Clip clip_polygon(const Ray& ray, std::span<const Vec2> vertices, Range within);

/// Where a root of |o + t d - c| = r lies against `t`: by the distance at t and the side of the
/// foot of the perpendicular. `root` is -1 for the first and 1 for the second.
///
/// Needs   a line that meets the circle, a direction that is not zero.
std::strong_ordering root_against(const Ray& ray, const Circle& circle, int root,
                                  const Rational& t);

/// miss, touch or through for a whole line and a disc, by the distance of the foot of the
/// perpendicular.
HitClass verdict_on_disc(const Ray& ray, const Circle& circle);

/// Where a point lies in a closed disc.
StartPlace place_in_disc(const Vec2& point, const Circle& circle);

}  // namespace flatray::oracle
