#pragma once
#include <algorithm>

#include "render/coverage/chains.h"
#include "render/draw_list.h"

namespace flatray {

/// A posed shape in film coordinates, its pieces united.
struct FilmShape {
  std::vector<Segment> edges;  ///< outline of the convex pieces, winding +1 inside
  bool simple = false;         ///< which are one, still convex
  std::vector<std::vector<Vec2>> crossing_rings;
  std::vector<Circle> circles;
  double cos = 1, sin = 0;  ///< of its turn in the world, with which dashes of circles begin
  std::vector<Segment> segments;
  std::vector<ArcPath> arc_paths;
  std::vector<Chain> curves;  ///< Bezier curves that follow one another
};
FilmShape film_shape(const Shape& shape, const Pose& world_from_shape,
                     const FilmTransform& film_from_world);

/// Whether all of a shape and what reaches `reach` pixels from it lies beside the film.
/// Cost    a look at its corners, not at its outline.
bool beside_film(const Shape& shape, const Pose& world_from_shape,
                 const FilmTransform& film_from_world, const Film& film, double reach);

/// What a fill covers.
std::vector<Region> fill_regions(const FilmShape& shape);

/// How lines are drawn: their look, and their dashes, film pixels; none where empty.
struct LineLook {
  LineStyle style;
  std::vector<double> dashes;
  double dash_offset = 0;
};

/// Corners a frame may still draw.
struct CornerBudget {
  std::uint64_t left = 0;
  bool spent = false;  ///< more were asked for

  bool take(std::uint64_t count) {
    spent = spent || count > left;
    left -= std::min(left, count);
    return !spent;
  }
};

/// What lines along a shape cover: whole circles are rings, all else is one path. Takes the corners
/// it makes from `budget`, and ends where that is spent.
std::vector<Region> line_regions(const FilmShape& shape, const LineLook& look,
                                 CornerBudget& budget);

}  // namespace flatray
