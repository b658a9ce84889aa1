#include "study/accuracy/linear_error.h"

#include "image/tile.h"

namespace flatray {

Result<std::shared_ptr<DrawnFrame>> frame_to_draw(const AccuracyContext& context) {
  constexpr std::uint64_t kMostRays = 1 << 12;  // light is the same however the rest is drawn
  FLATRAY_TRY(list, middle_list(context, kMostRays));
  list->coverage = Coverage::area;
  return std::make_shared<DrawnFrame>(DrawnFrame{std::move(*list), context.threads});
}

Image developed(const LinearImage& light) {
  Image image(light.width, light.height, 3);
  Tile tile{0, 0, light.width, light.height, {}};
  for (std::size_t i = 0; i < light.pixels.size(); i += 3)
    tile.rgba.insert(tile.rgba.end(),
                     {light.pixels[i], light.pixels[i + 1], light.pixels[i + 2], 1.0F});
  develop(tile, image);
  return image;
}

}  // namespace flatray
