#include "study/accuracy/linear_error.h"

#include <algorithm>
#include <cmath>

#include "image/tile.h"

namespace flatray {

double rms_difference(const LinearImage& a, const LinearImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double off = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1)));
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
