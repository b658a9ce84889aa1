#include "study/plots/palette.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/light.h"
#include "base/portable_math.h"
#include "image/png.h"
#include "image/srgb.h"

namespace flatray {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2, kGoldenSection = 0.61803398874989485;

double clamped(double x) { return std::clamp(x, 0.0, 1.0); }

}  // namespace

LinearRgb& LinearRgb::operator+=(const LinearRgb& other) {
  r += other.r;
  g += other.g;
  b += other.b;
  return *this;
}

LinearRgb hue(double turn) {
  const double h = 6 * (turn - std::floor(turn));
  return {clamped(std::fabs(h - 3) - 1), clamped(2 - std::fabs(h - 2)),
          clamped(2 - std::fabs(h - 4))};
}

LinearRgb nth_colour(std::size_t n) {
  // Okabe and Ito, Color Universal Design, 2008, neighbours far apart.
  constexpr std::array kFirst = {"#56b4e9", "#cc79a7", "#f0e442", "#009e73",
                                 "#d55e00", "#0072b2", "#e69f00"};
  if (n < kFirst.size()) return light_of_hex(kFirst[n]);
  LinearRgb light = hue(0.58 + kGoldenSection * static_cast<double>(n));
  light += LinearRgb{0.08, 0.08, 0.08};
  return light;
}

LinearRgb heat(double level) {
  return {clamped(3 * level), clamped(3 * level - 1), clamped(3 * level - 2)};
}

LinearRgb hue_of(const Vec2& direction) {
  return hue(portable::atan2(direction.y(), direction.x()) / kTurn);
}

Image image_of(int width, int height, const std::function<LinearRgb(std::size_t)>& light) {
  Image image(width, height, 3);
  for (std::size_t i = 0; 3 * i < image.pixels.size(); ++i) {
    const LinearRgb one = light(i);
    std::size_t part = 3 * i;
    for (const double level : {one.r, one.g, one.b})
      image.pixels[part++] = srgb_from_linear(static_cast<float>(level));
  }
  return image;
}

std::string hex(const LinearRgb& light) {
  const Image pixel = image_of(1, 1, [&](std::size_t) { return light; });
  return fmt::format("#{:02x}{:02x}{:02x}", pixel.pixels[0], pixel.pixels[1], pixel.pixels[2]);
}

LinearRgb light_of_hex(const std::string& hex) {
  const auto part = [&](std::size_t at) -> double {
    return light_of(static_cast<double>(std::stoul(hex.substr(at, 2), nullptr, 16)));
  };
  return {part(1), part(3), part(5)};
}

ExperimentResult::File png_file(const std::string& name, const Image& image, unsigned threads) {
  const std::vector<std::byte> bytes = encode_png(image, threads);
  return {name, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
}

}  // namespace flatray
