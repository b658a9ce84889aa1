#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/philox.h"
#include "render/draw_list.h"

namespace bench {

/// A convex polygon in film coordinates with its colour, as every contender gets it.
struct Polygon {
  std::vector<flatray::Vec2> corners;
  std::array<std::uint8_t, 3> colour;  ///< sRGB
};

/// `count` polygons of 3 to 8 corners on ellipses of any direction, their area together about twice
/// the frame's.
inline std::vector<Polygon> polygons(int count, int width, int height) {
  using flatray::random_bits;
  using flatray::Stream;
  using flatray::unit_double;
  std::vector<Polygon> all;
  const double mean_area = 2.0 * width * height / count;
  for (int i = 0; i < count; ++i) {
    std::uint32_t draws = 0;
    const auto draw = [&](double low, double high) {
      const auto bits = random_bits(1, Stream::experiment, 0, static_cast<unsigned>(i), draws++);
      return low + (high - low) * unit_double(bits);
    };
    const int n = 3 + static_cast<int>(draw(0, 6));
    const flatray::Vec2 centre(draw(0, width), draw(0, height));
    const double turn = draw(0, 2 * std::numbers::pi), stretch = draw(0.6, 1.6);
    const double step = 2 * std::numbers::pi / n;
    const double unit_area = 0.5 * n * std::sin(step);
    const double radius = std::sqrt(mean_area * draw(0.5, 1.5) / unit_area);
    Polygon polygon;
    for (int k = 0; k < n; ++k) {
      const double angle = turn + step * k;
      polygon.corners.emplace_back(centre.x() + radius * stretch * std::cos(angle),
                                   centre.y() + radius / stretch * std::sin(angle));
    }
    for (auto& channel : polygon.colour) channel = static_cast<std::uint8_t>(draw(0, 256));
    all.push_back(std::move(polygon));
  }
  return all;
}

}  // namespace bench
