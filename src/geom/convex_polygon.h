#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/cyrus_beck.h"
#include "geom/predicates.h"

namespace flatray {

/// A convex polygon made ready for many rays.
///
/// Needs   vertices as clip_convex does, which outlive it.
/// Cost    O(n) to make, four bytes an edge.
/// Source  V. Skala, "O(lg N) line clipping algorithm in E2" (1994), for the idea: the vertices
///         farthest to either side of the line part the polygon into two chains, each of which
///         crosses it once. They are found here by the order of the edges' directions.
class ConvexPolygon {
 public:
  explicit ConvexPolygon(std::span<const Vec2> vertices);

  /// What clip_convex gives, bit for bit.
  /// Cost    O(log n) exact predicates; O(n) for a zero direction, without area, and for few edges.
  HitInterval clip(const Ray& ray, Range within = kRay) const;

 private:
  struct Extremes {
    std::size_t left = 0, right = 0;  // vertices, none farther to that side
  };
  Sign way(const Vec2& direction, std::size_t edge) const;
  void add_changes(const Vec2& direction, std::size_t begin, std::size_t end,
                   std::vector<std::size_t>& changes) const;
  Extremes extremes(const Vec2& direction) const;

  std::span<const Vec2> vertices_;
  std::vector<std::uint32_t> edges_;  // of positive length, in order; empty: not worth a search
  std::size_t turned_ = 0;            // the first of them half a turn or more from the first
};

}  // namespace flatray
