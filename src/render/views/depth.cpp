#include "render/view.h"

namespace flatray::depth_view {
namespace {

void draw(const ViewFrame& frame, const EachRow& each_row) {
  const SeenWalls seen(frame);
  each_row([&](int row, std::uint8_t* pixels) {
    for (const NearestHit& hit : seen.nearest(rays_to_the_right(frame, row))) {
      const std::uint8_t grey = hit ? grey_of(hit.t, frame.scene.film.width) : 0;
      pixels = std::fill_n(pixels, 3, grey);
    }
  });
}

}  // namespace

extern const View entry = {
    "depth", "how far it is to the first wall on the right: near is white, a film's width black",
    false, false, &draw};

}  // namespace flatray::depth_view
