#pragma once
#include <algorithm>

#include "drawing.h"
#include "filler.h"

namespace bench {

/// The polygons over white by 64 rays a row of pixels, each exact: what all are compared with. Items
/// that share a pixel hide one another there. Blends sRGB values, as the peers do, or light.
class ExactPicture {
 public:
  using Value = double (*)(double);

  ExactPicture(const std::vector<Polygon>& polygons, Value value_of_srgb) {
    flatray::DrawList list = draw_list(polygons, kWidth, kHeight, flatray::Coverage::rows);
    list.rows = 64;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const auto value = [&](std::size_t c) {
        return static_cast<float>(value_of_srgb(polygons[i].colour[c]) / value_of_srgb(255));
      };
      list.items[i].colour = {value(0), value(1), value(2), 1};
    }
    picture_ = flatray::render_linear(list, {});
    white_ = value_of_srgb(255);
  }

  /// Mean over all channels of the distance of sRGB values.
  template <class Pixel>
  double mean_difference(const Pixel& pixel, Value srgb_of_value) const {
    double sum = 0;
    const float* value = picture_.pixels.data();
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (const double shown : pixel(x, y))
          sum += std::abs(shown - srgb_of_value(white_ * static_cast<double>(*value++)));
    return sum / static_cast<double>(picture_.pixels.size());
  }

 private:
  flatray::LinearImage picture_;
  double white_ = 1;
};

}  // namespace bench
