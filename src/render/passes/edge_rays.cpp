
#include "anim/world.h"
#include "base/counted.h"
#include "geom/box_tree.h"
#include "geom/clip.h"
#include "geom/interval_set.h"
#include "render/pass.h"
#include "scene/outlines/outline.h"
#include "trace/hit_intervals.h"

namespace flatray {
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

// Straight outline edges as rays whose t = 1 is the edge's end.
std::vector<Ray> outline_rays(const InWorld& thing) {
  std::vector<Ray> rays;
  const Shape& shape = thing.shape;
  for (const OutlineEdge& edge : outline(shape)) {
    const Vec2 a = thing.pose(shape.vertices[edge.from]);
    rays.push_back({a, thing.pose(shape.vertices[edge.to]) - a});
  }
  for (const Segment& segment : shape.segments) {
    const Vec2 a = thing.pose(segment.a);
    rays.push_back({a, thing.pose(segment.b) - a});
  }
  for (const ArcPath& path : shape.arc_paths)
    for (const PathEdge& edge : path_in_world(path, thing.pose).edges)
      if (!edge.arc) rays.push_back({edge.from, edge.to - edge.from});
  return rays;
}

// What the rays find, as things to draw.
struct Found {
  std::vector<Segment> inside;
  std::vector<Vec2> enter, exit;

  void add(const Ray& ray, const Range& part) {
    const Vec2 a = ray.origin + part.low * ray.direction,
               b = ray.origin + part.high * ray.direction;
    inside.push_back({a, b});
    if (part.low > 0) enter.push_back(a);
    if (part.high < 1) exit.push_back(b);
  }
};

// Rays of one entity by their boxes. Rounding an end is monotone, so that no box of doubles tells two apart
// that meet.
BoxTree tree_of(std::span<const Ray> rays) {
  std::vector<Bounds> boxes(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    boxes[i].add(rays[i].origin);
    boxes[i].add(rays[i].origin + rays[i].direction);
  }
  return BoxTree(std::move(boxes));
}

Found clip_all(std::span<const Ray> rays, const InWorld& against) {
  const BoxTree boxes = tree_of(rays);
  std::vector<std::vector<Range>> parts(rays.size());
  const auto keep = [&](std::size_t ray, const HitInterval& hit) {
    if (hit) parts[ray].push_back({hit.t_enter, hit.t_exit});
  };
  const Shape& shape = against.shape;
  std::vector<HitInterval> hits;
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece) {
    const std::vector<Vec2> vertices = posed_piece(shape, piece, against.pose);
    Bounds box;
    for (const Vec2& vertex : vertices) box.add(vertex);
    const std::vector<std::size_t> near = boxes.near(box);
    if (near.empty()) continue;
    RayBatch batch;
    for (const std::size_t i : near) batch.add(rays[i]);
    hits.resize(near.size());
    clip_convex_batch(batch, vertices, kSegment, hits);
    for (std::size_t i = 0; i < near.size(); ++i) keep(near[i], hits[i]);
  }
  for (const Circle& circle : shape.circles) {
    const Circle there = posed(circle, against.pose);
    for (const std::size_t i : boxes.near(curve_bounds(there)))
      keep(i, clip_circle(rays[i], there, kSegment));
  }
  for (const ArcPath& path : shape.arc_paths) {
    const CurvedPath there = path_in_world(path, against.pose);
    for (const std::size_t i : boxes.near(bounds_of(there)))
      for (const HitInterval& hit : clip_path(rays[i], there, kSegment)) keep(i, hit);
  }
  Found found;
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (const Range& part : interval_set(std::move(parts[i]))) found.add(rays[i], part);
  return found;
}

void draw(DrawContext& context) {
  for (const EdgeRays& pair : context.scene.edge_rays) {
    if (context.refused()) return;
    if (context.state.entities[pair.from].gone || context.state.entities[pair.against].gone)
      continue;
    const std::vector<Ray> rays = outline_rays(in_world(context, pair.from));
    const Found found = clip_all(rays, in_world(context, pair.against));
    std::vector<Segment> lines;
    lines.reserve(rays.size());
    for (const Ray& ray : rays) lines.push_back({ray.origin, ray.origin + ray.direction});
    context.place(pair.layer, pair.order, pair.where);
    context.add_lines(lines, pair.stroke);
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

extern const Pass edge_rays_pass = {"edge_rays", &need, &draw};

}  // namespace flatray
