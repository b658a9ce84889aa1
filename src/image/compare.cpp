#include "image/compare.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/check.h"
#include "base/portable_math.h"

namespace flatray {
namespace {

std::string layout(const Image& image) {
  return fmt::format("{} x {} {}", image.width, image.height, image.channels == 4 ? "RGBA" : "RGB");
}

// Sums of levels and their squares as integers: no order, no rounding.
struct Sums {
  std::uint64_t absolute = 0, square = 0;
};

void add_pixel(const std::uint8_t* actual, const std::uint8_t* expected, int channels, int x, int y,
               Difference& all, Sums& sums) {
  ++all.pixels;
  for (int c = 0; c < channels; ++c) {
    const int gap = std::abs(actual[c] - expected[c]);
    sums.absolute += static_cast<std::uint64_t>(gap);
    sums.square += static_cast<std::uint64_t>(gap * gap);
    if (gap <= all.worst) continue;
    all.worst = gap;
    all.x = x, all.y = y;
    all.channel = c, all.actual = actual[c], all.expected = expected[c];
  }
}

double decibels(double mean_square) {
  if (mean_square == 0) return std::numeric_limits<double>::infinity();
  return 10 * portable::log(255.0 * 255.0 / mean_square) / portable::log(10);
}

}  // namespace

Result<Difference> compare(const Image& actual, const Image& expected) {
  if (layout(actual) != layout(expected))
    return fail(
        {},
        fmt::format("pictures differ in layout: {} against {}", layout(actual), layout(expected)),
        "compare pictures of one size and channel count");
  Difference all;
  Sums sums;
  const auto channels = static_cast<std::size_t>(actual.channels);
  for (int y = 0; y < actual.height; ++y) {
    const std::uint8_t *a = actual.at(0, y), *b = expected.at(0, y);
    if (std::equal(a, a + channels * static_cast<std::size_t>(actual.width), b)) continue;
    for (int x = 0; x < actual.width; ++x, a += channels, b += channels)
      if (!std::equal(a, a + channels, b)) add_pixel(a, b, actual.channels, x, y, all, sums);
  }
  const auto count = static_cast<double>(actual.pixels.size());
  const double mean_square = static_cast<double>(sums.square) / count;
  all.mean = static_cast<double>(sums.absolute) / count;
  all.rmse = std::sqrt(mean_square);
  all.psnr = decibels(mean_square);
  return all;
}

Image difference_image(const Image& actual, const Image& expected, int gain) {
  FLATRAY_CHECK(layout(actual) == layout(expected));
  Image shown(actual.width, actual.height, 3);
  for (int y = 0; y < actual.height; ++y)
    for (int x = 0; x < actual.width; ++x) {
      const std::uint8_t *a = actual.at(x, y), *b = expected.at(x, y);
      const int alpha = actual.channels == 4 ? std::abs(a[3] - b[3]) : 0;
      for (int c = 0; c < 3; ++c)
        shown.at(x, y)[c] = static_cast<std::uint8_t>(
            std::clamp(gain * std::max(std::abs(a[c] - b[c]), alpha), 0, 255));
    }
  return shown;
}

}  // namespace flatray
