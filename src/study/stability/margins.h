#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace flatray {

/// How near a straight part of a way is to meeting other walls than it does.
struct Margin {
  std::string ray;        ///< its name, or its number
  std::uint64_t leg = 0;  ///< after so many bounces
  std::string wall;       ///< whose end or tangent is near
  Vec2 at{0, 0};          ///< that end, or the middle of that curve
  double distance = 0;    ///< world units; 0 is exact: the way meets the end, or is tangent
  double ulps = 0;        ///< of the largest coordinate of the walls
};

/// Of each leg of each ray of a scene's first frame the nearest end of a wall, or tangent of a
/// circle or ellipse; ascending; none of a leg that comes by neither. A scene without rays is asked with
/// `count` random ones from its window, a leg each.
///
/// Gives   distances in doubles; those of 0 are decided exactly. The wall that a leg ends on
///         counts with what lies beyond, too. Bezier curves count with their ends alone.
/// Cost    legs x walls.
std::vector<Margin> margins(const Scene& scene, std::uint64_t seed, std::uint64_t count);

}  // namespace flatray
