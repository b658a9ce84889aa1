#include "render/layer.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

std::ptrdiff_t index_of(int x, int y, const kernels::Target& target) {
  return 4 * (static_cast<std::ptrdiff_t>(y - target.y) * target.width + (x - target.x));
}

}  // namespace

PixelBox pixels_around(const Bounds& bounds, const PixelBox& box) {
  const auto within = [](double v, int low, int size) {
    return static_cast<int>(std::clamp<double>(v, low, low + size));
  };
  const int left = within(std::floor(bounds.low.x()), box.x, box.width);
  const int top = within(std::floor(bounds.low.y()), box.y, box.height);
  const int right = within(std::ceil(bounds.high.x()), box.x, box.width);
  const int bottom = within(std::ceil(bounds.high.y()), box.y, box.height);
  return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

void Layer::clear(const kernels::Target& band, const PixelBox& part, int rows) {
  x_ = band.x, y_ = band.y, width_ = band.width;
  rgba_.resize(4 * static_cast<std::size_t>(band.width) * static_cast<std::size_t>(rows));
  for (int y = part.y; y < part.y + part.height; ++y)
    std::fill_n(rgba_.data() + index_of(part.x, y, target()), 4 * part.width, 0.0F);
}

void Layer::lay_over(const kernels::Target& band, const PixelBox& part, float opacity) const {
  for (int y = part.y; y < part.y + part.height; ++y) {
    const float* from = rgba_.data() + index_of(part.x, y, band);
    float* to = band.rgba + index_of(part.x, y, band);
    for (int x = 0; x < part.width; ++x, from += 4, to += 4) {
      const float keep = 1 - from[3] * opacity;
      for (int i = 0; i < 4; ++i) to[i] = from[i] * opacity + to[i] * keep;
    }
  }
}

}  // namespace flatray
