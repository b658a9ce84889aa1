#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "base/check.h"
#include "image/hdr.h"
#include "image/png.h"

#ifdef FLATRAY_HAVE_LIBDEFLATE
#include <libdeflate.h>

// stb_image_write's hook: a malloc'ed zlib stream. Level 6 is faster than level 1 on flat frames.
static unsigned char* deflate_for_stb(unsigned char* data, int size, int* packed_size, int) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> packer(
      libdeflate_alloc_compressor(6), &libdeflate_free_compressor);
  if (!packer) return nullptr;
  const auto bytes = static_cast<std::size_t>(size);
  const std::size_t room = libdeflate_zlib_compress_bound(packer.get(), bytes);
  auto* packed = static_cast<unsigned char*>(std::malloc(room));
  if (packed == nullptr) return nullptr;
  *packed_size =
      static_cast<int>(libdeflate_zlib_compress(packer.get(), data, bytes, packed, room));
  return packed;
}
#define STBIW_ZLIB_COMPRESS deflate_for_stb
#endif

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace flatray {
namespace {

// Every row the difference to the row above: docs/adr/0007-png-writer.md. Set before main, only
// read later.
[[maybe_unused]] const int kRowFilter = stbi_write_force_png_filter = 2;

void append(void* bytes, void* data, int size) {
  const auto* begin = static_cast<const std::byte*>(data);
  auto& all = *static_cast<std::vector<std::byte>*>(bytes);
  all.insert(all.end(), begin, begin + size);
}

}  // namespace

std::vector<std::byte> encode_png(const Image& image) {
  std::vector<std::byte> bytes;
  if (stbi_write_png_to_func(&append, &bytes, image.width, image.height, image.channels,
                             image.pixels.data(), image.width * image.channels) == 0)
    throw std::bad_alloc();  // the one way it fails
  return bytes;
}

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
