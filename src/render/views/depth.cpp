#include "render/view.h"

namespace flatray::depth_view {
namespace {

class Depth : public ViewRows {
 public:
  explicit Depth(const ViewFrame& frame) : frame_(frame), seen_(frame) {}

  void draw(int row, std::uint8_t* pixels) const override {
    for (const NearestHit& hit : seen_.nearest(rays_to_the_right(frame_, row))) {
      const std::uint8_t grey = hit ? grey_of(hit.t, frame_.scene.film.width) : 0;
      pixels = std::fill_n(pixels, 3, grey);
    }
  }

 private:
  const ViewFrame frame_;
  const SeenWalls seen_;
};

}  // namespace

extern const View entry = {
    "depth", "how far it is to the first wall on the right: near is white, a film's width black",
    false, false, &make_rows<Depth>};

}  // namespace flatray::depth_view
