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
/// Cost    some 550 bytes a shape; making one ready is linear in its vertices.
class PolygonSet {
 public:
  /// The number of the shape.
  std::uint32_t add(std::span<const Vec2> ring);
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const Vec2> ring(std::uint32_t shape) const {
    return std::span(vertices_).subspan(begin_[shape], begin_[shape + 1] - begin_[shape]);
  }

  /// What tells at first sight that a shape is far away.
  struct Box {
    Vec2 centre;
    Vec2 half;  ///< not below the distance of any vertex from it along each axis; NaN of no `Ready`
  };
  std::span<const Box> boxes() const { return boxes_; }

  /// A shape as the lanes need it.
  struct Ready {
    sweep::Shape lanes;
    int count;  ///< of corners
    /// Counter-clockwise without repeated vertices, the last also before and the first also after
    /// them; their numbers in the ring, and the ring's edge from each to the next.
    std::array<Vec2, sweep::kCorners + 2> around;
    std::array<std::int32_t, sweep::kCorners> numbers, edges;

    const Vec2& corner(int k) const { return around[static_cast<std::size_t>(k) + 1]; }
  };
  const Ready& ready(std::uint32_t shape) const { return ready_[shape]; }

 private:
  std::vector<Vec2> vertices_;
  std::vector<std::size_t> begin_{0};
  std::vector<Box> boxes_;
  std::vector<Ready> ready_;
};

}  // namespace flatray
