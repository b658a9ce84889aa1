#include "render/view.h"

#include <algorithm>

#include "base/parallel.h"
#include "trace/on_surface.h"

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

namespace {

// What is left of a world without the walls a point lies on.
World without_walls_at(const Vec2& point, const World& all, std::vector<Arc>& rims) {
  World rest;
  for (std::size_t i = 0; i < all.surfaces.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const std::uint32_t slot = all.surfaces.slot[i];
    if (all.surfaces.is_straight(number)) {
      const Segment& wall = all.surfaces.segments[slot];
      if (lies_on(point, wall)) continue;
      rest.surfaces.add(wall);
    } else if (const Arc wall = all.surfaces.arc(number);
               place_on(wall, point) != ArcPlace::outside) {
      rims.push_back(wall);
      continue;
    } else if (all.surfaces.kinds[i] == SurfaceKind::circle) {
      rest.surfaces.add(all.surfaces.circles[slot]);
    } else {
      rest.surfaces.add(wall);
    }
    rest.owners.push_back(all.owners[i]);
  }
  return rest;
}

}  // namespace

Image draw_view(const ViewRequest& request, const Tracer* tracer, const Scene& scene,
                const FrameState& state, const FrameOptions& options) {
  World world = build_world(scene, state, WorldOf::everything);
  std::vector<Arc> rims;
  if (request.view->takes_point) world = without_walls_at(request.point, world, rims);
  const auto surfaces = tracer == nullptr
                            ? accelerate(world.surfaces, options.threads)
                            : tracer->build(world.surfaces, active_isa(), options.threads);
  const PixelBox film{0, 0, scene.film.width, scene.film.height};
  const ViewContext context{
      scene, state, world, *surfaces, request.point, rims, options.crop.value_or(film)};
  Image image(context.crop.width, context.crop.height, 3);
  parallel_for(static_cast<std::size_t>(image.height), options.threads, [&](std::size_t i) {
    if (options.stopped()) return;
    const int y = static_cast<int>(i);
    request.view->draw_row(context, context.crop.y + y, image.at(0, y));
  });
  return image;
}

}  // namespace flatray
