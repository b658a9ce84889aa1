#pragma once
#include "geom/clip.h"
#include "oracle/contact.h"

namespace flatray::oracle {

/// Side of `c` seen from a to b, by rational slopes: above or below the line's height at c.x.
/// Exact.
Sign side_of_line(const Vec2& a, const Vec2& b, const Vec2& c);

/// A clip with its ends as exact numbers; nullopt where the range has no end there, or it is a
/// miss.
struct Clip : ContactTruth {
  int edge_enter = kNoEdge, edge_exit = kNoEdge;
};

/// What clip_convex must answer, by other means: a ray is a point that moves, contact_truth(), and its edges are
/// those that have the point in rationals. Needs a convex polygon, as clip_convex does.
Clip clip_polygon(const Ray& ray, std::span<const Vec2> vertices, Range within);

}  // namespace flatray::oracle
