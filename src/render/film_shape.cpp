#include "render/film_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "geom/polygon.h"
#include "scene/outlines/outline.h"

namespace flatray {
namespace {

// A convex ring may not be one after its corners were rounded to the film.
bool still_convex(const std::vector<Segment>& ring) {
  std::vector<Vec2> corners;
  corners.reserve(ring.size());
  for (const Segment& edge : ring) corners.push_back(edge.a);
  return !non_convex_vertex(corners);
}

// Where a shape is on the film.
struct OnFilm {
  const Pose& world_from_shape;
  const FilmTransform& film_from_world;
};
Vec2 posed(const Vec2& point, const OnFilm& place) {
  return place.film_from_world(place.world_from_shape(point));
}
Circle posed(const Circle& circle, const OnFilm& place) {
  const Circle in_world = posed(circle, place.world_from_shape);
  return {place.film_from_world(in_world.centre), place.film_from_world.length(in_world.radius)};
}
ArcPath posed(const ArcPath& path, const OnFilm& place) {
  ArcPath there = posed(path, place.world_from_shape);
  for (EllipseArc& arc : there.arcs) {
    arc.centre = place.film_from_world(arc.centre);
    arc.u = place.film_from_world.direction(arc.u);
    arc.v = place.film_from_world.direction(arc.v);
  }
  return there;
}

// A whole turn is a ring of its own: no line leads from the rim of a whole sector to its hole.
void add_chains(const ArcPath& path, std::vector<Chain>& chains) {
  const auto is_turn = [](const EllipseArc& arc) {
    return std::abs(arc.sweep) == 2 * std::numbers::pi;
  };
  if (!path.closed || !std::all_of(path.arcs.begin(), path.arcs.end(), is_turn))
    return chains.push_back(chain_of(path));
  for (const EllipseArc& arc : path.arcs)
    if (arc.u != Vec2(0, 0)) chains.push_back(chain_of({{arc}, true}));
}

std::vector<Chain> chains_of(const FilmShape& shape) {
  std::vector<Chain> chains = rings_of(shape.edges);
  for (const std::vector<Vec2>& ring : shape.crossing_rings) chains.push_back({ring, true});
  for (Chain& line : chained(shape.segments)) chains.push_back(std::move(line));
  for (const ArcPath& path : shape.arc_paths) add_chains(path, chains);
  chains.insert(chains.end(), shape.curves.begin(), shape.curves.end());
  return chains;
}

}  // namespace

// The film's y points down, so what runs counter-clockwise in the world is walked backwards: its
// winding stays +1.
FilmShape film_shape(const Shape& shape, const Pose& world_from_shape,
                     const FilmTransform& film_from_world) {
  const OnFilm place{world_from_shape, film_from_world};
  const auto film = [&](const Vec2& point) { return posed(point, place); };
  FilmShape there;
  there.cos = world_from_shape.cos, there.sin = world_from_shape.sin;
  const std::vector<OutlineEdge> edges = outline(shape);
  for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge)
    there.edges.push_back({film(shape.vertices[edge->to]), film(shape.vertices[edge->from])});
  there.simple = shape.piece_count() == 1 && still_convex(there.edges);
  for (const std::vector<Vec2>& ring : shape.crossing_rings) {
    std::vector<Vec2>& points = there.crossing_rings.emplace_back();
    for (const Vec2& point : ring) points.push_back(film(point));
  }
  for (const Circle& circle : shape.circles) there.circles.push_back(posed(circle, place));
  for (const Segment& segment : shape.segments)
    there.segments.push_back({film(segment.a), film(segment.b)});
  for (const ArcPath& path : shape.arc_paths) there.arc_paths.push_back(posed(path, place));
  std::vector<Bezier> curves;
  for (const Bezier& curve : shape.beziers) curves.push_back(mapped(curve, film));
  there.curves = chains_of(curves);
  return there;
}

std::vector<Region> fill_regions(const FilmShape& shape) {
  std::vector<Region> regions;
  if (!shape.edges.empty())
    regions.push_back(FillPath{shape.edges, FillRule::nonzero, shape.simple});
  FillPath crossing{{}, FillRule::even_odd, false};
  for (const std::vector<Vec2>& ring : shape.crossing_rings)
    for (const Segment& edge : ring_edges(ring)) crossing.edges.push_back(edge);
  if (!crossing.edges.empty()) regions.push_back(std::move(crossing));
  for (const Circle& circle : shape.circles)
    regions.push_back(FillRing{circle.centre, circle.radius});
  for (const ArcPath& path : shape.arc_paths)
    if (path.closed) regions.push_back(FillArcs{path});
  return regions;
}

namespace {

void add_counted(const Chain& chain, const LineStyle& style, std::vector<Segment>& edges,
                 CornerBudget& budget) {
  const std::size_t begin = edges.size();
  const bool whole = add_line(chain, style, edges, budget.left);
  budget.take(whole ? edges.size() - begin : budget.left + 1);
}

// A line whose dashes are too fine to see, or would have too many corners, is drawn whole.
void add_dashes(const Chain& chain, const LineLook& look, std::vector<Segment>& edges,
                CornerBudget& budget) {
  constexpr double kFinest_px = 0.25;
  constexpr std::size_t kMostEdges = 2'000'000;
  if (std::accumulate(look.dashes.begin(), look.dashes.end(), 0.0) < kFinest_px)
    return add_counted(chain, look.style, edges, budget);
  const std::size_t begin = edges.size();
  for (const Chain& dash : dashed(chain, look.dashes, look.dash_offset)) {
    add_counted(dash, look.style, edges, budget);
    if (budget.spent) return;
    if (edges.size() - begin <= kMostEdges) continue;
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(begin), edges.end());
    return add_counted(chain, look.style, edges, budget);
  }
}

}  // namespace

bool beside_film(const Shape& shape, const Pose& world_from_shape,
                 const FilmTransform& film_from_world, const Film& film, double reach) {
  return !shape_bounds(shape, OnFilm{world_from_shape, film_from_world})
              .meets({Vec2(-reach, -reach), Vec2(film.width + reach, film.height + reach)});
}

std::vector<Region> line_regions(const FilmShape& shape, const LineLook& look,
                                 CornerBudget& budget) {
  std::vector<Region> regions;
  const double half = look.style.half_width;
  if (!(half > 0)) return regions;
  std::vector<Chain> chains = chains_of(shape);
  FillPath path;
  for (const Circle& circle : shape.circles)
    if (look.dashes.empty())
      regions.push_back(FillRing{circle.centre, circle.radius + half, circle.radius - half});
    else {
      const double along = circle.radius * shape.cos, up = 0.0 - circle.radius * shape.sin;
      chains.push_back(chain_of({{{circle.centre, {along, up}, {up, 0.0 - along}}}, true}));
    }
  for (const Chain& chain : chains) {
    if (look.dashes.empty())
      add_counted(chain, look.style, path.edges, budget);
    else
      add_dashes(chain, look, path.edges, budget);
    if (budget.spent) return {};
  }
  if (!path.edges.empty()) regions.push_back(std::move(path));
  return regions;
}

}  // namespace flatray
