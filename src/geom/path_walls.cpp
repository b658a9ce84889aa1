#include "geom/path_walls.h"

namespace flatray {

std::vector<PathWall> walls_of(const ArcPath& path) {
  const auto is_point = [](const EllipseArc& arc) { return arc.u == arc.v && arc.u == Vec2(0, 0); };
  std::vector<PathWall> walls;
  const auto join = [&](const Vec2& from, const Vec2& to) {
    if (from != to) walls.push_back({from, to, std::nullopt});
  };
  for (std::size_t i = 0; i < path.arcs.size(); ++i) {
    const EllipseArc& arc = path.arcs[i];
    if (!is_point(arc)) walls.push_back({arc.start(), arc.end(), arc});
    if (i + 1 < path.arcs.size())
      join(arc.end(), path.arcs[i + 1].start());
    else if (path.closed && !path.is_ellipse())
      join(arc.end(), path.arcs[0].start());
  }
  return walls;
}

}  // namespace flatray
