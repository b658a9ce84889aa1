#include "image/compare.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>

#include "base/check.h"
#include "base/portable_math.h"
#include "image/hdr.h"

namespace flatray {
namespace {

std::string layout(const Image& image) {
  return fmt::format("{} x {} {}", image.width, image.height, image.channels == 4 ? "RGBA" : "RGB");
}
std::string layout(const LinearImage& image) {
  return fmt::format("{} x {} light", image.width, image.height);
}

template <class Picture>
Result<void> expect_one_layout(const Picture& actual, const Picture& expected) {
  if (layout(actual) == layout(expected)) return {};
  return fail(
      {}, fmt::format("pictures differ in layout: {} against {}", layout(actual), layout(expected)),
      "compare pictures of one size and channel count");
}

// Whole levels have exact sums.
struct Sums {
  double absolute = 0, square = 0;
};

double gap(std::uint8_t actual, std::uint8_t expected) { return std::abs(actual - expected); }
double gap(float actual, float expected) {
  if (actual == expected || (std::isnan(actual) && std::isnan(expected))) return 0;
  const double gap = std::abs(static_cast<double>(actual) - static_cast<double>(expected));
  return std::isnan(gap) ? std::numeric_limits<double>::infinity() : gap;
}

template <class Number>
void add_pixel(const Number* actual, const Number* expected, int channels, int x, int y,
               Difference& all, Sums& sums) {
  bool differs = false;  // and not in bits alone, as 0 from -0
  for (int c = 0; c < channels; ++c) {
    const double found = gap(actual[c], expected[c]);
    sums.absolute += found;
    sums.square += found * found;
    differs |= found > 0;
    if (found <= all.worst) continue;
    all.worst = found;
    all.x = x, all.y = y;
    all.channel = c;
    all.actual = static_cast<double>(actual[c]), all.expected = static_cast<double>(expected[c]);
  }
  all.pixels += differs ? 1 : 0;
}

double decibels(double mean_square, double most) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (mean_square == 0) return kInfinity;
  if (most == 0 || mean_square == kInfinity) return -kInfinity;
  return 10 * portable::log(most * most / mean_square) / portable::log(10);
}

template <class Number>
Difference compared(std::span<const Number> actual, std::span<const Number> expected, int width,
                    int channels, double most) {
  Difference all;
  Sums sums;
  const auto step = static_cast<std::size_t>(channels);
  all.of = actual.size() / step;
  const std::size_t row = step * static_cast<std::size_t>(width);
  for (std::size_t begin = 0; begin < actual.size(); begin += row) {
    const auto a = actual.subspan(begin, row), b = expected.subspan(begin, row);
    if (std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) continue;
    for (std::size_t i = 0; i < row; i += step)
      if (std::memcmp(&a[i], &b[i], step * sizeof(Number)) != 0)  // NaN, too
        add_pixel(&a[i], &b[i], channels, static_cast<int>(i / step), static_cast<int>(begin / row),
                  all, sums);
  }
  const auto count = static_cast<double>(actual.size());
  all.mean = sums.absolute / count;
  all.rmse = std::sqrt(sums.square / count);
  all.psnr = decibels(sums.square / count, most);
  return all;
}

}  // namespace

Result<Difference> compare(const Image& actual, const Image& expected) {
  if (auto alike = expect_one_layout(actual, expected); !alike) return fail(std::move(alike));
  return compared<std::uint8_t>(actual.pixels, expected.pixels, actual.width, actual.channels, 255);
}

Result<Difference> compare(const LinearImage& actual, const LinearImage& expected) {
  if (auto alike = expect_one_layout(actual, expected); !alike) return fail(std::move(alike));
  float most = 0;
  for (const float light : expected.pixels)
    if (std::isfinite(light)) most = std::max(most, light);
  return compared<float>(actual.pixels, expected.pixels, actual.width, 3,
                         static_cast<double>(most));
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

Image difference_image(const LinearImage& actual, const LinearImage& expected, int gain) {
  FLATRAY_CHECK(layout(actual) == layout(expected));
  double sum = 0;
  for (const float light : expected.pixels)
    if (std::isfinite(light)) sum += static_cast<double>(std::abs(light));
  const double mean = sum / static_cast<double>(expected.pixels.size());
  LinearImage shown{actual.width, actual.height, {}};
  shown.pixels.reserve(actual.pixels.size());
  for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
    const double found = gap(actual.pixels[i], expected.pixels[i]);
    shown.pixels.push_back(found * gain < mean ? static_cast<float>(found * gain / mean)
                           : found > 0         ? 1.0F
                                               : 0.0F);
  }
  return develop(shown);
}

}  // namespace flatray
