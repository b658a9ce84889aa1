#pragma once
#include <optional>

#include "geom/hit_interval.h"
#include "geom/hit_time.h"

namespace flatray {

/// What the whole line of a ray has in common with a closed convex shape, before it is clipped to a
/// range. An end that is absent is unbounded; a touch has its point in both.
struct LineHit {
  std::optional<HitTime> enter, exit;
  int edge_enter = kNoEdge, edge_exit = kNoEdge;
  HitClass kind = HitClass::miss;
};

/// The part of `line` within a range, its class there, and where t = 0 lies. Exact but for the
/// rounding of t. Needs   enter <= exit.
HitInterval clip_to_range(const LineHit& line, Range within);

/// The answer for a ray without direction, whose origin lies at `place`: the whole range or a miss.
HitInterval point_test(StartPlace place, Range within);

inline bool is_zero(const Vec2& v) { return v.x() == 0 && v.y() == 0; }

}  // namespace flatray
