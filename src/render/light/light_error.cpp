#include "render/light/light_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "image/srgb.h"

namespace flatray {
namespace {

// Student's t of 95 % with one degree of freedom less than there are scrambles, which are of kScrambles.
double student_t(std::size_t scrambles) {
  constexpr double kOfScrambles[] = {2.131449545559323, 2.0395134463964077, 1.9983405425207412};
  for (std::size_t i = 0; i < std::size(kScrambles); ++i)
    if (kScrambles[i] == scrambles) return kOfScrambles[i];
  unreachable();
}

// A line adds less to a pixel: image/light_film.cpp.
constexpr std::int64_t kMostOfLine = 92'686;

struct Spread {
  double mean, error;  // standard error of the mean
};

// Of what `value(sums)` gives for each scramble.
template <class Value>
Spread spread_of(ScrambleSums sums, const Value& value) {
  const auto count = static_cast<double>(sums.size());
  double mean = 0, squares = 0;
  for (const auto& one : sums) mean += value(one);
  mean /= count;
  for (const auto& one : sums) squares += (value(one) - mean) * (value(one) - mean);
  return {mean, std::sqrt(squares / (count - 1) / count)};
}

Spread luminance(ScrambleSums sums, std::size_t pixel) {
  return spread_of(sums, [pixel](const std::vector<std::int64_t>& one) {
    const std::int64_t* rgb = &one[3 * pixel];
    return 0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
           0.0722 * static_cast<double>(rgb[2]);
  });
}

bool too_few_rays(ScrambleSums sums, std::size_t pixel) {
  std::int64_t most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    std::int64_t of_channel = 0;
    for (const auto& one : sums) of_channel += one[3 * pixel + c];
    most = std::max(most, of_channel);
  }
  return most < kFewestRays * kMostOfLine;
}

}  // namespace

std::optional<double> relative_error(ScrambleSums sums) {
  double light = 0, error = 0;
  for (std::size_t pixel = 0; pixel < sums.front().size() / 3; ++pixel) {
    const Spread spread = luminance(sums, pixel);
    light += spread.mean, error += spread.error;
  }
  return light > 0 ? std::optional(error / light) : std::nullopt;
}

LinearImage error_image(ScrambleSums sums, double film_unit, int width, int height) {
  const double t = student_t(sums.size());
  LinearImage image{width, height, {}};
  image.pixels.reserve(sums.front().size());
  for (std::size_t i = 0; i < sums.front().size(); ++i) {
    const Spread spread = spread_of(
        sums, [i](const std::vector<std::int64_t>& one) { return static_cast<double>(one[i]); });
    const double half = std::min(t * spread.error * film_unit,
                                 static_cast<double>(std::numeric_limits<float>::max()));
    image.pixels.push_back(too_few_rays(sums, i / 3) ? std::numeric_limits<float>::quiet_NaN()
                                                     : static_cast<float>(half));
  }
  return image;
}

Image shown_error(ScrambleSums sums, int width, int height) {
  const double t = student_t(sums.size());
  Image image(width, height, 4);
  for (std::size_t pixel = 0; pixel < sums.front().size() / 3; ++pixel) {
    if (too_few_rays(sums, pixel)) continue;
    const Spread spread = luminance(sums, pixel);
    const double part = std::min(t * spread.error / spread.mean, 1.0);
    std::uint8_t* rgba = &image.pixels[4 * pixel];
    std::fill_n(rgba, 3, srgb_from_linear(static_cast<float>(part)));
    rgba[3] = 255;
  }
  return image;
}

}  // namespace flatray
