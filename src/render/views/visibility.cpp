#include "render/view.h"

namespace flatray::views_of {
namespace {

// Lit where nothing lies between the pixel and the point: no wall at t < 1, the point's own place.
void draw_row(const ViewContext& context, int row, std::uint8_t* pixels) {
  RayBatch rays;
  for (int i = 0; i < context.crop.width; ++i) {
    const Vec2 centre = pixel_centre(context, context.crop.x + i, row);
    rays.add({centre, context.argument - centre});
  }
  for (const NearestHit& hit : nearest_hits(context, rays)) {
    constexpr std::uint8_t kShadow = 64, kLit = 255;
    pixels = std::fill_n(pixels, 3, hit && hit.t < 1 ? kShadow : kLit);
  }
}

}  // namespace

extern const View visibility = {
    "visibility", "what a point at x,y lights, as nothing is in between", true, &draw_row};

}  // namespace flatray::views_of
