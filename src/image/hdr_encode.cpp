#include <algorithm>
#include <cmath>
#include <new>

#include "image/hdr.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace flatray {
namespace {

void append(void* bytes, void* data, int size) {
  const auto* begin = static_cast<const std::byte*>(data);
  auto& all = *static_cast<std::vector<std::byte>*>(bytes);
  all.insert(all.end(), begin, begin + size);
}

// stb cuts mantissas off: of light that is a whole number of units of its pixel's exponent it loses nothing.
void round_pixel(float* rgb) {
  const float most = std::max({rgb[0], rgb[1], rgb[2]});
  if (most < 0x1p-128F) {  // of which no unit is a float; stb makes black of more
    std::fill_n(rgb, 3, 0.0F);
    return;
  }
  int exponent = 0;
  std::frexp(most, &exponent);
  float unit = std::ldexp(1.0F, exponent - 8);
  if (std::nearbyint(most / unit) == 256) unit *= 2;
  for (int c = 0; c < 3; ++c) rgb[c] = std::nearbyint(rgb[c] / unit) * unit;
}

}  // namespace

std::vector<std::byte> encode_hdr(const LinearImage& image) {
  // RGBE holds no negative light, no NaN, and nothing above 2^127.
  std::vector<float> light = image.pixels;
  for (float& value : light) value = value > 0 ? std::min(value, 0x1.fep126F) : 0;
  for (std::size_t i = 0; i < light.size(); i += 3) round_pixel(&light[i]);
  std::vector<std::byte> bytes;
  if (stbi_write_hdr_to_func(&append, &bytes, image.width, image.height, 3, light.data()) == 0)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace flatray
