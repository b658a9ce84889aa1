#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "collide/kernels/sweep.h"
#include "geom/vec.h"

namespace flatray {

/// Convex polygons, segments and points made ready for many contacts.
///
/// Needs   rings as clip_convex does.
/// Cost    some 600 bytes a shape; making one ready is linear in its vertices.
class PolygonSet {
 public:
  /// The number of the shape.
  std::uint32_t add(std::span<const Vec2> ring);
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const Vec2> ring(std::uint32_t shape) const {
    return std::span(vertices_).subspan(begin_[shape], begin_[shape + 1] - begin_[shape]);
  }

  /// A shape as the lanes need it.
  struct Ready {
    sweep::Shape lanes;
    Vec2 centre;
    Vec2 half;      ///< not below the distance of any vertex from the centre along x and along y
    double radius;  ///< not below the distance of any vertex from the centre
    int count = 0;  ///< of corners; 0 where the shape is none for the lanes
    /// Counter-clockwise without repeated vertices, the first again at the end; their numbers in the
    /// ring, and the ring's edge from each to the next.
    std::array<Vec2, sweep::kCorners + 1> corners;
    std::array<std::int32_t, sweep::kCorners + 1> numbers, edges;
  };
  const Ready& ready(std::uint32_t shape) const { return ready_[shape]; }

 private:
  std::vector<Vec2> vertices_;
  std::vector<std::size_t> begin_{0};
  std::vector<Ready> ready_;
};

}  // namespace flatray
