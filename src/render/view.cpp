#include "render/view.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"

namespace flatray {

#include "views.inc"  // views()

double pixel_side(const ViewFrame& frame) {
  return frame.state.window.size().x() / frame.scene.film.width;
}

Vec2 pixel_centre(const ViewFrame& frame, int column, int row) {
  const Bounds& window = frame.state.window;
  const double side = pixel_side(frame);
  return {window.low.x() + (column + 0.5) * side, window.high.y() - (row + 0.5) * side};
}

RayBatch rays_to_the_right(const ViewFrame& frame, int row) {
  const double side = pixel_side(frame);
  RayBatch rays;
  for (int i = 0; i < frame.crop.width; ++i)
    rays.add({pixel_centre(frame, frame.crop.x + i, row), {side, 0}});
  return rays;
}

std::unique_ptr<Accelerator> made_ready(const Surfaces& walls, const ViewFrame& frame) {
  return choose_tracer(walls, frame.tracer).tracer->build(walls, active_isa(), frame.threads);
}

std::vector<NearestHit> SeenWalls::nearest(const RayBatch& rays) const {
  std::vector<NearestHit> hits(rays.size());
  walls_->nearest(rays, hits);
  return hits;
}

bool SeenWalls::crosses(const Ray& ray) const {
  const std::vector<NearestHit> hits = walls_->all_of_one(ray);
  return std::ranges::any_of(hits, [](const NearestHit& hit) { return hit.t > 0 && hit.t < 1; });
}

std::uint8_t grey_of(double value, double most) {
  return static_cast<std::uint8_t>(std::lround(255 * (1 - std::clamp(value / most, 0.0, 1.0))));
}

Image draw_view(const ViewRequest& request, const Tracer* tracer, const Scene& scene,
                const FrameState& state, const FrameOptions& options) {
  const PixelBox film{0, 0, scene.film.width, scene.film.height};
  const ViewFrame frame{scene,          state, tracer, request.point, options.crop.value_or(film),
                        options.threads};
  FLATRAY_CHECK(!request.view->asks_for_all || tracer == nullptr || tracer->exact,
                "the view asks for all walls of a ray");
  Image image(frame.crop.width, frame.crop.height, 3);
  request.view->draw(frame, [&](const RowDrawer& draw_row) {
    parallel_for(static_cast<std::size_t>(image.height), options.threads, [&](std::size_t i) {
      if (options.stopped()) return;
      const int y = static_cast<int>(i);
      draw_row(frame.crop.y + y, image.at(0, y));
    });
  });
  return image;
}

}  // namespace flatray
