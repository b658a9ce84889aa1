#include <algorithm>
#include <variant>

#include "geom/clip.h"
#include "geom/curved_path.h"
#include "render/row_lengths.h"
#include "render/view.h"
#include "trace/hit_intervals.h"

namespace flatray::intervals_view {
namespace {

// Whether the grey of a length stays the same where it is off by `error`. That of a picture is a
// product of 255 that is rounded some four times.
bool is_sure(double length, double error, double most) {
  const double grey = 255 * (1 - std::clamp(length / most, 0.0, 1.0));
  const double to_a_half = std::fabs(grey - std::floor(grey) - 0.5);
  return to_a_half > 255 * error / most + 0x1p-40;
}

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

// What has an inside in one frame, in the world: the convex pieces, circles and closed paths of
// entities and pillars, with the walls round each, those between pieces of one shape too.
class ClosedParts {
 public:
  ClosedParts(const Scene& scene, const FrameState& state) {
    for (std::size_t i = 0; i < scene.entities.size(); ++i)
      if (!state.entities[i].gone)
        add_shape(shape_of(scene, state.entities[i]), entity_pose(state, i));
    for (const Chamber& chamber : scene.chambers)
      for (const Chamber::Pillar& pillar : chamber.pillars)
        add_shape(scene.shapes[pillar.shape], pillar_pose(state, pillar));
  }

  // Walls round all of them, for a tracer: a ray lies in a part nowhere, or only in points, unless
  // it meets a wall of it.
  const Surfaces& walls() const { return walls_; }
  // The part that a wall stands round.
  std::uint32_t part_of(std::uint32_t wall) const { return part_of_[wall]; }

  // Adds where each ray lies in a part. Needs as many lists as rays.
  void clip(std::uint32_t part, const RayBatch& rays, std::span<std::vector<Range>> inside) const {
    std::visit([&](const auto& shape) { clip_part(shape, rays, inside); }, parts_[part]);
  }

 private:
  void add_shape(const Shape& shape, const Pose& place) {
    for (std::size_t piece = 0; piece < shape.piece_count(); ++piece) {
      std::vector<Vec2> corners = posed_piece(shape, piece, place);
      for (std::size_t i = 0; i < corners.size(); ++i)
        add_segment(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
      parts_.emplace_back(std::move(corners));
    }
    for (const Circle& circle : shape.circles) {
      const Circle there = posed(circle, place);
      add_wall(there);
      parts_.emplace_back(there);
    }
    for (const ArcPath& path : shape.arc_paths) {
      if (!path.closed) continue;
      CurvedPath there = path_in_world(path, place);
      for (const PathEdge& edge : there.edges)
        if (edge.arc)
          add_wall(*edge.arc);
        else
          add_segment(edge.from, edge.to);
      parts_.emplace_back(std::move(there));
    }
  }

  void add_segment(const Vec2& a, const Vec2& b) {
    if (a != b) add_wall(Segment{a, b});
  }

  template <class Wall>
  void add_wall(const Wall& wall) {
    walls_.add(wall);
    part_of_.push_back(static_cast<std::uint32_t>(parts_.size()));
  }

  std::vector<std::variant<std::vector<Vec2>, Circle, CurvedPath>> parts_;
  Surfaces walls_;
  std::vector<std::uint32_t> part_of_;
};

// The parts that a ray meets the walls of, each once.
std::vector<std::uint32_t> parts_met(const Ray& ray, const Accelerator& walls,
                                     const ClosedParts& parts) {
  std::vector<std::uint32_t> met;
  for (const NearestHit& hit : walls.all_of_one(ray)) met.push_back(parts.part_of(hit.surface));
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  return met;
}

// All rays of a row lie on the first: the parts that one meets are asked of the tracer, and lengths
// taken along it. Pixels whose grey that leaves in doubt are clipped each for itself.
void draw_row(const RayBatch& rays, const Accelerator& walls, const ClosedParts& parts, double most,
              std::uint8_t* pixels) {
  const std::vector<std::uint32_t> met = parts_met(rays.ray(0), walls, parts);
  RayBatch first, doubtful;
  first.add(rays.ray(0));
  std::vector<Range> inside;
  for (const std::uint32_t part : met) parts.clip(part, first, {&inside, 1});
  RowLengths lengths(std::move(inside));
  std::vector<std::uint8_t*> left;
  for (std::size_t i = 0; i < rays.size(); ++i, pixels += 3) {
    const double length = lengths.ahead((rays.ox[i] - rays.ox[0]) / rays.dx[0]);
    std::fill_n(pixels, 3, grey_of(length, most));
    if (is_sure(length, lengths.error(), most)) continue;
    doubtful.add(rays.ray(i));
    left.push_back(pixels);
  }
  if (left.empty()) return;
  std::vector<std::vector<Range>> each(left.size());
  for (const std::uint32_t part : met) parts.clip(part, doubtful, each);
  for (std::size_t i = 0; i < left.size(); ++i)
    std::fill_n(left[i], 3, grey_of(length_of(interval_set(std::move(each[i]))), most));
}

void draw(const ViewFrame& frame, const EachRow& each_row) {
  const ClosedParts parts(frame.scene, frame.state);
  const std::unique_ptr<Accelerator> walls = made_ready(parts.walls(), frame);
  each_row([&](int row, std::uint8_t* pixels) {
    draw_row(rays_to_the_right(frame, row), *walls, parts, frame.scene.film.width, pixels);
  });
}

}  // namespace

extern const View entry = {"intervals",
                           "how much of the way to the right lies inside shapes: none is white",
                           false, true, &draw};

}  // namespace flatray::intervals_view
