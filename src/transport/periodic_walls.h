#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/bounds.h"
#include "scene/scene.h"
#include "trace/surfaces.h"

namespace flatray {

/// A ray between periodic walls that crosses as many of them and meets nothing else never will, as
/// far as anyone can wait.
inline constexpr std::uint32_t kMostCrossings = 1U << 18;

/// The walls of an upright box of which opposite ones are the same: a torus.
class PeriodicWalls {
 public:
  struct Side {
    std::uint32_t surface, opposite;
    int axis;               // across it
    double out, near, far;  // sign of the way out; places of it and of the opposite one on the axis
  };

  /// Needs   the periodic ones of `walls` to be the sides of one upright box, or none. No materials
  ///         mean none.
  PeriodicWalls(const Surfaces& walls, std::span<const Material> materials);

  bool any() const { return !sides_.empty(); }
  /// nullptr of any other wall.
  const Side* find(std::uint32_t surface) const;
  bool has(std::uint32_t surface) const { return find(surface) != nullptr; }
  /// Whether a direction leads out of the box by a wall; not along it.
  bool leads_out(std::uint32_t surface, const Vec2& direction) const;

  /// Where a ray that arrives at a point of some of them goes on.
  struct Entry {
    Vec2 point;
    std::uint32_t surface;  ///< the wall it comes in by, the last one where it was in a corner
  };
  /// Gives   nothing where none of them leads out.
  std::optional<Entry> cross(const Vec2& point, const Vec2& direction,
                             std::span<const std::uint32_t> surfaces) const;

 private:
  std::vector<Side> sides_;
};

}  // namespace flatray
