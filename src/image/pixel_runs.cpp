#include "image/pixel_runs.h"

#include "image/develop_pixel.h"

namespace flatray {
namespace {

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

}  // namespace flatray
