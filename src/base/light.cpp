#include "base/light.h"

#include <array>

#include "base/portable_math.h"

namespace flatray {

double light_of(double value) {
  const double v = value / 255;
  return v <= 0.04045 ? v / 12.92 : portable::pow((v + 0.055) / 1.055, 2.4);
}

float linear_from_srgb(std::uint8_t value) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> light;
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] = static_cast<float>(light_of(static_cast<double>(i)));
    return light;
  }();
  return table[value];
}

}  // namespace flatray
