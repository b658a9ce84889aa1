#include "render/view.h"

#include <algorithm>

#include "base/parallel.h"

namespace flatray {

#define FLATRAY_ENTRY(name) \
  namespace views_of {      \
  extern const View name;   \
  }
#include "views.inc"
#undef FLATRAY_ENTRY

std::vector<const View*> views() {
#define FLATRAY_ENTRY(name) &views_of::name,
  return {
#include "views.inc"
  };
#undef FLATRAY_ENTRY
}

double pixel_side(const ViewContext& context) {
  return context.state.window.size().x() / context.scene.film.width;
}

Vec2 pixel_centre(const ViewContext& context, int column, int row) {
  const Bounds& window = context.state.window;
  const double side = pixel_side(context);
  return {window.low.x() + (column + 0.5) * side, window.high.y() - (row + 0.5) * side};
}

RayBatch rays_to_the_right(const ViewContext& context, int row) {
  const double side = pixel_side(context);
  RayBatch rays;
  for (int i = 0; i < context.crop.width; ++i)
    rays.add({pixel_centre(context, context.crop.x + i, row), {side, 0}});
  return rays;
}

std::vector<NearestHit> nearest_hits(const ViewContext& context, const RayBatch& rays) {
  std::vector<NearestHit> hits(rays.size());
  context.surfaces.nearest(rays, hits);
  return hits;
}

std::uint8_t grey_of(double value, double most) {
  return static_cast<std::uint8_t>(std::lround(255 * (1 - std::clamp(value / most, 0.0, 1.0))));
}

Image draw_view(const ViewRequest& request, const Scene& scene, const FrameState& state,
                const FrameOptions& options) {
  const World world = build_world(scene, state, WorldOf::everything);
  const auto surfaces = request.tracer == nullptr ? accelerate(world.surfaces)
                                                  : request.tracer->build(world.surfaces);
  const PixelBox film{0, 0, scene.film.width, scene.film.height};
  const ViewContext context{scene,     state,         world,
                            *surfaces, request.point, options.crop.value_or(film)};
  Image image(context.crop.width, context.crop.height, 3);
  parallel_for(static_cast<std::size_t>(image.height), options.threads, [&](std::size_t i) {
    if (options.stop != nullptr && options.stop()) return;
    const int y = static_cast<int>(i);
    request.view->draw_row(context, context.crop.y + y, image.at(0, y));
  });
  return image;
}

}  // namespace flatray
