#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "image/png.h"

#if FLATRAY_HAVE_LIBDEFLATE
#include <libdeflate.h>

namespace {

// What stb_image_write packs by in place of its own deflate; it frees the room.
unsigned char* pack(unsigned char* bytes, int size, int* packed_size, int) {
  constexpr int kLevel = 4;  // smaller files than those of stb_image_write, in less time
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> packer(
      libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
  if (!packer) return nullptr;
  const auto count = static_cast<std::size_t>(size);
  const std::size_t room = libdeflate_zlib_compress_bound(packer.get(), count);
  void* packed = std::malloc(room);
  if (packed == nullptr) return nullptr;
  const std::size_t written = libdeflate_zlib_compress(packer.get(), bytes, count, packed, room);
  *packed_size = static_cast<int>(written);
  return static_cast<unsigned char*>(packed);
}

}  // namespace

#define STBIW_ZLIB_COMPRESS pack
#endif
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace flatray::stb_encoder {
namespace {

void append(void* bytes, void* data, int size) {
  const auto* begin = static_cast<const std::byte*>(data);
  auto& all = *static_cast<std::vector<std::byte>*>(bytes);
  all.insert(all.end(), begin, begin + size);
}

std::vector<std::byte> encode(const Image& image, unsigned, const RowsChanged&, PngBands&) {
  std::vector<std::byte> bytes;
  if (stbi_write_png_to_func(&append, &bytes, image.width, image.height, image.channels,
                             image.pixels.data(), image.width * image.channels) == 0)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace

extern const PngWriter entry = {
    "stb", "by stb_image_write, for builds without own: small, and slower", &encode};

}  // namespace flatray::stb_encoder
