#pragma once
#include <variant>

#include "anim/frame_state.h"
#include "geom/clip.h"
#include "geom/curved_path.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace flatray {

/// What has an inside in one frame, in the world: the convex pieces, circles and closed paths of
/// entities and pillars, with the walls round each, those between pieces of one shape too.
class ClosedParts {
 public:
  ClosedParts(const Scene& scene, const FrameState& state);

  /// Walls round all of them, for a tracer: a ray lies in a part nowhere, or only in points, unless
  /// it meets a wall of it.
  const Surfaces& walls() const { return walls_; }
  /// The part that a wall stands round.
  std::uint32_t part_of(std::uint32_t wall) const { return part_of_[wall]; }

  /// Adds where each ray lies in a part. Needs   as many lists as rays.
  void clip(std::uint32_t part, const RayBatch& rays, std::span<std::vector<Range>> inside) const;

 private:
  using Part = std::variant<std::vector<Vec2>, Circle, CurvedPath>;
  void add_shape(const Shape& shape, const Pose& place);
  void add_piece(std::vector<Vec2> corners);
  void add_path(CurvedPath path);
  void add_segment(const Vec2& a, const Vec2& b);
  template <class Wall>
  void add_wall(const Wall& wall) {
    walls_.add(wall);
    part_of_.push_back(static_cast<std::uint32_t>(parts_.size()));
  }

  std::vector<Part> parts_;
  Surfaces walls_;
  std::vector<std::uint32_t> part_of_;
};

}  // namespace flatray
