#include "geom/cyrus_beck.h"
#include "render/pass.h"
#include "trace/hit_intervals.h"

namespace flatray {
namespace {

constexpr double kInsideWidths = 3;  // the inside part, against the rest of the ray
constexpr double kMarkWidths = 4;    // entering and exiting points

Need need(const Scene& scene) {
  if (scene.edge_rays.empty()) return skip("no edge rays");
  return run(std::to_string(scene.edge_rays.size()) + " pairs of entities");
}

struct InWorld {
  const Shape& shape;
  Pose pose;
};

InWorld in_world(const DrawContext& context, std::uint32_t entity) {
  return {context.scene.shapes[context.state.entities[entity].shape],
          entity_pose(context.state, entity)};
}

// Outline edges, cuts between pieces left out, as rays whose t = 1 is the edge's end.
std::vector<Ray> outline_rays(const InWorld& thing) {
  std::vector<Ray> rays;
  const Shape& shape = thing.shape;
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece)
    for (std::size_t i = shape.begin[piece]; i < shape.begin[piece + 1]; ++i) {
      if (shape.edges[i] == kNoEdge) continue;
      const std::size_t next = i + 1 < shape.begin[piece + 1] ? i + 1 : shape.begin[piece];
      const Vec2 a = thing.pose(shape.vertices[i]);
      rays.push_back({a, thing.pose(shape.vertices[next]) - a});
    }
  for (const Segment& segment : shape.segments) {
    const Vec2 a = thing.pose(segment.a);
    rays.push_back({a, thing.pose(segment.b) - a});
  }
  return rays;
}

// What the rays find, as things to draw.
struct Found {
  std::vector<Segment> inside;
  std::vector<Vec2> enter, exit;

  void add(const Ray& ray, const HitInterval& hit, bool enters, bool exits) {
    const Vec2 a = ray.origin + hit.t_enter * ray.direction;
    const Vec2 b = ray.origin + hit.t_exit * ray.direction;
    inside.push_back({a, b});
    if (enters) enter.push_back(a);
    if (exits) exit.push_back(b);
  }
};

// A ray that crosses a cut between two pieces neither enters nor leaves there.
void clip_piece(std::span<const Ray> rays, const InWorld& against, std::size_t piece,
                Found& found) {
  const Shape& shape = against.shape;
  const std::size_t begin = shape.begin[piece];
  std::vector<Vec2> vertices;
  for (std::size_t i = begin; i < shape.begin[piece + 1]; ++i)
    vertices.push_back(against.pose(shape.vertices[i]));
  const auto is_outline = [&](int edge) {
    return edge != kNoEdge && shape.edges[begin + static_cast<std::size_t>(edge)] != kNoEdge;
  };
  RayBatch batch;
  for (const Ray& ray : rays) batch.add(ray);
  std::vector<HitInterval> hits(rays.size());
  clip_convex_batch(batch, vertices, kSegment, hits);
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (hits[i])
      found.add(rays[i], hits[i], is_outline(hits[i].edge_enter), is_outline(hits[i].edge_exit));
}

Found clip_all(std::span<const Ray> rays, const InWorld& against) {
  Found found;
  for (std::size_t piece = 0; piece < against.shape.piece_count(); ++piece)
    clip_piece(rays, against, piece, found);
  for (const Circle& circle : against.shape.circles)
    for (const Ray& ray : rays)
      if (const HitInterval hit =
              clip_circle(ray, {against.pose(circle.centre), circle.radius}, kSegment))
        found.add(ray, hit, hit.t_enter > 0, hit.t_exit < 1);
  return found;
}

void draw(DrawContext& context) {
  for (const EdgeRays& pair : context.scene.edge_rays) {
    const std::vector<Ray> rays = outline_rays(in_world(context, pair.from));
    const Found found = clip_all(rays, in_world(context, pair.against));
    std::vector<Segment> lines;
    for (const Ray& ray : rays) lines.push_back({ray.origin, ray.origin + ray.direction});
    context.place(pair.layer, pair.where);
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

extern const Pass edge_rays_pass;
const Pass edge_rays_pass = {"edge_rays", &need, &draw};

}  // namespace flatray
