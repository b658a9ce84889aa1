#pragma once
#include <optional>

#include "geom/ellipse.h"

namespace flatray {

/// An edge of a path: an arc, or the straight line from one point to another.
struct PathWall {
  Vec2 from, to;
  std::optional<EllipseArc> arc;
};
/// Those of a path in turn, by which its edges are numbered: arcs, and the lines that join them. A corner
/// is none.
std::vector<PathWall> walls_of(const ArcPath& path);

}  // namespace flatray
