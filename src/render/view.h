#pragma once
#include <string>
#include <vector>

#include "anim/world.h"
#include "image/image.h"
#include "render/film_transform.h"
#include "render/frame.h"
#include "trace/tracer.h"

namespace flatray {

/// What a view is drawn from: one ray a pixel, cast from its centre among the outlines of all that
/// the scene shows, but for what no ray meets: rings that cross themselves. Where nothing else is said rays go to the right, t in pixels.
struct ViewContext {
  const Scene& scene;
  const FrameState& state;
  const World& world;           ///< of everything, mirror or not, but for what `argument` lies on
  const Accelerator& surfaces;  ///< of `world`
  Vec2 argument;                ///< world point, for views that take one
  std::vector<Arc> rims;        ///< circles that `argument` lies on; its segments are nowhere
  PixelBox crop;
};

/// One kind of question asked of every pixel.
struct View {
  const char* name;
  const char* summary;  ///< one line, no full stop
  bool takes_point;     ///< as in "visibility:x,y"
  /// A row of the crop into `pixels`, three bytes each. `row` counts from the top of the film.
  void (*draw_row)(const ViewContext& context, int row, std::uint8_t* pixels);
};

/// Registered views by name.
std::vector<const View*> views();

/// Centre of a pixel in the world.
Vec2 pixel_centre(const ViewContext& context, int column, int row);
/// World length of a pixel's side.
double pixel_side(const ViewContext& context);
/// One ray to the right from every pixel of a row, t = 1 a pixel on.
RayBatch rays_to_the_right(const ViewContext& context, int row);
/// What each ray of a row meets first.
std::vector<NearestHit> nearest_hits(const ViewContext& context, const RayBatch& rays);
/// 255 at 0 and 0 from `most` on.
std::uint8_t grey_of(double value, double most);

/// A view as the user asks for it.
struct ViewRequest {
  const View* view = nullptr;
  Vec2 point{0, 0};
};

/// Same bytes from every exact tracer (null: the one chosen by the number of walls), for any number
/// of threads and crop; no picture once `options.stop` has said so.
Image draw_view(const ViewRequest& request, const Tracer* tracer, const Scene& scene,
                const FrameState& state, const FrameOptions& options);

}  // namespace flatray
