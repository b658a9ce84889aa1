#include "render/coverage/closed_parts.h"

#include "anim/world.h"
#include "trace/hit_intervals.h"

namespace flatray {
namespace {

void add(const HitInterval& hit, std::vector<Range>& inside) {
  if (hit) inside.push_back({hit.t_enter, hit.t_exit});
}

void clip_part(const std::vector<Vec2>& corners, const RayBatch& rays,
               std::span<std::vector<Range>> inside) {
  std::vector<HitInterval> hits(rays.size());
  clip_convex_batch(rays, corners, kRay, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) add(hits[i], inside[i]);
}

void clip_part(const Circle& circle, const RayBatch& rays, std::span<std::vector<Range>> inside) {
  for (std::size_t i = 0; i < rays.size(); ++i) add(clip_circle(rays.ray(i), circle), inside[i]);
}

void clip_part(const CurvedPath& path, const RayBatch& rays, std::span<std::vector<Range>> inside) {
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (const HitInterval& hit : clip_path(rays.ray(i), path)) add(hit, inside[i]);
}

}  // namespace

ClosedParts::ClosedParts(const Scene& scene, const FrameState& state) {
  for (std::size_t i = 0; i < scene.entities.size(); ++i)
    if (!state.entities[i].gone)
      add_shape(shape_of(scene, state.entities[i]), entity_pose(state, i));
  for (const Chamber& chamber : scene.chambers)
    for (const Chamber::Pillar& pillar : chamber.pillars)
      add_shape(scene.shapes[pillar.shape], pillar_pose(state, pillar));
}

void ClosedParts::add_shape(const Shape& shape, const Pose& place) {
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece)
    add_piece(posed_piece(shape, piece, place));
  for (const Circle& circle : shape.circles) {
    const Circle there = posed(circle, place);
    add_wall(there);
    parts_.emplace_back(there);
  }
  for (const ArcPath& path : shape.arc_paths)
    if (path.closed) add_path(path_in_world(path, place));
}

void ClosedParts::add_piece(std::vector<Vec2> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    add_segment(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
  parts_.emplace_back(std::move(corners));
}

void ClosedParts::add_path(CurvedPath path) {
  for (const PathEdge& edge : path.edges) {
    if (edge.arc)
      add_wall(*edge.arc);
    else
      add_segment(edge.from, edge.to);
  }
  parts_.emplace_back(std::move(path));
}

void ClosedParts::add_segment(const Vec2& a, const Vec2& b) {
  if (a != b) add_wall(Segment{a, b});
}

void ClosedParts::clip(std::uint32_t part, const RayBatch& rays,
                       std::span<std::vector<Range>> inside) const {
  std::visit([&](const auto& shape) { clip_part(shape, rays, inside); }, parts_[part]);
}

}  // namespace flatray
