#include "render/pass.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geom/polygon.h"
#include "image/srgb.h"
#include "render/stroke.h"
#include "scene/outline.h"

namespace flatray {

#define FLATRAY_ENTRY(name) extern const Pass name##_pass;
#include "passes.inc"
#undef FLATRAY_ENTRY

std::vector<const Pass*> passes() {
  return {
#define FLATRAY_ENTRY(name) &name##_pass,
#include "passes.inc"
#undef FLATRAY_ENTRY
  };
}

namespace {

LinearColour linear(const Colour& colour) {
  return {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b),
          static_cast<float>(colour.a) / 255.0F};
}

// The outline in film coordinates. The film's y points down, so what runs counter-clockwise in the
// world is walked backwards: its winding stays +1.
std::vector<Segment> film_edges(const Shape& shape, const Pose& world_from_shape,
                                const FilmTransform& film_from_world) {
  const auto film = [&](std::uint32_t vertex) {
    return film_from_world(world_from_shape(shape.vertices[vertex]));
  };
  std::vector<Segment> edges;
  for (const OutlineEdge& edge : outline(shape)) edges.push_back({film(edge.to), film(edge.from)});
  return edges;
}

ArcPath film_path(const ArcPath& path, const Pose& world_from_shape,
                  const FilmTransform& film_from_world) {
  ArcPath there = posed(path, world_from_shape);
  for (EllipseArc& arc : there.arcs) {
    arc.centre = film_from_world(arc.centre);
    arc.u = film_from_world.direction(arc.u);
    arc.v = film_from_world.direction(arc.v);
  }
  return there;
}

// A convex ring may not be one after its corners were rounded to the film.
bool still_convex(const std::vector<Segment>& ring) {
  std::vector<Vec2> corners;
  corners.reserve(ring.size());
  for (const Segment& edge : ring) corners.push_back(edge.a);
  return !non_convex_vertex(corners);
}

}  // namespace

DrawContext::DrawContext(const Scene& scene_, const FrameState& state_)
    : scene(scene_), state(state_), film_from_world(scene_.film, state_) {}

const World& DrawContext::world() {
  if (!world_) world_ = build_world(scene, state);
  return *world_;
}

void DrawContext::place(int layer, std::uint64_t order) {
  layer_ = layer;
  order_ = order;
}

void DrawContext::add(DrawItem&& item) { items_.push_back({layer_, order_, std::move(item)}); }

std::vector<DrawItem> DrawContext::sorted_items() && {
  // Numbers are sorted, not items: g++ 12 takes the swap of a variant for a use before set.
  std::vector<std::size_t> order(items_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return std::tie(items_[a].layer, items_[a].order) < std::tie(items_[b].layer, items_[b].order);
  });
  std::vector<DrawItem> items;
  items.reserve(items_.size());
  for (const std::size_t i : order) items.push_back(std::move(items_[i].item));
  return items;
}

double DrawContext::half_width_px(const Stroke& stroke) const {
  return 0.5 * (stroke.in_pixels ? stroke.width : film_from_world.length(stroke.width));
}

void DrawContext::add_shape(const Shape& shape, const Pose& world_from_shape,
                            const std::optional<Colour>& fill,
                            const std::optional<Stroke>& stroke) {
  std::vector<Segment> edges = film_edges(shape, world_from_shape, film_from_world);
  std::vector<Circle> circles;
  for (const Circle& circle : shape.circles)
    circles.push_back(
        {film_from_world(world_from_shape(circle.centre)), film_from_world.length(circle.radius)});
  std::vector<Segment> crossing;
  for (const std::vector<Vec2>& ring : shape.crossing_rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      crossing.push_back({film_from_world(world_from_shape(ring[i])),
                          film_from_world(world_from_shape(ring[(i + 1) % ring.size()]))});
  std::vector<ArcPath> paths;
  for (const ArcPath& path : shape.arc_paths)
    paths.push_back(film_path(path, world_from_shape, film_from_world));
  if (fill) {
    const LinearColour colour = linear(*fill);
    if (!edges.empty())
      add({FillPath{edges, FillRule::nonzero, shape.piece_count() == 1 && still_convex(edges)},
           colour});
    if (!crossing.empty()) add({FillPath{crossing, FillRule::even_odd, false}, colour});
    for (const Circle& circle : circles) add({FillRing{circle.centre, circle.radius}, colour});
    for (const ArcPath& path : paths)
      if (path.closed) add({FillArcs{path}, colour});
  }
  if (stroke) {
    edges.insert(edges.end(), crossing.begin(), crossing.end());
    for (const Segment& segment : shape.segments)
      edges.push_back({film_from_world(world_from_shape(segment.a)),
                       film_from_world(world_from_shape(segment.b))});
    for (const ArcPath& path : paths) {
      const std::vector<Vec2> points = flattened(path, kCapSagitta_px);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        edges.push_back({points[i], points[i + 1]});
    }
    add_outline(edges, circles, *stroke);
  }
}

void DrawContext::add_outline(const std::vector<Segment>& edges, std::span<const Circle> circles,
                              const Stroke& stroke) {
  const double half = half_width_px(stroke);
  if (!(half > 0)) return;
  FillPath path;
  for (const Segment& edge : edges) add_capsule(edge, half, path.edges);
  if (!path.edges.empty()) add({std::move(path), linear(stroke.colour)});
  for (const Circle& circle : circles)
    add({FillRing{circle.centre, circle.radius + half, circle.radius - half},
         linear(stroke.colour)});
}

void DrawContext::add_lines(std::span<const Segment> world, const Stroke& stroke) {
  std::vector<Segment> edges;
  for (const Segment& line : world)
    edges.push_back({film_from_world(line.a), film_from_world(line.b)});
  add_outline(edges, {}, stroke);
}

void DrawContext::add_mark(const Vec2& world, double radius_px, const Colour& colour) {
  add({FillRing{film_from_world(world), radius_px}, linear(colour)});
}

}  // namespace flatray
