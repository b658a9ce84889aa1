#include <algorithm>
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

}  // namespace

std::vector<std::byte> encode_hdr(const LinearImage& image) {
  // RGBE holds no negative light, no NaN, and nothing above 2^127.
  std::vector<float> light = image.pixels;
  for (float& value : light) value = value > 0 ? std::min(value, 0x1.fep126F) : 0;
  std::vector<std::byte> bytes;
  if (stbi_write_hdr_to_func(&append, &bytes, image.width, image.height, 3, light.data()) == 0)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace flatray
