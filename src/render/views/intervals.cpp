#include "geom/bounds.h"
#include "geom/interval_set.h"
#include "render/view.h"
#include "trace/hit_intervals.h"

namespace flatray::views_of {
namespace {

using Parts = std::vector<std::vector<Range>>;  // inside something, by pixel of the row

void add(const HitInterval& hit, std::vector<Range>& parts) {
  if (hit) parts.push_back({hit.t_enter, hit.t_exit});
}

// Whether a row at height y passes by. A rounded difference above the radius is one.
bool apart(double y, const Bounds& box) { return y < box.low.y() || y > box.high.y(); }
bool apart(double y, const Circle& circle) {
  return std::fabs(y - circle.centre.y()) > circle.radius;
}

void add_shape(const Shape& shape, const Pose& place, const RayBatch& rays, Parts& parts) {
  const double y = rays.oy.front();
  std::vector<HitInterval> intervals(rays.size());
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece) {
    const std::vector<Vec2> corners = posed_piece(shape, piece, place);
    Bounds box;
    for (const Vec2& corner : corners) box.add(corner);
    if (apart(y, box)) continue;
    clip_convex_batch(rays, corners, kRay, intervals);
    for (std::size_t i = 0; i < intervals.size(); ++i) add(intervals[i], parts[i]);
  }
  for (const Circle& circle : shape.circles) {
    const Circle there = posed(circle, place);
    if (apart(y, there)) continue;
    for (std::size_t i = 0; i < rays.size(); ++i) add(clip_circle(rays.ray(i), there), parts[i]);
  }
  for (const ArcPath& path : shape.arc_paths) {
    const CurvedPath there = path_in_world(path, place);
    if (!there.closed || apart(y, bounds_of(there))) continue;
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (const HitInterval& hit : clip_path(rays.ray(i), there)) add(hit, parts[i]);
  }
}

void draw_row(const ViewContext& context, int row, std::uint8_t* pixels) {
  const RayBatch rays = rays_to_the_right(context, row);
  Parts parts(rays.size());
  for (std::size_t i = 0; i < context.scene.entities.size(); ++i)
    if (!context.state.entities[i].gone)
      add_shape(shape_of(context.scene, context.state.entities[i]), entity_pose(context.state, i),
                rays, parts);
  for (const Chamber& chamber : context.scene.chambers)
    for (const Chamber::Pillar& pillar : chamber.pillars)
      add_shape(context.scene.shapes[pillar.shape], pillar_pose(context.state, pillar), rays,
                parts);
  for (std::vector<Range>& inside : parts) {
    const double length = length_of(interval_set(std::move(inside)));
    pixels = std::fill_n(pixels, 3, grey_of(length, context.scene.film.width));
  }
}

}  // namespace

extern const View intervals = {"intervals",
                               "how much of the way to the right lies inside shapes: none is white",
                               false, &draw_row};

}  // namespace flatray::views_of
