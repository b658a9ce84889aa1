#include "study/accuracy/linear_error.h"

#include "image/tile.h"

namespace flatray {

Result<std::shared_ptr<DrawnFrame>> frame_to_draw(const AccuracyContext& context) {
  FLATRAY_TRY(list, middle_list(context));
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
