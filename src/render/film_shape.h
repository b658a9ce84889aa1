#pragma once
#include "render/chains.h"
#include "render/draw_list.h"

namespace flatray {

/// A posed shape in film coordinates, its pieces united.
struct FilmShape {
  std::vector<Segment> edges;  ///< outline of the convex pieces, winding +1 inside
  bool simple = false;         ///< which are one, still convex
  std::vector<std::vector<Vec2>> crossing_rings;
  std::vector<Circle> circles;
  std::vector<Segment> segments;
  std::vector<ArcPath> arc_paths;
};
FilmShape film_shape(const Shape& shape, const Pose& world_from_shape,
                     const FilmTransform& film_from_world);

/// What a fill covers.
std::vector<Region> fill_regions(const FilmShape& shape);

/// How lines are drawn: their look, and their dashes, film pixels; none where empty.
struct LineLook {
  LineStyle style;
  std::vector<double> dashes;
  double dash_offset = 0;
};

/// What lines along a shape cover: whole circles are rings, all else is one path.
std::vector<Region> line_regions(const FilmShape& shape, const LineLook& look);

}  // namespace flatray
