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

Light& Light::operator+=(const Light& other) {
  r += other.r;
  g += other.g;
  b += other.b;
  return *this;
}

Light hue(double turn) {
  const double h = 6 * (turn - std::floor(turn));
  return {clamped(std::fabs(h - 3) - 1), clamped(2 - std::fabs(h - 2)),
          clamped(2 - std::fabs(h - 4))};
}

Light nth_colour(std::size_t n) {
  // Okabe and Ito, Color Universal Design, 2008, neighbours far apart.
  constexpr std::array<std::array<std::uint8_t, 3>, 7> kFirst = {{{0x56, 0xb4, 0xe9},
                                                                  {0xcc, 0x79, 0xa7},
                                                                  {0xf0, 0xe4, 0x42},
                                                                  {0x00, 0x9e, 0x73},
                                                                  {0xd5, 0x5e, 0x00},
                                                                  {0x00, 0x72, 0xb2},
                                                                  {0xe6, 0x9f, 0x00}}};
  if (n < kFirst.size())
    return {linear_from_srgb(kFirst[n][0]), linear_from_srgb(kFirst[n][1]),
            linear_from_srgb(kFirst[n][2])};
  Light light = hue(0.58 + kGoldenSection * static_cast<double>(n));
  light += Light{0.08, 0.08, 0.08};
  return light;
}

Light heat(double level) {
  return {clamped(3 * level), clamped(3 * level - 1), clamped(3 * level - 2)};
}

Light hue_of(const Vec2& direction) {
  return hue(portable::atan2(direction.y(), direction.x()) / kTurn);
}

void set_pixel(Image& image, int x, int y, const Light& light) {
  std::uint8_t* pixel = image.at(x, y);
  pixel[0] = srgb_from_linear(static_cast<float>(light.r));
  pixel[1] = srgb_from_linear(static_cast<float>(light.g));
  pixel[2] = srgb_from_linear(static_cast<float>(light.b));
}

std::string hex(const Light& light) {
  Image pixel(1, 1, 3);
  set_pixel(pixel, 0, 0, light);
  return fmt::format("#{:02x}{:02x}{:02x}", pixel.pixels[0], pixel.pixels[1], pixel.pixels[2]);
}

ExperimentResult::File png_file(const std::string& name, const Image& image, unsigned threads) {
  const std::vector<std::byte> bytes = encode_png(image, threads);
  return {name, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
}

}  // namespace flatray
