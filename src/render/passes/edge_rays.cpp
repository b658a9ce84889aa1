
#include "anim/world.h"
#include "base/counted.h"
#include "geom/box_tree.h"
#include "geom/clip.h"
#include "geom/interval_set.h"
#include "geom/primitives/wall.h"
#include "render/pass.h"
#include "scene/outlines/outline.h"

namespace flatray::edge_rays_pass {
namespace {

constexpr double kInsideWidths = 3;  // the inside part, against the rest of the ray
constexpr double kMarkWidths = 4;    // entering and exiting points

Need need(const Scene& scene) {
  if (scene.edge_rays.empty()) return skip("no edge rays");
  return run(counted(scene.edge_rays.size(), "pair of entities", "pairs of entities"));
}

struct InWorld {
  const Shape& shape;
  Pose pose;
};

InWorld in_world(const DrawContext& context, std::uint32_t entity) {
  return {shape_of(context.scene, context.state.entities[entity]),
          entity_pose(context.state, entity)};
}

// Straight outline edges.
std::vector<Segment> outline_edges(const InWorld& thing) {
  std::vector<Segment> edges;
  const Shape& shape = thing.shape;
  for (const OutlineEdge& edge : outline(shape))
    edges.push_back({thing.pose(shape.vertices[edge.from]), thing.pose(shape.vertices[edge.to])});
  for (const Segment& segment : shape.segments)
    edges.push_back({thing.pose(segment.a), thing.pose(segment.b)});
  for (const ArcPath& path : shape.arc_paths)
    for (const PathEdge& edge : path_in_world(path, thing.pose).edges)
      if (!edge.arc) edges.push_back({edge.from, edge.to});
  return edges;
}

// What the rays find, as things to draw.
struct Found {
  std::vector<Segment> inside;
  std::vector<Vec2> enter, exit;

  void add(const Segment& edge, const Range& part) {
    const Vec2 way = edge.b - edge.a, a = edge.a + part.low * way, b = edge.a + part.high * way;
    inside.push_back({a, b});
    if (part.low > 0) enter.push_back(a);
    if (part.high < 1) exit.push_back(b);
  }
};

BoxTree tree_of(std::span<const Segment> edges) {
  std::vector<Bounds> boxes(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) boxes[i] = bounds_of(edges[i]);
  return BoxTree(std::move(boxes));
}

Found clip_all(std::span<const Segment> edges, const InWorld& against) {
  const BoxTree boxes = tree_of(edges);
  std::vector<std::vector<Range>> parts(edges.size());
  const auto keep = [&](std::size_t edge, const HitInterval& hit) {
    if (hit) parts[edge].push_back({hit.t_enter, hit.t_exit});
  };
  const Shape& shape = against.shape;
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece) {
    const std::vector<Vec2> vertices = posed_piece(shape, piece, against.pose);
    for (const std::size_t i : boxes.near(box_about(vertices)))
      keep(i, clip_edge(edges[i], vertices));
  }
  for (const Circle& circle : shape.circles) {
    const Circle there = posed(circle, against.pose);
    for (const std::size_t i : boxes.near(curve_bounds(there)))
      keep(i, clip_edge(edges[i], Ellipse(there)));
  }
  for (const ArcPath& path : shape.arc_paths) {
    const CurvedPath there = path_in_world(path, against.pose);
    for (const std::size_t i : boxes.near(bounds_of(there)))
      for (const HitInterval& hit :
           clip_path({edges[i].a, edges[i].b - edges[i].a}, there, kSegment))
        keep(i, hit);
  }
  Found found;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const Range& part : interval_set(std::move(parts[i]))) found.add(edges[i], part);
  return found;
}

void draw(DrawContext& context) {
  for (const EdgeRays& pair : context.scene.edge_rays) {
    if (context.refused()) return;
    if (context.state.entities[pair.from].gone || context.state.entities[pair.against].gone)
      continue;
    const std::vector<Segment> edges = outline_edges(in_world(context, pair.from));
    const Found found = clip_all(edges, in_world(context, pair.against));
    context.place(pair.layer, pair.order, pair.where);
    context.add_lines(edges, pair.stroke);
    Stroke thick = pair.stroke;
    thick.width *= kInsideWidths;
    thick.colour = pair.inside;
    context.add_lines(found.inside, thick);
    const double radius_px = kMarkWidths * context.half_width_px(pair.stroke);
    for (const Vec2& point : found.enter) context.add_mark(point, radius_px, pair.enter);
    for (const Vec2& point : found.exit) context.add_mark(point, radius_px, pair.exit);
  }
}

}  // namespace

extern const Pass entry = {"edge_rays", &need, &draw};

}  // namespace flatray::edge_rays_pass
