#include "render/view.h"

namespace flatray::views_of {
namespace {

void draw_row(const ViewContext& context, int row, std::uint8_t* pixels) {
  for (const NearestHit& hit : nearest_hits(context, rays_to_the_right(context, row))) {
    const std::uint8_t grey = hit ? grey_of(hit.t, context.scene.film.width) : 0;
    pixels = std::fill_n(pixels, 3, grey);
  }
}

}  // namespace

extern const View depth = {
    "depth", "how far it is to the first wall on the right: near is white, a film's width black",
    false, &draw_row};

}  // namespace flatray::views_of
