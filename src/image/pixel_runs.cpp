#include "image/pixel_runs.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "image/srgb_encoder.h"

namespace flatray {
namespace {

// Nearest of 256 levels, halves up; exact, as a float times 255 fits a double.
std::uint8_t level(float share) {
  const double levels = 255.0 * static_cast<double>(share) + 0.5;
  return static_cast<std::uint8_t>(levels > 0 ? std::min(levels, 255.0) : 0.0);
}

using Rgb = std::array<std::uint8_t, 3>;

// Written out: the three hide each other's latency.
Rgb encode_light(const SrgbEncoder& encode, float r, float g, float b) {
  return {encode(r), encode(g), encode(b)};
}

// Over an opaque background.
struct Opaque {
  static constexpr int kChannels = 3;
  static void pixel(const float* rgba, const SrgbEncoder& encode, std::uint8_t* out) {
    const Rgb rgb = encode_light(encode, rgba[0], rgba[1], rgba[2]);
    std::memcpy(out, rgb.data(), rgb.size());
  }
};

// Straight alpha.
struct Straight {
  static constexpr int kChannels = 4;
  static void pixel(const float* rgba, const SrgbEncoder& encode, std::uint8_t* out) {
    const float alpha = rgba[3];
    const std::uint8_t shown = level(alpha);
    const Rgb rgb = shown == 0
                        ? Rgb{}
                        : encode_light(encode, rgba[0] / alpha, rgba[1] / alpha, rgba[2] / alpha);
    std::memcpy(out, rgb.data(), rgb.size());
    out[3] = shown;
  }
};

// Twelve bytes are whole pixels of either kind.
ShownColour repeated(std::uint64_t pixel, int channels) {
  std::uint64_t bytes[2] = {pixel | pixel << 32, pixel};
  if (channels == 3) {
    bytes[0] = pixel | pixel << 24 | pixel << 48;
    bytes[1] = pixel >> 16 | pixel << 8;
  }
  ShownColour colour;
  for (std::size_t i = 0; i < ShownColour::kBytes; i += 12)
    std::memcpy(colour.bytes + i, bytes, 12);
  return colour;
}

std::uint64_t joined(const std::uint8_t* bytes, int count) {
  std::uint64_t pixel = 0;
  for (int i = 0; i < count; ++i) pixel |= std::uint64_t{bytes[i]} << (8 * i);
  return pixel;
}

template <class Kind>
void put_pixels_as(std::span<const Light> colours, std::span<const std::uint32_t> places,
                   std::uint8_t* first) {
  const SrgbEncoder& encode = SrgbEncoder::get();
  for (std::size_t i = 0; i < colours.size(); ++i)
    Kind::pixel(colours[i].data(), encode, first + std::size_t{Kind::kChannels} * places[i]);
}

}  // namespace

ShownColour shown_colour(const Light& light, int channels) {
  const SrgbEncoder& encode = SrgbEncoder::get();
  std::uint8_t pixel[4] = {};
  if (channels == 3)
    Opaque::pixel(light.data(), encode, pixel);
  else
    Straight::pixel(light.data(), encode, pixel);
  return repeated(joined(pixel, channels), channels);
}

void put_pixels(std::span<const Light> colours, std::span<const std::uint32_t> places, int channels,
                std::uint8_t* first) {
  if (channels == 3)
    put_pixels_as<Opaque>(colours, places, first);
  else
    put_pixels_as<Straight>(colours, places, first);
}

void put_rows(std::span<const Light> colours, int width, int x, int y, Image& out) {
  std::vector<std::uint32_t> places(static_cast<std::size_t>(width));
  std::iota(places.begin(), places.end(), 0U);
  for (; !colours.empty(); colours = colours.subspan(places.size()), ++y)
    put_pixels(colours.first(places.size()), places, out.channels, out.at(x, y));
}

void put_rows(std::span<const Light> colours, int width, int x, int y, LinearImage& out) {
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const std::ptrdiff_t pixel = (y + at / width) * out.width + x + at % width;
    std::copy_n(colours[i].data(), 3, out.pixels.begin() + 3 * pixel);
  }
}

}  // namespace flatray
